// Whether two triangles overlap: exact.
#pragma once

#include <array>
#include <span>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::audit {

using Corners = std::array<Point2, 3>;

inline Corners corners_of(std::span<const Point2> points, const std::array<Index, 3>& triangle) {
  return {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
}

/// The same triangle counter-clockwise. `sign`: its orientation.
inline Corners counter_clockwise(const Corners& c, int sign) {
  return sign < 0 ? Corners{c[0], c[2], c[1]} : c;
}

/// Whether the line through an edge of a has a on its left and all of b on its right or on it.
inline bool edge_separates(const Corners& a, const Corners& b) {
  for (int i = 0; i < 3; ++i) {
    const Point2 from = a[i], to = a[(i + 1) % 3];
    if (orient2d(from, to, b[0]) <= 0 && orient2d(from, to, b[1]) <= 0 &&
        orient2d(from, to, b[2]) <= 0)
      return true;
  }
  return false;
}

/// Whether the interiors of two triangles have a point in common. (Convex polygons whose interiors
/// are apart are separated by the line through an edge of one of them.)
/// Requires: both counter-clockwise and not flat.
inline bool interiors_overlap(const Corners& a, const Corners& b) {
  return !edge_separates(a, b) && !edge_separates(b, a);
}

}  // namespace wellspaced::audit
