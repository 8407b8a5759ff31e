// The topology of a planar triangulation: who neighbours whom. It knows no coordinates.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A triangulation of the plane closed up to a sphere: every hull edge has a ghost triangle behind
/// it, whose third vertex is the ghost vertex at infinity. So every triangle has three neighbours,
/// and no operation has a special case for the hull.
///
/// Layout: 24 bytes a triangle, three vertices and three links. The link opposite corner i is
/// neighbour << 3 | constrained << 2 | (number of the common edge in the neighbour), so that
/// nothing is ever searched for. Limit: kMaxTriangles.
///
/// Invariants (is_valid checks them): links are mutual, both sides of an edge name the same two
/// vertices in opposite order, and both carry the same constrained flag.
class Triangulation2 {
 public:
  /// The vertex at infinity.
  static constexpr Index kGhost = kNoIndex;
  static constexpr Index kMaxTriangles = Index{1} << 29;

  /// Edge i of a triangle, opposite its corner i; it runs from corner i+1 to corner i+2, with the
  /// triangle on its left. Dies when the triangle is rewritten (by an insertion, removal or flip
  /// that touches it).
  struct Edge {
    Index triangle = kNoIndex;
    unsigned i = 0;
    friend bool operator==(Edge, Edge) = default;
  };

  /// i + 1 and i - 1 modulo 3, looked up two bits a value: no processor could guess a branch here.
  static constexpr unsigned next(unsigned i) { return 0b00'10'01u >> (2 * i) & 3u; }
  static constexpr unsigned previous(unsigned i) { return 0b01'00'10u >> (2 * i) & 3u; }

  /// The number of triangles, ghosts included.
  Index size() const { return static_cast<Index>(triangles_.size()); }
  bool empty() const { return triangles_.empty(); }

  Index vertex(Index t, unsigned i) const { return triangles_[t].vertex[i]; }
  const std::array<Index, 3>& vertices(Index t) const { return triangles_[t].vertex; }
  bool is_ghost(Index t) const {
    const auto& v = triangles_[t].vertex;
    return v[0] == kGhost || v[1] == kGhost || v[2] == kGhost;
  }

  /// Which corner of triangle t vertex v is. Requires: it is one.
  unsigned corner_of(Index t, Index v) const {
    const auto& corners = triangles_[t].vertex;
    return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
  }

  Index neighbor(Index t, unsigned i) const { return triangles_[t].link[i] >> 3; }
  /// The same edge seen from the other side.
  Edge mirror(Edge e) const {
    const std::uint32_t link = triangles_[e.triangle].link[e.i];
    return {link >> 3, link & 3u};
  }
  bool is_constrained(Edge e) const { return (triangles_[e.triangle].link[e.i] & 4u) != 0; }
  Index origin(Edge e) const { return vertex(e.triangle, next(e.i)); }
  Index destination(Edge e) const { return vertex(e.triangle, previous(e.i)); }
  /// The corner of the edge's triangle that is not on the edge.
  Index apex(Edge e) const { return vertex(e.triangle, e.i); }

  /// The next edge counter-clockwise that leaves the same origin. Repeating it runs through the
  /// star of the origin once, ghosts included.
  Edge next_around_origin(Edge e) const {
    const Edge inner{e.triangle, next(e.i)};         // runs from destination to apex
    return mirror({inner.triangle, next(inner.i)});  // apex to origin, seen from outside
  }

  /// Whether the invariants hold. Cost: linear.
  bool is_valid() const;

  // Operations on the topology; Delaunay2 decides where they keep the triangulation embedded.

  /// One edge of a hole's rim, on the rim's way counter-clockwise round the hole: the vertex where
  /// it starts, and the link to the edge in the triangle outside.
  struct RimEdge {
    Index origin;
    std::uint32_t outside;
  };
  static bool is_constrained_rim(RimEdge e) { return (e.outside & 4u) != 0; }

  /// Starts afresh with triangle (a, b, c) and its three ghosts.
  void reset(Index a, Index b, Index c);

  /// Replaces the k triangles of `hole` by the k + 2 triangles that join `apex` to `rim`. The
  /// triangle at rim[i] is hole[i], the last two are new; its corner 0 is the apex.
  /// Requires: the rim runs once round the hole.
  void fill_with_star(std::span<const Index> hole, std::span<const RimEdge> rim, Index apex);

  /// Replaces edge e by the other diagonal of the quadrilateral around it. Afterwards the two
  /// triangles are (apex, origin, opposite) = e.triangle and (opposite, destination, apex).
  /// Requires: e is not constrained.
  void flip(Edge e);

  /// The number of edges at the origin of e, ghosts included.
  std::size_t degree(Edge e) const;

  /// Replaces the three triangles around the origin of e by the one that they cover, in the first
  /// of their slots; the last triangles move into the other two. `moved` receives where from and
  /// where to.
  /// Requires: degree(e) == 3.
  Index merge_star(Edge e, std::vector<std::pair<Index, Index>>& moved);

  /// Appends triangle (a, b, c), still unlinked, and returns its number.
  Index add(Index a, Index b, Index c);

  /// Makes the two edges each other's mirror.
  void link(Edge e, Edge f, bool constrained);

  /// Moves the last slots.size() triangles into `slots`, whose triangles are given up.
  /// Requires: nothing links to the triangles given up.
  void move_into(std::span<const Index> slots);

  /// Marks both sides of an edge.
  void set_constrained(Edge e, bool constrained);

 private:
  friend class Delaunay2;

  struct Triangle {
    std::array<Index, 3> vertex;
    std::array<std::uint32_t, 3> link;
  };

  static constexpr std::uint32_t kConstrained = 4;
  void move(Index from, Index to);

  static constexpr std::uint32_t pack(Index t, unsigned i) { return t << 3 | i; }

  LargeVector<Triangle> triangles_;
};

}  // namespace wellspaced
