// What a node of a triangle mesh sees within a radius.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/algorithms/mesh/sight_cones.hpp"
#include "wellspaced/algorithms/mesh/visibility.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Collects what a node sees within a radius, one node after the other in the same workspace.
/// Requires: the Visibility outlives it. Memory: 8 bytes a node, 12 a triangle.
class SightSearch {
 public:
  explicit SightSearch(const Visibility& visibility);

  /// The nodes that node p sees within distance `radius`, itself included, each once.
  /// Valid until the next call.
  /// Cost: linear in the k triangles that the disc meets; where walls of the domain turn their
  /// back to p inside the disc, as SightCones has it: O(k log k) for few gaps between walls.
  std::span<const Index> run(Index p, double radius);

 private:
  void start(Index p, double radius);
  bool flood();
  bool visit(Index node);
  void enter_around(Index node);
  void enter(Index triangle);
  bool may_hide(Index a, Index b) const;
  bool edge_meets_disc(Index a, Index b) const;

  const Visibility& visibility_;
  SightCones cones_;
  Index viewer_ = 0;
  double radius_ = 0;
  std::vector<std::uint32_t> node_stamp_, triangle_stamp_;
  std::uint32_t stamp_ = 0;
  std::vector<Index> nodes_, triangles_;
};

}  // namespace wellspaced
