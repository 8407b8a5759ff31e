// The circumsphere of a tet, as fast as it goes.
#pragma once

#include "wellspaced/kernel/space/circumsphere.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {

/// circumsphere(), without a test: infinite or NaN for a flat tet, and it may overflow.
inline Sphere tet_sphere(Point3 a, Point3 b, Point3 c, Point3 d) {
  const Point3 u = b - a, v = c - a, w = d - a;
  const Point3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const double scale = 0.5 / dot(u, vw);
  const Point3 offset = scale * (dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv);
  return {a + offset, length(offset)};
}

}  // namespace wellspaced
