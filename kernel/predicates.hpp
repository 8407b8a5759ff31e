// Exact geometric predicates: orient2d, incircle, orient3d, insphere.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The sign (-1, 0, 1) of det[a-c; b-c]: positive when a, b, c make a left turn.
int orient2d(Point2 a, Point2 b, Point2 c);

/// Positive when d lies inside the circle through a, b, c. Requires: orient2d(a, b, c) > 0;
/// with a, b, c clockwise the sign is reversed.
int incircle(Point2 a, Point2 b, Point2 c, Point2 d);

/// The sign of det[a-d; b-d; c-d] (Shewchuk's convention: positive when d lies below the plane
/// in which a, b, c appear counter-clockwise seen from above).
int orient3d(Point3 a, Point3 b, Point3 c, Point3 d);

/// The sign of the determinant with rows (p-e, |p-e|^2), p = a, b, c, d: positive when e lies
/// inside the sphere through a, b, c, d. Requires: orient3d(a, b, c, d) > 0.
int insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e);

}  // namespace wellspaced
