// Exact signs that the auditors need beside the predicates: angles and circumcentres.
#pragma once

#include <array>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

namespace wellspaced::audit {

/// The sign of the scalar product (p - apex) . (q - apex): positive for an acute angle at apex, 0
/// for a right one, negative for an obtuse one.
inline int angle_sign(Point2 apex, Point2 p, Point2 q);

/// The same without the floating-point filter.
int exact_angle_sign(Point2 apex, Point2 p, Point2 q);

/// Positive when the circumcentre of a, b, c lies left of the line from p to q, 0 on it.
/// Requires: a, b, c are counter-clockwise and not on one line.
int circumcentre_side(Point2 p, Point2 q, Point2 a, Point2 b, Point2 c);

/// The same in space: positive when the circumcentre of a, b, c, d lies on the side of the plane
/// through p, q, r from which they appear counter-clockwise.
/// Requires: det[b-a, c-a, d-a] > 0.
int circumcentre_side(const std::array<Point3, 3>& plane, const std::array<Point3, 4>& tet);

/// Positive when d lies inside the smallest sphere through a, b, c, 0 on it.
/// Requires: a, b, c are not on one line.
int face_sphere_side(Point3 a, Point3 b, Point3 c, Point3 d);

inline int angle_sign(Point2 apex, Point2 p, Point2 q) {
  // px qx + py qy is the determinant of (px, py) and (-qy, qx).
  const double px = p.x - apex.x, py = p.y - apex.y, qx = q.x - apex.x, qy = q.y - apex.y;
  const int sign = predicate_filter::orient2d_of_differences(px, py, -qy, qx);
  if (sign != 0) return sign;
  const bool axis_parallel = (px == 0 || qx == 0) && (py == 0 || qy == 0);
  return axis_parallel ? 0 : exact_angle_sign(apex, p, q);
}

}  // namespace wellspaced::audit
