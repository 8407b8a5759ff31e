// Exact signs that the auditors need beside the predicates: angles, bisectors, circumcentres.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The sign of the scalar product (p - apex) . (q - apex): positive for an acute angle at apex, 0
/// for a right one, negative for an obtuse one.
int angle_sign(Point2 apex, Point2 p, Point2 q);

/// The sign of |x - u|^2 - |x - v|^2: negative where x is nearer to u.
int bisector_side(Point2 u, Point2 v, Point2 x);

/// Positive when the circumcentre of a, b, c lies left of the line from p to q, 0 on it.
/// Requires: a, b, c are counter-clockwise and not on one line.
int circumcentre_side(Point2 p, Point2 q, Point2 a, Point2 b, Point2 c);

}  // namespace wellspaced::audit
