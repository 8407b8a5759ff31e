// Shortest paths in a weighted graph, from many nodes at once.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// Shortest distances from a virtual source p* (Definition 7.2.1) that is joined to each node v by
/// an edge of length start[v]: the least start[u] + d_G(u, v) over all nodes u, where a path's
/// length is summed from u outwards, edge by edge.
/// start: one a node, >= 0, no NaN; infinite where p* is not joined to the node.
/// Returns: one a node; infinite where no path leads to.
/// Cost: O(n log n) at worst; where paths are short, or run along the numbering of the nodes, a few
///   passes over the graph in the order of its memory.
/// progress: phase "paths", in nodes looked at; how many there will be is not known.
/// See: section 7.2, Theorem 7.2.2.
std::vector<double> shortest_distances(const Graph& graph, std::span<const double> start,
                                       const Progress& progress = {});

/// The tree of shortest paths from p*.
struct ShortestPathTree {
  std::vector<Index> parent;  ///< the node before on the path; kNoIndex: p* itself, or no path
  std::vector<Index> depth;   ///< edges of the graph on the path: 0 where parent is kNoIndex
};

/// The paths behind shortest_distances(graph, start). Of paths of equal length, a node's own value
/// comes first, then the path over the nearest neighbour, then over the lowest in number: what
/// Dijkstra's algorithm finds when it settles nodes by distance, then by number.
/// Requires: distance == shortest_distances(graph, start).
/// Degenerate: a path over an edge too short to change the sum is not followed beyond it.
/// Cost: linear. See: section 8.4.1, CHOICES 14.
ShortestPathTree shortest_path_tree(const Graph& graph, std::span<const double> start,
                                    std::span<const double> distance);

}  // namespace wellspaced
