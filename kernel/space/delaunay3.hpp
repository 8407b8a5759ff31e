// Delaunay triangulation of space: exact, incremental, dynamic.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/space/bulk_insertion3.hpp"
#include "wellspaced/kernel/space/triangulation3.hpp"
#include "wellspaced/kernel/space/vertex_inserter3.hpp"

namespace wellspaced {

/// The Delaunay triangulation of the convex hull of its points, by the algorithm of Bowyer and
/// Watson.
///
/// Vertices are numbered as the input points are. A point with the coordinates of another (0 and -0
/// are equal) is no vertex: representative() names the one that stands for it, the lowest of them.
/// Points that span no volume are triangulated in what they span: dimension() says so.
///
/// Tet numbers die with every insertion; vertex numbers stay.
class Delaunay3 {
 public:
  using Facet = Triangulation3::Facet;

  struct Options {
    Progress progress = {};
    /// The most tets, ghosts included: n points can have n^2 of them, at 32 bytes each.
    Index max_tets = Triangulation3::kMaxTets;
    /// How many threads may work, the caller's among them; beyond eight none is used. The result
    /// does not depend on it, not even in the numbers of tets. 11 bytes a point for each after the
    /// first while building.
    unsigned threads = 1;
  };

  /// The Delaunay triangulation of `points`: exact for every finite double. Ties (cospherical
  /// points) are broken by the order of insertion, which depends on the points and their numbers
  /// alone; no tet is flat.
  /// Errors: kInvalidGeometry for a NaN or infinite coordinate (ids: the points); kLimit beyond
  /// 2^28 points or max_tets; kCancelled.
  /// Cost: O(n log n + tets) expected time for points in space of bounded density ratio, at worst
  /// O(n^2); 32 bytes a tet and 28 a point kept.
  static Result<Delaunay3> build(std::span<const Point3> points, const Options& options);
  static Result<Delaunay3> build(std::span<const Point3> points) { return build(points, {}); }

  /// -1: no point; 0: all points are equal; 1: all are collinear; 2: all are coplanar; 3.
  int dimension() const { return dimension_; }
  const std::vector<Point3>& points() const { return points_; }
  /// Empty below dimension 3.
  const Triangulation3& topology() const { return topology_; }
  /// The Delaunay triangles of coplanar points, all turning the same way; empty unless
  /// dimension() == 2.
  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
  /// Collinear points in lexicographic order, or the one point there is; empty unless dimension()
  /// is 0 or 1.
  const std::vector<Index>& chain() const { return chain_; }

  /// The vertex that stands for a point: itself unless it is a duplicate.
  Index representative(Index point) const {
    return representative_.empty() ? point : representative_[point];
  }
  std::size_t duplicate_count() const { return duplicate_count_; }

  /// Where a point lies. kOutside: strictly beyond the hull facet before a ghost.
  enum class Place { kTet, kFacet, kEdge, kVertex, kOutside };
  struct Location {
    Place place = Place::kOutside;
    Index tet = kNoIndex;
    /// Bit i: corner i of the tet is a corner of the facet, edge or vertex in which the point lies.
    unsigned corners = 0;
  };

  /// Where p lies. `hint` is a tet to start from (any number will do).
  /// Requires: dimension() == 3; p finite.
  /// Cost: O(n^(1/3)) expected from afar, O(1) from near by.
  Location locate(Point3 p, Index hint = 0) const;

  /// Some tet of vertex v; kNoIndex if v is a duplicate or dimension() < 3.
  Index tet_of(Index v) const { return tet_of_.empty() ? kNoIndex : tet_of_[v]; }

  /// Adds a point, whose number is the number of points there were. `hint` as for locate.
  /// Returns the vertex that stands for it: itself unless it is a duplicate.
  /// Errors: as build; then nothing has changed.
  /// Cost: linear in the tets that change; the first insertion after build O(n); below dimension 3
  /// that of building anew.
  Result<Index> insert(Point3 p, Index hint = 0);

  /// Decides about a point before it goes in, by the tets that it would remove and the facets that
  /// it would be joined to.
  using CavityTest = std::function<bool(const Triangulation3::Cavity& cavity)>;

  /// Adds point p, which lies inside the circumsphere of tet t, if `accepts` agrees. Returns its
  /// number, or kNoIndex if it was refused or lies in no such sphere; then nothing is changed.
  /// Requires: dimension() == 3; p finite and no vertex; t < topology().size(); fewer than 2^28
  /// points. Errors: kLimit beyond 2^30 tets.
  /// Cost: linear in the tets that it would remove; the first insertion after build O(n).
  Result<Index> insert_if(Point3 p, Index t, const CavityTest& accepts);

  /// What the last insertion of a vertex did to the numbers of tets: `changed` are those that are
  /// new, with the vertex as a corner, or that now name another tet; `moves` says which others,
  /// one move after the other.
  struct Change {
    std::span<const Index> changed;
    std::span<const VertexInserter3::Move> moves;
  };
  Change last_change() const { return {inserter_.cavity.tets, inserter_.moves}; }

 private:
  static constexpr Index kGhost = Triangulation3::kGhost;
  using Duplicate = BulkInsertion3::Duplicate;

  bool start();
  void add_apex(Index b, Index c);
  void take_triangles();
  void take_chain(std::vector<Duplicate>& duplicates);
  void number_as_input(std::span<const Point3> points, std::vector<Index>& order,
                       const std::vector<Duplicate>& duplicates, unsigned threads);
  void index_tets(const std::vector<Index>& order);
  Result<Index> insert_anew(Point3 p);
  void index_changed_tets();

  Index find(Point3 p, Index hint) const;

  int dimension_ = -1;
  std::vector<Point3> points_;
  Triangulation3 topology_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Index> chain_;
  std::vector<Index> representative_;  // empty while there are no duplicates
  std::size_t duplicate_count_ = 0;
  std::vector<Index> tet_of_;
  VertexInserter3 inserter_;
};

}  // namespace wellspaced
