// The boundary of a domain as simplices: what lies inside it, what it hides, how near it is.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The edges (D = 2) or triangles (D = 3) of a boundary, each with D nodes.
/// closed: whether the domain ends at the simplex, or continues on its other side.
/// inner: where it ends, a node on the side of the domain, near by.
template <std::size_t D>
struct BoundarySimplex {
  std::array<Index, D> nodes{};
  bool closed = true;
  Index inner = kNoIndex;
};

/// A place on a boundary, and how far it is from where it was looked for.
template <std::size_t D>
struct PlaceOnBoundary {
  Vec<D> place{};
  double distance = 0;
};

/// A boundary, ready for questions. Simplices that continue each other straight, within the
/// rounding of their nodes (2 units in the last place), belong to one piece: a segment or a face of
/// the domain, however finely it is meshed.
/// Requires: finite coordinates; the simplices with `closed` are the whole boundary of a domain.
template <std::size_t D>
class BoundaryPieces {
 public:
  BoundaryPieces(std::span<const Vec<D>> places, std::vector<BoundarySimplex<D>> simplices);

  std::size_t size() const { return simplices_.size(); }
  const std::array<Index, D>& nodes(Index s) const { return simplices_[s].nodes; }
  std::array<Vec<D>, D> corners(Index s) const;
  /// The normal of length 1 that points into the domain; none where that lies on both sides, or
  /// rounding does not tell.
  std::optional<Vec<D>> inward_normal(Index s) const;
  /// The piece of a simplex: the lowest of its simplices.
  Index piece(Index s) const { return piece_[s]; }

  /// Whether x lies in the domain or on its boundary. Exact. Cost: as many simplices as the ray
  /// from x along the first axis passes by.
  bool contains(const Vec<D>& x) const;
  /// Whether the closed segment from a to b touches no simplex. Exact.
  bool leaves_clear(const Vec<D>& a, const Vec<D>& b) const;
  /// Whether a simplex comes within this distance of x, in floating point.
  bool comes_near(const Vec<D>& x, double distance) const;

  /// The nearest place of the pieces that node v does not lie on, if it is below `bound`, else v
  /// and the bound. A piece whose nearest place lies behind the outside of the domain, as seen from
  /// v, is left out; the way there may run along the boundary.
  PlaceOnBoundary<D> nearest_elsewhere(Index v, double bound) const;

 private:
  void join_straight_ones();
  void list_pieces_of_nodes();
  bool lies_on(Index v, Index piece) const;
  bool starts_inside(const Vec<D>& x, const PlaceOnBoundary<D>& place) const;

  std::span<const Vec<D>> places_;
  std::vector<BoundarySimplex<D>> simplices_;
  std::vector<Index> piece_;
  std::vector<std::array<Index, 2>> node_pieces_;  // (node, piece), sorted
  std::vector<Box<static_cast<int>(D)>> boxes_;
  BoxTree<static_cast<int>(D)> tree_;
};

/// The place of a segment or triangle nearest to x, in floating point.
PlaceOnBoundary<2> nearest_place(const Vec<2>& x, const std::array<Vec<2>, 2>& segment);
PlaceOnBoundary<3> nearest_place(const Vec<3>& x, const std::array<Vec<3>, 3>& triangle);

/// A normal of length 1; not finite if the segment or triangle is degenerate.
Vec<2> unit_normal(const std::array<Vec<2>, 2>& segment);
Vec<3> unit_normal(const std::array<Vec<3>, 3>& triangle);

}  // namespace wellspaced::audit
