// One step of coarsening: from a level to the next.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/coarsening/source_mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

struct CoarseningStep {
  Level level;                         ///< may have all nodes of the finer one
  std::optional<CoarseningWork> work;  ///< where the options ask for it
};

/// What to build.
///
/// level: the number that the random order is drawn for, >= 1. factor: of the coarsened spacing.
/// forced: nodes of the source to select beside its fixed points (Lemma 5.3.6), ascending.
/// areas: those that the level's domain may have.
struct StepRequest {
  std::size_t level = 1;
  double factor = 1;
  std::span<const Index> forced;
  AreaRange areas = {};
};

/// ONE_LEVEL_COARSEN (Figure 5.6): builds a coarser level out of a mesh, its boundary first, its
/// nodes by the order and rules of CHOICES 17.
/// source: of a level as `coarsen` makes them, or any valid level whose fixed points hold the
///   anchors of its boundary.
/// tell: called with the name of each phase, and again and again in its course; returns false to
///   cancel, and from then on.
/// Errors: kCancelled, and those of `coarsen`.
Result<CoarseningStep> coarsen_level(const SourceMesh& source, const StepRequest& request,
                                     const CoarseningOptions& options,
                                     const std::function<bool(std::string_view)>& tell);

}  // namespace wellspaced
