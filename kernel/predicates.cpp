#include "wellspaced/kernel/predicates.hpp"

#include "wellspaced/kernel/exact_predicates.hpp"

namespace wellspaced::predicate_exact {

int orient2d(Point2 a, Point2 b, Point2 c) { return exact::orient2d(a, b, c); }

int incircle(Point2 a, Point2 b, Point2 c, Point2 d) { return exact::incircle(a, b, c, d); }

int orient3d(Point3 a, Point3 b, Point3 c, Point3 d) { return exact::orient3d(a, b, c, d); }

int insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) {
  return exact::insphere(a, b, c, d, e);
}

}  // namespace wellspaced::predicate_exact
