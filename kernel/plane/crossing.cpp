#include "wellspaced/kernel/plane/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "wellspaced/kernel/bit_cast.hpp"
#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// ---- The determinants, for the ladder of exact_predicates.hpp. Differences are those of points in
// a box, so that the width that they share also holds the difference of any two of them.

// Twice the signed area of the triangle p, q, r.
template <class T>
auto area(const T& px, const T& py, const T& qx, const T& qy, const T& rx, const T& ry) {
  return px * qy - py * qx + qx * ry - qy * rx + rx * py - ry * px;
}

// The crossing of ab and cd lies at x = (bx s - ax t) / (s - t) for the areas s of c, d, a and t of
// c, d, b; likewise y.

// Of points p, q, a, b, c, d: the sign of the area of p, q and the crossing of ab and cd.
struct SideOfCrossing {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 30;
  template <class T>
  static int sign(const std::array<T, 10>& v) {
    const auto& [px, py, qx, qy, ax, ay, bx, by, cx, cy] = v;
    const auto s = ax * cy - ay * cx, t = bx * cy - by * cx;
    const auto side = wide_product(area(px, py, qx, qy, bx, by), s) -
                      wide_product(area(px, py, qx, qy, ax, ay), t);
    return sign_of(side) * sign_of(s - t);
  }
};

// Of points a, b, c, d, e, f, g, h: the sign of the difference in x of the crossing of ab and cd
// from that of ef and gh.
struct CompareCrossingsX {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 20;
  template <class T>
  static int sign(const std::array<T, 14>& v) {
    const auto& [ax, ay, bx, by, cx, cy, dx, dy, ex, ey, fx, fy, gx, gy] = v;
    const auto s = area(cx, cy, dx, dy, ax, ay), t = area(cx, cy, dx, dy, bx, by);
    const auto u = ex * gy - ey * gx, w = fx * gy - fy * gx;
    const auto difference =
        wide_product(s * bx - t * ax, u - w) - wide_product(u * fx - w * ex, s - t);
    return sign_of(difference) * sign_of(s - t) * sign_of(u - w);
  }
};

// Of points (m, 0), (n, 0), a, b, c, d: the sign of the difference in x of the crossing of ab and
// cd from (m + n) / 2.
struct CompareCrossingXWithMean {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 30;
  template <class T>
  static int sign(const std::array<T, 10>& v) {
    const auto& [m, unused_m, n, unused_n, ax, ay, bx, by, cx, cy] = v;
    const auto s = ax * cy - ay * cx, t = bx * cy - by * cx;
    const auto x = wide_product(s, bx) - wide_product(t, ax);
    const auto difference = x + x - wide_product(s - t, m) - wide_product(s - t, n);
    return sign_of(difference) * sign_of(s - t);
  }
};

Point2 mirrored(Point2 p) { return {p.y, p.x}; }

Crossing mirrored(const Crossing& p) {
  return {mirrored(p.a), mirrored(p.b), mirrored(p.c), mirrored(p.d)};
}

int compare_x(const Crossing& p, const Crossing& q) {
  return exact::sign<CompareCrossingsX>(std::array{p.a.x, p.a.y, p.b.x, p.b.y, p.c.x, p.c.y, p.d.x,
                                                   p.d.y, q.a.x, q.a.y, q.b.x, q.b.y, q.c.x, q.c.y,
                                                   q.d.x, q.d.y});
}

int compare_x_with_mean(const Crossing& p, double m, double n) {
  return exact::sign<CompareCrossingXWithMean>(
      std::array{m, p.d.y, n, p.d.y, p.a.x, p.a.y, p.b.x, p.b.y, p.c.x, p.c.y, p.d.x, p.d.y});
}

int compare_x(const Crossing& p, double x) { return compare_x_with_mean(p, x, x); }

// ---- Relations.

// Requires: p lies on the line through a and b.
bool in_box(Point2 a, Point2 b, Point2 p) {
  const auto [low, high] = std::minmax(a, b);
  return low <= p && p <= high;
}

SegmentRelation relate_on_one_line(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto [ab_low, ab_high] = std::minmax(a, b);
  const auto [cd_low, cd_high] = std::minmax(c, d);
  const Point2 low = std::max(ab_low, cd_low);
  const Point2 high = std::min(ab_high, cd_high);
  if (low < high) return SegmentRelation::kOverlap;
  return high < low ? SegmentRelation::kDisjoint : SegmentRelation::kTouch;
}

// ---- Rounding: a search among the doubles with the exact comparison.

// The doubles in order, numbered; both zeros are 0.
std::int64_t number_of(double x) {
  const auto bits = bit_cast<std::int64_t>(x);
  return bits >= 0 ? bits : -(bits & std::numeric_limits<std::int64_t>::max());
}

double numbered(std::int64_t number) {
  return number >= 0 ? bit_cast<double>(number) : -bit_cast<double>(-number);
}

// Steps of the search stay far from the limits of 64 bits.
constexpr std::int64_t kLongestStep = std::int64_t{1} << 40;

