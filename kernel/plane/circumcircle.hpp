// The circle through the corners of a triangle.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

struct Circle {
  Point2 centre;
  double radius_sq = 0;
};

/// The circle through a, b and c in floating point: the thinner the triangle, the less of the
/// result is right, and nothing may be decided by it (that is what incircle is for). Not finite
/// where the corners are collinear, or an intermediate result exceeds the doubles.
inline Circle circumcircle(Point2 a, Point2 b, Point2 c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double b_sq = bx * bx + by * by, c_sq = cx * cx + cy * cy;
  const double doubled = 2 * (bx * cy - by * cx);
  const double x = (cy * b_sq - by * c_sq) / doubled, y = (bx * c_sq - cx * b_sq) / doubled;
  return {{a.x + x, a.y + y}, x * x + y * y};
}

}  // namespace wellspaced
