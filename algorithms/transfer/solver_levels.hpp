// What a person with a solver wants to know of a hierarchy.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/transfer/galerkin.hpp"
#include "wellspaced/algorithms/transfer/transfer.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A level as a solver sees it.
///
/// galerkin: the operator that the ones before and the transfers make.
/// intersection_max: triangles of the level before that a triangle meets, at most; none at level 0.
/// area_kept, perimeter_kept: by those of the finest level; 1 where that has none.
/// nodes_dropped: nodes of the level before that this one has not. nodes_displaced: of these, how
///   many are interpolated at another place than their own, and how far from it at most.
struct SolverLevel {
  OperatorSize galerkin;
  std::optional<std::size_t> intersection_max;
  double area_kept = 1, perimeter_kept = 1;
  std::size_t nodes_dropped = 0, nodes_displaced = 0;
  double displacement_max = 0;
};

/// transfers[k] joins levels k and k + 1. grid_complexity: the nodes of all levels by those of the
/// finest; operator_complexity: likewise the entries of the operators.
struct SolverHierarchy {
  std::vector<Transfer> transfers;
  std::vector<SolverLevel> levels;
  double grid_complexity = 1, operator_complexity = 1;
};

/// The transfers of a hierarchy, and what comes of them.
/// progress: phases "transfer" and "measure".
/// Requires: as `coarsen` makes hierarchies. Errors: as transfer_between(); kCancelled.
/// Cost: that of the transfers, of counting intersections and of operator_sizes().
Result<SolverHierarchy> prepare_for_solver(const Hierarchy& hierarchy,
                                           const Progress& progress = {});

}  // namespace wellspaced
