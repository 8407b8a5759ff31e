// The directed edges of a triangle mesh, for meshes that nobody has checked yet.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/radix_sort.hpp"

namespace wellspaced {

/// Every triangle (a, b, c) has the directed edges a -> b, b -> c and c -> a, and lies on their
/// left if it is counter-clockwise. In a mesh each directed edge belongs to one triangle at most.
///
/// Unlike CornerTable its cost does not depend on the degrees of the nodes.
/// Requires: 3 * triangles.size() < 2^32. Cost: linear, 32 bytes an edge while it is built.
class DirectedEdges {
 public:
  using Edge = std::array<Index, 2>;  ///< from, to

  explicit DirectedEdges(std::span<const std::array<Index, 3>> triangles);

  /// The triangle with the directed edge, kNoIndex if there is none.
  Index triangle_of(Index from, Index to) const;
  /// Whether some triangle has the edge in either direction.
  bool has_edge(Index a, Index b) const;

  /// Two triangles that both have the same directed edge: the first such edge, ascending.
  struct Conflict {
    Edge edge{};
    Index triangle = 0, other = 0;
  };
  std::optional<Conflict> find_conflict() const;

  /// The edges with a triangle on one side only, as that triangle directs them, ascending.
  std::vector<Edge> boundary() const;

 private:
  static Edge edge_of(const KeyedItem& item);

  std::vector<KeyedItem> edges_;  // key: from << 32 | to; item: the triangle
};

}  // namespace wellspaced
