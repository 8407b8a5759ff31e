// Places in the plane and in space.
#pragma once

#include <array>
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

}  // namespace wellspaced::audit
