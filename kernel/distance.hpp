// Euclidean distances in the plane.
#pragma once

#include <cmath>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The distance of a and b for coordinates of any size: where a square would overflow or lose bits
/// below the normal range, the points are scaled by a power of two first.
double scaled_distance(Point2 a, Point2 b);

/// The Euclidean distance |a - b|, within 2 units in the last place; symmetric in a and b.
/// Infinite only where it exceeds the largest double. Requires: finite coordinates.
inline double distance(Point2 a, Point2 b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  const double square = dx * dx + dy * dy;
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : scaled_distance(a, b);
}

/// The distance of p from the segment ab, which may be a single point.
double distance_to_segment(Point2 p, Point2 a, Point2 b);

}  // namespace wellspaced
