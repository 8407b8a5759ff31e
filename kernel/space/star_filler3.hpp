// Filling a cavity of a tetrahedralization with the star of a new vertex. Used by Delaunay3.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/triangulation3.hpp"

namespace wellspaced {

/// Fills cavities. It owns the scratch space for that: 4 bytes a vertex, and lists as long as the
/// largest cavity.
class StarFiller3 {
 public:
  /// Makes room for vertices below `count`.
  void reserve_vertices(std::size_t count) { number_of_vertex_.resize(count + 1); }

  /// Replaces the tets of `cavity` by those that join `apex` to its rim. The new tet on rim facet r
  /// has the number cavity.tets[r] and the vertices of the tet inside, with the apex in place of
  /// the corner off the facet. Tets listed behind those are dead then: nothing links to them.
  /// Requires: the rim is a closed surface around the cavity; room for its vertices; cavity.tets
  /// lists the tets of the cavity, and then others that are not in use until there is one for each
  /// facet of the rim.
  /// Cost: expected linear in the rim.
  void fill(Triangulation3& topology, Triangulation3::Cavity& cavity, Index apex);

 private:
  using RimFacet = Triangulation3::RimFacet;

  void number_rim_vertices(std::span<const RimFacet> rim);
  template <class Table>
  void join(Triangulation3& topology, const Triangulation3::Cavity& cavity, Table table);

  // Every fill numbers its vertices on from where the one before ended, so that what earlier ones
  // left is told by being lower.
  std::vector<Index> number_of_vertex_;  // by vertex + 1, so that the ghost comes first
  Index next_number_ = 1;
  std::vector<std::array<Index, 3>> rim_slots_;  // of the three vertices of each rim facet
  std::vector<std::uint64_t> edge_keys_;
  std::vector<std::uint32_t> edge_links_;
};

}  // namespace wellspaced
