// Which tetrahedra a new point removes from a Delaunay triangulation. Used by Delaunay3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/triangulation3.hpp"

namespace wellspaced {

/// Whether p lies strictly inside the circumsphere of tet t; for a ghost, strictly beyond its hull
/// facet, or on the facet's plane and strictly inside its circumcircle.
///
/// A point on the sphere is not in conflict. That breaks ties as if every point were lifted off
/// the paraboloid by an infinitesimal far greater than those of all points before it. So there is
/// one answer for cospherical points, given the order of insertion, and no flat tet: where p lies
/// on the plane of a facet it is inside both spheres through that facet, or inside neither.
/// See: Devillers and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations
/// (2011).
bool in_conflict(const Triangulation3& topology, std::span<const Point3> points, Index t, Point3 p);

/// Finds cavities. It owns the scratch space for that: a byte a tet, and lists as long as the
/// largest cavity.
class CavitySearch3 {
 public:
  /// Collects the tets in conflict with p and the rim around them, starting from `root`.
  /// Returns false, and leaves the cavity alone, if one of them is fenced off.
  /// Requires: the triangulation is Delaunay; root is in conflict with p.
  /// Cost: linear in the tets found and their neighbours.
  bool run(const Triangulation3& topology, std::span<const Point3> points, Index root, Point3 p,
           Triangulation3::Cavity& cavity);

  /// Fences off the tets with vertices of different regions.
  void fence_off_borders(const Triangulation3& topology,
                         std::span<const std::uint8_t> region_of_vertex);
  void remove_fence();
  bool is_fenced(Index t) const { return has(mark_[t], kFenced); }

 private:
  enum Mark : std::uint8_t { kUnknown = 0, kSeen = 1, kTaken = 2, kFenced = 4 };
  static bool has(Mark mark, Mark bit) { return (mark & bit) != 0; }
  static Mark both(Mark a, Mark b) { return static_cast<Mark>(a | b); }

  void meet_neighbors(const Triangulation3& topology);
  bool test_met(const Triangulation3& topology, std::span<const Point3> points, Point3 p);
  void collect_rim(const Triangulation3& topology, std::vector<Triangulation3::RimFacet>& rim);

  std::vector<Mark> mark_;          // all unknown between runs, but for fences
  std::vector<Index> taken_, met_;  // buffers of which the first n_... count
  std::size_t taken_count_ = 0, expanded_count_ = 0, met_count_ = 0, tested_count_ = 0;
  std::vector<std::uint32_t> rim_links_;
};

}  // namespace wellspaced
