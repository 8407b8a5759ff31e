// One step of coarsening: from a level to the next.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

struct CoarseningStep {
  Level level;                         ///< may have all nodes of the finer one
  std::optional<CoarseningWork> work;  ///< where the options ask for it
};

/// Builds the next coarser level out of a level: its boundary first, its nodes by the order and
/// rules of CHOICES 17.
/// finer: as `coarsen` makes them, or any valid level whose fixed points hold the anchors of its
///   boundary. skeleton: that of its mesh. level: the number of the level to build, >= 1.
/// tell: called with the name of each phase from "boundary" on; returns false to cancel.
/// Errors: kCancelled, and those of `coarsen`.
Result<CoarseningStep> coarsen_level(const Level& finer, const Skeleton& skeleton,
                                     std::size_t level, const CoarseningOptions& options,
                                     const std::function<bool(std::string_view)>& tell);

}  // namespace wellspaced
