// Exact signs that the auditors need beside the predicates: angles and circumcentres.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

namespace wellspaced::audit {

/// The sign of the scalar product (p - apex) . (q - apex): positive for an acute angle at apex, 0
/// for a right one, negative for an obtuse one.
inline int angle_sign(Point2 apex, Point2 p, Point2 q);

/// The same without the floating-point filter.
int exact_angle_sign(Point2 apex, Point2 p, Point2 q);

/// The number of the edge (0: ab, 1: bc, 2: ca) that lies opposite an obtuse corner, or 3.
inline int edge_facing_obtuse(Point2 a, Point2 b, Point2 c);

/// Positive when the circumcentre of a, b, c lies left of the line from p to q, 0 on it.
/// Requires: a, b, c are counter-clockwise and not on one line.
int circumcentre_side(Point2 p, Point2 q, Point2 a, Point2 b, Point2 c);

/// The same in space, for one circumcentre and several planes.
class Circumcentre3 {
 public:
  /// Requires: det[b-a, c-a, d-a] > 0 for the corners a, b, c, d.
  explicit Circumcentre3(const std::array<Point3, 4>& tet);

  /// Positive when it lies on the side of the plane through p, q, r from which they appear
  /// counter-clockwise, 0 on it.
  int side(const std::array<Point3, 3>& plane) const;

 private:
  std::array<Point3, 4> tet_;
  Point3 numerator_;  // of the vector from a to it; the denominator is twice the volume
  double volume_ = 0, largest_ = 0;
};

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

/// Two products of differences of coordinates, each rounded once; and the filter of orient2d for
/// their sum.
struct SumOfProducts {
  double left, right;

  bool is_certain() const {
    const double size = std::fabs(left) + std::fabs(right);
    return (std::fabs(left + right) >
            predicate_filter::kOrient2dBound * size + predicate_filter::kOrient2dUnderflow) &
           (size <= std::numeric_limits<double>::max());
  }
  bool is_negative() const { return left + right < 0; }
};

inline int edge_facing_obtuse(Point2 a, Point2 b, Point2 c) {
  const double abx = b.x - a.x, aby = b.y - a.y, bcx = c.x - b.x, bcy = c.y - b.y;
  const double cax = a.x - c.x, cay = a.y - c.y;
  // Opposite ab, bc and ca, by the filter of angle_sign; without branches.
  const SumOfProducts at_c{-cax * bcx, -cay * bcy}, at_a{-abx * cax, -aby * cay},
      at_b{-bcx * abx, -bcy * aby};
  if (at_c.is_certain() && at_a.is_certain() && at_b.is_certain())
    return 3 - 3 * at_c.is_negative() - 2 * at_a.is_negative() - at_b.is_negative();
  return 3 - 3 * (angle_sign(c, a, b) < 0) - 2 * (angle_sign(a, b, c) < 0) -
         (angle_sign(b, c, a) < 0);
}

}  // namespace wellspaced::audit
