// What a level keeps of the theory: how far its nodes are from a maximal set without conflicts.
#pragma once

#include <cstddef>
#include <span>

#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// For the conflicts f(i) + f(j) > beta d_G(i, j), where f is the level's spacing function,
/// continued to all nodes of the finest mesh as its greatest 1-Lipschitz function.
///
/// conflicts: the pairs of the level's nodes, not both special, that are in conflict; conflict_max:
///   the largest (f(i) + f(j)) / (beta d_G(i, j)) of all such pairs within distance 2 f / beta,
///   above 1 where there are conflicts; 0 if no two are so near.
/// uncovered: the nodes of the finest mesh that are in conflict with no node of the level: each
///   could be added. uncovered_max: how much larger its f would have to be, at most, for a
///   conflict: the largest (beta d_G(i, j) - f(j)) / f(i) over all nodes i left out, j the level's
///   node that makes it least; above 1 where there are uncovered nodes.
struct SelectionCheck {
  std::size_t conflicts = 0, uncovered = 0;
  double conflict_max = 0, uncovered_max = 0;
};

/// Checks a level that was selected from the finest mesh. graph: of that mesh. level: its origin
/// and spacing are used, and its fixed points. A pair is in conflict only beyond what the rounding
/// of sums can explain.
/// progress: phase "measure".
/// Cost: two shortest-path computations in the finest mesh, and the nodes within 2 f / beta of each
/// node of the level.
/// See: Definitions 2.2.3 and 5.3.4; section 5.3.3.
SelectionCheck check_selection(const Graph& graph, const Level& level, double beta,
                               const Progress& progress = {});

}  // namespace wellspaced
