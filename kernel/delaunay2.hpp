// Delaunay and constrained Delaunay triangulation of the plane: exact, incremental, dynamic.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/triangulation2.hpp"

namespace wellspaced {

/// A constrained Delaunay triangulation of the convex hull of its points.
///
/// Vertices are numbered as the input points are. A point with the coordinates of an earlier one
/// is no vertex: duplicate_of() names the vertex that stands for it. Fewer than three points, or
/// collinear ones, give no triangle: dimension() says so.
class Delaunay2 {
 public:
  using Edge = Triangulation2::Edge;

  /// The Delaunay triangulation of `points`: exact; ties (cocircular points) are broken by the
  /// order of insertion, so the same points in the same order give the same triangles.
  /// Errors: kInvalidGeometry for a NaN or infinite coordinate (ids: the point); kLimit beyond
  /// 2^28 points.
  /// Cost: O(n log n) expected time, 48 bytes a point kept and about 70 at the peak.
  static Result<Delaunay2> build(std::span<const Point2> points);

  /// -1: no point; 0: all points are equal; 1: all are collinear; 2.
  int dimension() const { return dimension_; }
  const std::vector<Point2>& points() const { return points_; }
  /// For each point the vertex that stands for it: itself unless it is a duplicate. 
  Index representative(Index point) const;
  const Triangulation2& topology() const { return topology_; }

  /// Makes the segment from a to b part of the triangulation. Vertices that lie on it split it.
  /// Returns the vertices along it, a first. Duplicates are replaced by their vertex; a segment
  /// whose ends coincide changes nothing.
  /// Errors: kInvalidGeometry where it would cross a constrained edge in its interior (ids: a, b
  /// and the ends of that edge); then the triangulation is unchanged.
  /// Cost: proportional to the triangles crossed and the degrees of the vertices on the way.
  Result<std::vector<Index>> insert_constraint(Index a, Index b);

  /// The edge from vertex a to vertex b, if there is one (triangle == kNoIndex: none).
  Edge find_edge(Index a, Index b) const;
  /// Some edge that leaves vertex v (triangle == kNoIndex: v is in no triangle).
  Edge edge_from(Index v) const;

 private:
  int dimension_ = -1;
  std::vector<Point2> points_;
  Triangulation2 topology_;
};

}  // namespace wellspaced
