// Smoothing without moving a point: nodes of a level are exchanged for others of the finest mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "wellspaced/algorithms/coarsening/quality/editable_level.hpp"
#include "wellspaced/kernel/graph.hpp"

namespace wellspaced {

/// least_sine_sq: the squared sine of the angle that triangles should have at least.
/// least_nodes, most_nodes: how many nodes the level may have.
/// stays: one flag a node of the finest mesh: those that may not be taken away.
struct ExchangeGoals {
  double least_sine_sq = 0;
  std::size_t least_nodes = 0, most_nodes = 0;
  std::span<const std::uint8_t> stays;
};

/// For each triangle with too small an angle, the worst first, tries to take one of its nodes away,
/// to put a neighbour in the finest mesh in its place, or to add a node near the circumcentre; the
/// boundary's nodes too. Of all these the change that leaves the best worst triangle around it is
/// made, if that is better than the one at hand. Goes over the level until nothing changes, at most
/// 4 times.
/// graph: of the finest mesh. keep_going: asked before each triangle; false to stop.
/// Returns: the number of changes.
/// Cost: some 30 local edits for each such triangle, after a pass over all.
std::size_t exchange_nodes(const Graph& graph, EditableLevel& level, const ExchangeGoals& goals,
                           const std::function<bool()>& keep_going);

}  // namespace wellspaced
