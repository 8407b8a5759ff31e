// The boxes that rounding may move a place in, and what passes through them: exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::audit {

/// How far apart the doubles are at x; doubles nearer to 0 lie closer.
inline double ulp(double x) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const double size = std::fabs(x);
  return size < kLargest ? std::nextafter(size, kLargest) - size : size - std::nextafter(size, 0);
}

/// How far rounding may move a coordinate on its way from a to b: so many units in the last place
/// of the larger of the two, because whoever computes a place between them adds up parts of that
/// size.
inline double rounding_between(double a, double b, double units) {
  return units * ulp(std::max(std::fabs(a), std::fabs(b)));
}

/// x + by, but finite.
inline double moved(double x, double by) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(x + by, -kLargest, kLargest);
}

/// Whether the line through a and b passes through the box around p that rounding may move it in.
inline bool passes_near(Point2 a, Point2 b, Point2 p, double units) {
  const int sign = orient2d(a, b, p);
  if (sign == 0) return true;
  const double x = rounding_between(a.x, b.x, units), y = rounding_between(a.y, b.y, units);
  for (const double dx : {-x, x})
    for (const double dy : {-y, y})
      if (orient2d(a, b, Point2{moved(p.x, dx), moved(p.y, dy)}) != sign) return true;
  return false;
}

/// Whether a function, given as the sign at a point, changes sign or vanishes over the box around p
/// with these half sides.
template <class SignAt>
bool vanishes_near(Point3 p, Point3 half, SignAt sign_at) {
  const int sign = sign_at(p);
  if (sign == 0) return true;
  for (const double dx : {-half.x, half.x})
    for (const double dy : {-half.y, half.y})
      for (const double dz : {-half.z, half.z})
        if (sign_at(Point3{moved(p.x, dx), moved(p.y, dy), moved(p.z, dz)}) != sign) return true;
  return false;
}

/// The half sides of the box of a place between a and b.
inline Point3 rounding_box(Point3 a, Point3 b, double units) {
  return {rounding_between(a.x, b.x, units), rounding_between(a.y, b.y, units),
          rounding_between(a.z, b.z, units)};
}

}  // namespace wellspaced::audit
