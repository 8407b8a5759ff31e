// The sphere through the corners of a tetrahedron.
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {

struct Sphere {
  Point3 centre;
  double radius = 0;
};

/// The sphere through a, b, c, d.
///
/// Returns: centre and radius in floating point: relative to the radius they err by about 2^-48
/// over the volume of the tet divided by the product of the three edges at a. So a sliver's are
/// inexact, and nothing may be decided by them: that is what insphere is for. The radius is the
/// distance from the centre to a before the centre is rounded.
/// Errors: kInvalidGeometry where the four points are coplanar (exactly), or the result is not
///   finite.
Result<Sphere> circumsphere(Point3 a, Point3 b, Point3 c, Point3 d);

/// The same without a test and without scaling, for what only steers a search. Degenerate: infinite
/// or NaN for a flat tet, and where squares of lengths over- or underflow.
inline Sphere unchecked_circumsphere(Point3 a, Point3 b, Point3 c, Point3 d) {
  const Point3 u = b - a, v = c - a, w = d - a;
  const Point3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const double scale = 0.5 / dot(u, vw);
  const Point3 offset = scale * (dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv);
  return {a + offset, length(offset)};
}

}  // namespace wellspaced
