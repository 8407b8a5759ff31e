// The corners of a triangle mesh, listed by node: from a node to the triangles around it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// For each node v the corners there of the triangles around it, in the order of the triangles.
/// The corner (next, previous) stands for the counter-clockwise triangle (v, next, previous).
struct CornerTable {
  struct Corner {
    Index next = 0, previous = 0;
    friend bool operator==(Corner, Corner) = default;
  };
  std::vector<Index> first;  ///< one a node and one more: corners of v are first[v] .. first[v+1]-1
  std::vector<Corner> corners;

  Index nodes() const { return static_cast<Index>(first.size()) - 1; }
  std::span<const Corner> at(Index v) const {
    return {corners.data() + first[v], corners.data() + first[v + 1]};
  }

  /// True when some triangle has the directed edge from v to `to`, the triangle on its left.
  bool has_edge(Index v, Index to) const;

  /// The far end of the boundary edge that follows the boundary edge u -> v: the fan of triangles
  /// on its left is turned through, clockwise about v, up to an edge v -> w without a triangle on
  /// its right. Where several boundary curves meet in v, this stays on the curve of u -> v.
  /// Requires: the triangle left of u -> v exists, none is on its right.
  /// Returns: w, or kNoIndex where the triangles around v do not make a fan (no valid mesh).
  Index next_boundary_node(Index u, Index v) const;
};

/// The corners of `triangles` over the nodes 0 .. nodes - 1.
/// Requires: every index < nodes; 3 * triangles.size() < 2^32. Cost: linear.
CornerTable corner_table(std::span<const std::array<Index, 3>> triangles, Index nodes);

/// The boundary edges: the directed edges (from, to) with a triangle on their left and none on
/// their right, ascending by `from`, then in the order of the triangles.
/// Cost: the sum of the squared degrees of the nodes.
std::vector<std::array<Index, 2>> boundary_edges(const CornerTable& table);

}  // namespace wellspaced