// The crossing's x in plain doubles, where the search starts: any value will do.
double estimated_x(const Crossing& p) {
  const double dx = p.d.x - p.c.x, dy = p.d.y - p.c.y;
  const double s = dx * (p.a.y - p.c.y) - dy * (p.a.x - p.c.x);
  const double st = dx * (p.a.y - p.b.y) - dy * (p.a.x - p.b.x);
  return p.a.x + s / st * (p.b.x - p.a.x);
}

// The number of the last double that is not beyond the crossing's x.
std::int64_t floor_x(const Crossing& p) {
  const auto [ab_low, ab_high] = std::minmax(p.a.x, p.b.x);
  const auto [cd_low, cd_high] = std::minmax(p.c.x, p.d.x);
  std::int64_t low = number_of(std::max(ab_low, cd_low));         // not beyond
  std::int64_t high = number_of(std::min(ab_high, cd_high)) + 1;  // beyond
  if (low + 1 == high) return low;
  const auto beyond = [&p](std::int64_t n) { return compare_x(p, numbered(n)) < 0; };
  std::int64_t probe = std::clamp(number_of(estimated_x(p)), low + 1, high - 1);
  for (std::int64_t step = 1; low < probe && probe < high && step < kLongestStep; step *= 2) {
    const bool above = beyond(probe);
    (above ? high : low) = probe;
    probe += above ? -step : step;
  }
  while (low + 1 < high) {
    const std::int64_t middle = std::midpoint(low, high);
    (beyond(middle) ? high : low) = middle;
  }
  return low;
}

// Doubles next to a coordinate, the nearest first.
struct CrossingNeighbours {
  bool exact = false;
  int count = 0;
  std::array<double, 5> value{};

  void add(double x, double from, double limit) {
    if (std::isfinite(x) && std::fabs(x - from) <= limit) value[count++] = x;
  }
};

CrossingNeighbours around_double(std::int64_t exact) {
  const double x = numbered(exact);
  const double ulp = std::min(numbered(exact + 1) - x, x - numbered(exact - 1));
  CrossingNeighbours result{true};
  for (const int step : {0, 1, -1, 2, -2}) result.add(numbered(exact + step), x, 2 * ulp);
  return result;
}

// Of a coordinate strictly between two doubles, the upper of which is the nearer or not.
CrossingNeighbours around_gap(std::int64_t floor, std::int64_t up) {
  const double below = numbered(floor), above = numbered(floor + 1), ulp = above - below;
  const std::int64_t outward = up != 0 ? 1 : -1;
  CrossingNeighbours result;
  for (const std::int64_t n :
       {floor + up, floor + 1 - up, floor + up + outward, floor + 1 - up - outward}) {
    result.add(numbered(n), n <= floor ? below : above, ulp);
  }
  return result;
}

CrossingNeighbours neighbours_of_x(const Crossing& p) {
  const std::int64_t floor = floor_x(p);
  if (compare_x(p, numbered(floor)) == 0) return around_double(floor);
  const int side = compare_x_with_mean(p, numbered(floor), numbered(floor + 1));
  const bool up = side > 0 || (side == 0 && floor % 2 != 0);
  return around_gap(floor, up ? 1 : 0);
}

}  // namespace

SegmentRelation relate_segments(Point2 a, Point2 b, Point2 c, Point2 d) {
  const int abc = orient2d(a, b, c), abd = orient2d(a, b, d);
  const int cda = orient2d(c, d, a), cdb = orient2d(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return SegmentRelation::kCross;
  if (abc == 0 && abd == 0 && cda == 0 && cdb == 0) return relate_on_one_line(a, b, c, d);
  const bool touch = (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) ||
                     (cda == 0 && in_box(c, d, a)) || (cdb == 0 && in_box(c, d, b));
  return touch ? SegmentRelation::kTouch : SegmentRelation::kDisjoint;
}

int orient2d(Point2 p, Point2 q, const Crossing& crossing) {
  const auto& [a, b, c, d] = crossing;
  return exact::sign<SideOfCrossing>(
      std::array{p.x, p.y, q.x, q.y, a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
}

int compare_xy(const Crossing& p, const Crossing& q) {
  const int x = compare_x(p, q);
  return x != 0 ? x : compare_x(mirrored(p), mirrored(q));
}

int compare_xy(const Crossing& p, Point2 q) {
  const int x = compare_x(p, q.x);
  return x != 0 ? x : compare_x(mirrored(p), q.y);
}

RoundedCrossing round_crossing(const Crossing& crossing) {
  const CrossingNeighbours x = neighbours_of_x(crossing), y = neighbours_of_x(mirrored(crossing));
  RoundedCrossing result;
  result.exact = x.exact && y.exact;
  for (int ranks = 0; ranks < x.count + y.count - 1; ++ranks) {
    for (int i = std::max(0, ranks - y.count + 1); i <= ranks && i < x.count; ++i) {
      result.points[result.count++] = {x.value[i], y.value[ranks - i]};
    }
  }
  return result;
}

}  // namespace wellspaced
