// The three multilevel schemes of section 5.3.4: what each level is selected from.
#pragma once

#include <span>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/coarsening/source_mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The levels above `finest`, by the scheme of the options.
/// limit: see source_mesh(). skeleton: of the finest mesh.
/// Errors: those of coarsen_level but for cancellation, which leaves the hierarchy incomplete.
/// See: Figures 5.7, 5.8 and 5.9.
Result<Hierarchy> build_levels(Level finest, Skeleton skeleton, std::span<const double> limit,
                               const CoarseningOptions& options);

}  // namespace wellspaced
