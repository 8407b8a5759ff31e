// Angles without the C library: compared by cotangents, printed by a routine of our own.
#pragma once

#include <cmath>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

inline constexpr double kCotangentOf10Degrees = 5.671281819617709530994418439864;

/// The cotangent of the angle at `apex` between the rays to p and q, in either order: it falls from
/// +infinity at 0 to -infinity at 180 degrees, so a larger cotangent is a smaller angle.
/// Degenerate: +-infinity where the three points are collinear, NaN where `apex` coincides with
/// another point.
inline double corner_cotangent(Point2 apex, Point2 p, Point2 q) {
  const double ux = p.x - apex.x, uy = p.y - apex.y;
  const double vx = q.x - apex.x, vy = q.y - apex.y;
  return (ux * vx + uy * vy) / std::fabs(ux * vy - uy * vx);
}

/// The angle in [0, 180] degrees that has this cotangent; NaN for NaN. Multiples of 45 are exact.
/// Error: below 1e-13 degrees.
double arccotangent_deg(double cotangent);

}  // namespace wellspaced
