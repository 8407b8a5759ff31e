// Places in the plane and in space: their order, and how far rounding may move them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The corners of a triangle and of a tet in space.
using Corners3 = std::array<Point3, 3>;
using TetCorners = std::array<Point3, 4>;

/// The lexicographic order of places. -0 and +0 are one.
inline bool before(Point2 p, Point2 q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }
inline bool before(const Point3& p, const Point3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

/// How far apart the doubles are at x; doubles nearer to 0 lie closer.
inline double ulp(double x) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const double size = std::fabs(x);
  return size < kLargest ? std::nextafter(size, kLargest) - size : size - std::nextafter(size, 0);
}

/// x moved by a number of units in the last place, possibly negative; it stays finite.
inline double moved_by_ulps(double x, double units) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(x + units * ulp(x), -kLargest, kLargest);
}

}  // namespace wellspaced::audit
