// What coarsen() refuses, and why.
#pragma once

#include <cstddef>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Whether a mesh is small enough, finite, and names nodes that exist. Errors: those of coarsen().
Status check_coarsening_mesh(const TriangleMesh& mesh);

/// Whether options are in their ranges and go together, for a mesh of so many nodes.
/// Errors: kUsage.
Status check_coarsening_options(const CoarseningOptions& options, std::size_t nodes);

}  // namespace wellspaced
