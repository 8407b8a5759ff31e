#include "wellspaced/kernel/compare_distances.hpp"

#include <array>

#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

namespace wellspaced {
namespace {

struct SquaredDistances {
  static constexpr std::size_t kDimension = 3;
  static constexpr int kNarrowBits = 62;
  template <class T>
  static int sign(const std::array<T, 6>& v) {
    const auto& [ax, ay, az, bx, by, bz] = v;
    return sign_of(wide_product(ax, ax) + wide_product(ay, ay) + wide_product(az, az) -
                   wide_product(bx, bx) - wide_product(by, by) - wide_product(bz, bz));
  }
};

double squared_length(Point3 a) { return a.x * a.x + a.y * a.y + a.z * a.z; }

}  // namespace

int compare_distances(Point3 p, Point3 a, Point3 b) {
  const double a_sq = squared_length(predicate_filter::difference(a, p));
  const double b_sq = squared_length(predicate_filter::difference(b, p));
  // A product of degree 2 through 6 roundings of at most 2^-52 each; below, what underflows.
  const double bound = 0x1p-49 * (a_sq + b_sq) + 0x1p-1000;
  const int sign = predicate_filter::certified_sign(a_sq - b_sq, bound);
  if (sign != 0) return sign;
  return exact::sign<SquaredDistances>(std::array{a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z});
}

}  // namespace wellspaced
