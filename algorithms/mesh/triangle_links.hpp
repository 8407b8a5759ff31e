// Who neighbours whom in a triangle mesh: across edges, and around nodes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// neighbor[t][i]: the triangle across the edge opposite corner i of triangle t, kNoIndex where
/// that edge is on the boundary of the domain.
class TriangleLinks {
 public:
  /// Requires: a mesh with valid indices, no degenerate or doubly used directed edge; at most 2^30
  /// triangles. Cost: linear for bounded degrees.
  TriangleLinks(std::span<const std::array<Index, 3>> triangles, Index nodes);

  Index neighbor(Index triangle, unsigned corner) const { return neighbors_[triangle][corner]; }

  /// The triangles around a node, ascending: none around a node of no triangle.
  std::span<const Index> around(Index node) const {
    return {around_.data() + first_[node], around_.data() + first_[node + 1]};
  }

 private:
  std::vector<std::array<Index, 3>> neighbors_;
  std::vector<Index> first_, around_;
};

}  // namespace wellspaced
