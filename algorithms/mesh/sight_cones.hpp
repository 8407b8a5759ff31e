// Sight spreads through a triangle mesh from a node, cone by cone.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/mesh/visibility.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Finds what nodes see, one node after the other in the same workspace.
///
/// The viewer looks through an edge within a cone between the directions of two nodes, which walls
/// or nodes on the way have made its limits. Triangles are taken from front to back, by the powers
/// of the viewer with respect to their circumcircles, and cones side by side that wait at the same
/// edge are joined: mostly an edge has one cone, and one more for each gap between walls that it is
/// seen through. In a Delaunay mesh that order is right; elsewhere a triangle may be taken more
/// than once, which costs time alone.
///
/// All decisions are exact: lines of sight are those of Visibility::sees().
/// Requires: the Visibility outlives the object. Memory: 4 bytes a triangle, 5 a node.
class SightCones {
 public:
  /// Whether sight goes on through the edge between two nodes.
  using Enters = std::function<bool(Index a, Index b)>;
  /// Told of a node that is seen, at least once.
  using Sees = std::function<void(Index node)>;

  explicit SightCones(const Visibility& visibility);

  /// Spreads sight from node p: around it, and on through the edges that `enters` admits.
  /// Cost: O(k log k) for k cones.
  void spread(Index p, const Enters& enters, const Sees& sees);

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // All directions from that of node `right` counter-clockwise to that of `left`; the one direction
  // where these are the same node.
  struct Cone {
    Index right = 0, left = 0;
  };
  // A cone at the edge of a triangle that is opposite its corner `apex`, where the edge runs from
  // left to right.
  struct Waiting {
    Cone cone;
    unsigned apex = 0;
    std::uint32_t next = kNone;  // of the same triangle
  };

  int side(Index through, Index v) const;
  double power(Index triangle) const;
  void look_around(const Enters& enters, const Sees& sees);
  void look_through(Index triangle, const Enters& enters, const Sees& sees);
  void look_past(Index triangle, const Waiting& waiting, const Enters& enters, const Sees& sees);
  void look_along(Index first, const Enters& enters, const Sees& sees);
  void pass(Index triangle, unsigned corner, Cone cone, const Enters& enters);
  bool joins(Index triangle, unsigned apex, Cone cone);

  const Visibility& visibility_;
  Index viewer_ = 0;
  std::vector<Index> curves_;  // of the boundary through each node
  std::vector<std::uint8_t> is_looked_along_;
  std::vector<Index> looked_along_;
  std::vector<std::uint32_t> first_waiting_;  // of each triangle
  std::vector<Waiting> cones_;
  std::vector<std::pair<double, Index>> triangles_;  // a heap of those where cones wait
};

}  // namespace wellspaced
