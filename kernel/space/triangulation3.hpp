// The topology of a tetrahedralization: who neighbours whom. It knows no coordinates.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A tetrahedralization of space closed up to a 3-sphere: behind every hull facet lies a ghost
/// tet, whose corner 3 is the ghost vertex at infinity. So every tet has four neighbours, and no
/// operation has a special case for the hull.
///
/// Layout: 32 bytes a tet, four vertices and four links. The link opposite corner i is
/// neighbour << 2 | (number of the common facet in the neighbour), so that nothing is ever
/// searched for. Limit: kMaxTets. There are no dead tets: 0 .. size() - 1 are all in use.
///
/// Invariants (is_valid checks them): links are mutual, both sides of a facet name the same three
/// vertices, all tets are oriented alike, and a ghost vertex stands at corner 3.
class Triangulation3 {
 public:
  /// The vertex at infinity.
  static constexpr Index kGhost = kNoIndex;
  static constexpr Index kMaxTets = Index{1} << 30;

  /// Facet i of a tet, opposite its corner i. Dies when the tet is rewritten, by an insertion that
  /// touches it or that gives its number to another.
  struct Facet {
    Index tet = kNoIndex;
    unsigned i = 0;
    friend bool operator==(Facet, Facet) = default;
  };

  /// The number of tets, ghosts included.
  Index size() const { return static_cast<Index>(tets_.size()); }
  bool empty() const { return tets_.empty(); }

  Index vertex(Index t, unsigned i) const { return tets_[t].vertex[i]; }
  const std::array<Index, 4>& vertices(Index t) const { return tets_[t].vertex; }
  bool is_ghost(Index t) const { return tets_[t].vertex[3] == kGhost; }

  /// Which corner of tet t vertex v is. Requires: it is one.
  unsigned corner_of(Index t, Index v) const {
    const auto& corners = tets_[t].vertex;
    return corners[0] == v ? 0 : corners[1] == v ? 1 : corners[2] == v ? 2 : 3;
  }

  /// The links of a tet, packed as described above.
  const std::array<std::uint32_t, 4>& links(Index t) const { return tets_[t].link; }
  Index neighbor(Index t, unsigned i) const { return tets_[t].link[i] >> 2; }
  /// The same facet seen from the other side.
  Facet mirror(Facet f) const { return unpack(tets_[f.tet].link[f.i]); }
  /// The corner of the facet's tet that is not on the facet.
  Index apex(Facet f) const { return vertex(f.tet, f.i); }

  /// The corners of facet i, counter-clockwise seen from outside a positive tet.
  static constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetCorners{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  /// The vertices of a facet, in that order.
  std::array<Index, 3> vertices(Facet f) const {
    const auto& v = tets_[f.tet].vertex;
    const auto& c = kFacetCorners[f.i];
    return {v[c[0]], v[c[1]], v[c[2]]};
  }

  static constexpr std::uint32_t pack(Index t, unsigned i) { return t << 2 | i; }
  static constexpr Facet unpack(std::uint32_t link) { return {link >> 2, link & 3u}; }

  /// Whether the invariants hold. Cost: linear.
  bool is_valid() const;

  /// Asks the machine to have tet t at hand soon, and does nothing else.
  void prefetch([[maybe_unused]] Index t) const {
#if defined(__GNUC__)
    __builtin_prefetch(&tets_[t]);
#endif
  }

  // Operations on the topology; Delaunay3 decides where they keep the tetrahedralization embedded.

  /// A facet of a cavity's boundary: the vertices of the tet inside, which corner of it is off the
  /// facet, and the link to the facet in the tet outside.
  struct RimFacet {
    std::array<Index, 4> vertex;
    std::uint32_t outside;
    unsigned corner;
  };

  /// A cavity: a ball of tets without a vertex inside, and all facets of its boundary.
  struct Cavity {
    std::vector<Index> tets;
    std::vector<RimFacet> rim;
  };

  /// Starts afresh with tet (a, b, c, d) and its four ghosts.
  void reset(Index a, Index b, Index c, Index d);

  /// Makes room for so many tets.
  void reserve(std::size_t tets) { tets_.reserve(tets); }
  std::size_t capacity() const { return tets_.capacity(); }

  /// Adds tets that are yet to be written. Returns the number of the first.
  Index append(std::size_t count) {
    tets_.resize(tets_.size() + count);
    return static_cast<Index>(tets_.size() - count);
  }

  /// Removes tets that no other links to, by giving their numbers to the last ones. Sorts `dead`.
  void remove(std::span<Index> dead);

  /// Gives every vertex v but the ghost the number number[v].
  void renumber_vertices(const std::vector<Index>& number, unsigned threads = 1);

 private:
  friend class StarFiller3;

  struct alignas(32) Tet {
    std::array<Index, 4> vertex;
    std::array<std::uint32_t, 4> link;
  };

  std::vector<Tet> tets_;
};

}  // namespace wellspaced
