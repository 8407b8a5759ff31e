#include "wellspaced/kernel/weighted_distance.hpp"

#include <array>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

namespace wellspaced {
namespace {

using Coordinate = exact::BigCoordinate;
using ExactSquare = BigInteger<66>;

// A sum of two squares of differences: one bit more than a square, and 66 limbs have 24 to spare.
ExactSquare squared_distance(const Coordinate& ax, const Coordinate& ay, const Coordinate& bx,
                             const Coordinate& by) {
  const Coordinate dx = ax - bx, dy = ay - by;
  return dx * dx + dy * dy;
}

// The sign of sqrt(a) - sqrt(b) - d for d >= 0: that of a - b - d^2 - 2 d sqrt(b), whose last term
// is compared with the others by its square.
int sign_of_root_difference(const ExactSquare& a, const ExactSquare& b, const Coordinate& d) {
  const ExactSquare rest = a - b - d * d;
  if (rest.sign() < 0) return -1;
  const Coordinate twice = d + d;
  return sign_of(rest * rest - (twice * twice) * b);
}

int exact_order(const WeightedSite& a, const WeightedSite& b, Point2 x) {
  const auto c = exact::big_coordinates(
      std::array{a.place.x, a.place.y, b.place.x, b.place.y, x.x, x.y, a.weight, b.weight});
  const ExactSquare to_a = squared_distance(c[0], c[1], c[4], c[5]);
  const ExactSquare to_b = squared_distance(c[2], c[3], c[4], c[5]);
  const Coordinate d = c[7] - c[6];
  return d.sign() >= 0 ? sign_of_root_difference(to_a, to_b, d)
                       : -sign_of_root_difference(to_b, to_a, c[6] - c[7]);
}

}  // namespace

double weighted_distance(const WeightedSite& site, Point2 x) {
  return site.weight + distance(site.place, x);
}

int weighted_distance_order(const WeightedSite& a, const WeightedSite& b, Point2 x) {
  const double to_a = weighted_distance(a, x), to_b = weighted_distance(b, x);
  // Each errs by at most 3 units in the last place, 2^-51 of its value when it is not subnormal.
  const double bound = 0x1p-50 * (to_a + to_b) + 0x1p-1060;
  const int sign = predicate_filter::certified_sign(to_a - to_b, bound);
  return sign != 0 ? sign : exact_order(a, b, x);
}

}  // namespace wellspaced
