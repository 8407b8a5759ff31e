// Points of a plane in space, triangulated as points of the plane.
#pragma once

#include <span>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A plane in space with coordinates in it: the point origin + s u + t v has coordinates (s, t) if
/// u and v have length 1 and a right angle between them.
struct PlaneFrame {
  Point3 origin, u, v;

  /// (dot(p - origin, u), dot(p - origin, v)), in floating point. Steps with other lengths or
  /// angles shear the plane. Infinite or NaN where that overflows.
  Point2 coordinates(Point3 p) const;
  /// The point at (s, t), in floating point: near the plane.
  Point3 point(Point2 at) const;
};

/// The Delaunay triangulation, in the plane, of the coordinates of `points` in `frame`. Vertices
/// are numbered as the points are.
///
/// It is exact for the coordinates as they were rounded: combinatorially planar, whether or not the
/// points lie on any plane in space. Points that lie on it exactly are better served by Delaunay3,
/// which does not round.
/// Errors: those of Delaunay2::build; kInvalidGeometry also where coordinates overflow.
Result<Delaunay2> build_in_frame(std::span<const Point3> points, const PlaneFrame& frame);

}  // namespace wellspaced
