// The sphere through the corners of a tetrahedron.
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

struct Sphere {
  Point3 center;
  double radius = 0;
};

/// The sphere through a, b, c, d.
///
/// Returns: centre and radius in floating point: relative to the radius they err by about 2^-48
/// over the volume of the tet divided by the product of the three edges at a. So a sliver's are
/// inexact, and nothing may be decided by them: that is what insphere is for. The radius is the
/// distance from the centre to a before the centre is rounded. Errors: kInvalidGeometry where the
/// four points are coplanar (exactly), or the result is not finite.
Result<Sphere> circumsphere(Point3 a, Point3 b, Point3 c, Point3 d);

}  // namespace wellspaced
