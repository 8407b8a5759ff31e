#include "wellspaced/kernel/plane/crossing.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <vector>

#include "tests/support/predicate_cases.hpp"
#include "tests/support/slow_integer.hpp"

namespace wellspaced::testing {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

// ---- The reference: lines by their equations, points of segments by their parameters.

// All coordinates in units of 2^-1074.
SlowInteger slow(double x) { return SlowInteger::from_double(x, -1074); }

struct SlowPoint {
  SlowInteger x, y, w = 1;  // (x / w, y / w)
};

SlowPoint slow_point(Point2 p) { return {slow(p.x), slow(p.y)}; }

struct SlowLine {
  SlowInteger a, b, c;  // a x + b y + c = 0
};

SlowLine line_through(Point2 p, Point2 q) {
  const SlowInteger px = slow(p.x), py = slow(p.y), qx = slow(q.x), qy = slow(q.y);
  return {py - qy, qx - px, px * qy - qx * py};
}

SlowPoint slow_crossing(const Crossing& p) {
  const SlowLine l = line_through(p.a, p.b), m = line_through(p.c, p.d);
  const SlowPoint q{l.b * m.c - m.b * l.c, l.c * m.a - m.c * l.a, l.a * m.b - m.a * l.b};
  return q.w.sign() > 0 ? q : SlowPoint{-q.x, -q.y, -q.w};
}

int slow_compare_x(const SlowPoint& p, const SlowPoint& q) {
  return (p.x * q.w - q.x * p.w).sign();
}

int slow_compare_xy(const SlowPoint& p, const SlowPoint& q) {
  const int x = slow_compare_x(p, q);
  return x != 0 ? x : (p.y * q.w - q.y * p.w).sign();
}

int slow_side(Point2 p, Point2 q, const SlowPoint& r) {
  const SlowLine l = line_through(p, q);
  return (l.a * r.x + l.b * r.y + l.c * r.w).sign();
}

SlowInteger slow_dot(Point2 o, Point2 p, Point2 q) {
  return (slow(p.x) - slow(o.x)) * (slow(q.x) - slow(o.x)) +
         (slow(p.y) - slow(o.y)) * (slow(q.y) - slow(o.y));
}

bool slow_on_segment(Point2 a, Point2 b, Point2 p) {
  return slow_side(a, b, slow_point(p)) == 0 && slow_dot(p, a, b).sign() <= 0;
}

SegmentRelation slow_parallel_relation(const std::array<Point2, 4>& p) {
  std::set<std::pair<double, double>> shared;
  for (int i = 0; i < 4; ++i) {
    const int other = i < 2 ? 2 : 0;
    if (slow_on_segment(p[other], p[other + 1], p[i])) shared.insert({p[i].x + 0.0, p[i].y + 0.0});
  }
  if (shared.empty()) return SegmentRelation::kDisjoint;
  return shared.size() == 1 ? SegmentRelation::kTouch : SegmentRelation::kOverlap;
}

// 1: 0 < number / unit < 1; 0: at 0 or 1; -1: outside.
int slow_place(SlowInteger number, SlowInteger unit) {
  if (unit.sign() < 0) {
    number = -number;
    unit = -unit;
  }
  return number.sign() < 0 || number > unit ? -1 : number.sign() > 0 && number < unit;
}

SegmentRelation slow_relation(const std::array<Point2, 4>& p) {
  const SlowLine l = line_through(p[0], p[1]), m = line_through(p[2], p[3]);
  const SlowInteger w = l.a * m.b - m.a * l.b;
  if (w.sign() == 0) return slow_parallel_relation(p);
  const SlowPoint a = slow_point(p[0]), c = slow_point(p[2]);
  const int on_ab = slow_place(m.a * a.x + m.b * a.y + m.c, w);
  const int on_cd = slow_place(-(l.a * c.x + l.b * c.y + l.c), w);
  if (on_ab < 0 || on_cd < 0) return SegmentRelation::kDisjoint;
  return on_ab > 0 && on_cd > 0 ? SegmentRelation::kCross : SegmentRelation::kTouch;
}

// ---- The inputs.

struct FourPoints {
  static constexpr std::size_t kDimension = 2;
  static constexpr std::size_t kPoints = 4;
  static constexpr Rows kRows = Rows::kFlat;
  using Coordinates = std::array<double, 8>;
};

std::array<Point2, 4> points_of(const std::array<double, 8>& x) {
  return {Point2{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}, {x[6], x[7]}};
}

class Pairs {
 public:
  explicit Pairs(std::uint64_t seed) : generator_(seed) {}

  std::array<Point2, 4> next() {
    return points_of(generator_.line(static_cast<Family>(count_++ % kFamilies)));
  }

  Crossing next_crossing() {
    for (;;) {
      const auto [a, b, c, d] = next();
      const SegmentRelation relation = relate_segments(a, b, c, d);
      const bool parallel = slow_crossing({a, b, c, d}).w.sign() == 0;
      if (relation == SegmentRelation::kCross) return {a, b, c, d};
      if (relation == SegmentRelation::kTouch && !parallel) return {a, b, c, d};
    }
  }

  Random& random() { return generator_.random(); }

 private:
  LineGenerator<FourPoints> generator_;
  int count_ = 0;
};

// Segments with integer ends through (x / k, y / k): from z to (x, y) - (k - 1) z.
struct Pencil {
  Point2 numerator;
  int denominator;

  std::array<Point2, 2> segment(Random& random) const {
    const Point2 z{static_cast<double>(random.below(2000)) - 1000,
                   static_cast<double>(random.below(2000)) - 1000};
    const double k = denominator - 1;
    return {z, {numerator.x - k * z.x, numerator.y - k * z.y}};
  }

  Crossing crossing(Random& random) const {
    for (;;) {
      const auto [a, b] = segment(random);
      const auto [c, d] = segment(random);
      if (relate_segments(a, b, c, d) == SegmentRelation::kCross) return {a, b, c, d};
    }
  }
};

Pencil random_pencil(Random& random) {
  return {{static_cast<double>(random.below(9999)) - 5000, static_cast<double>(random.below(9999))},
          2 + static_cast<int>(random.below(9))};
}

// ---- Relations.

TEST(RelateSegments, AgreesWithTheParametersOnHardPairs) {
  Pairs pairs(1);
  std::array<int, 4> seen{};
  for (int i = 0; i < 8000; ++i) {
    const auto p = pairs.next();
    const SegmentRelation relation = relate_segments(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(relation, slow_relation(p)) << "pair " << i;
    ++seen[static_cast<int>(relation)];
  }
  for (const int count : seen) EXPECT_GE(count, 100);
}

TEST(RelateSegments, DoesNotDependOnTheOrder) {
  Pairs pairs(2);
  for (int i = 0; i < 4000; ++i) {
    const auto [a, b, c, d] = pairs.next();
    const SegmentRelation relation = relate_segments(a, b, c, d);
    ASSERT_EQ(relate_segments(b, a, c, d), relation);
    ASSERT_EQ(relate_segments(a, b, d, c), relation);
    ASSERT_EQ(relate_segments(c, d, a, b), relation);
  }
}

TEST(RelateSegments, TellsTheKindsApart) {
  const Point2 o{0, 0}, x{2, 0}, y{0, 2}, xy{2, 2}, middle{1, 1};
  EXPECT_EQ(relate_segments(o, xy, x, y), SegmentRelation::kCross);
  EXPECT_EQ(relate_segments(o, xy, middle, y), SegmentRelation::kTouch);
  EXPECT_EQ(relate_segments(o, x, o, y), SegmentRelation::kTouch);
  EXPECT_EQ(relate_segments(o, middle, middle, xy), SegmentRelation::kTouch);
  EXPECT_EQ(relate_segments(o, xy, middle, xy), SegmentRelation::kOverlap);
  EXPECT_EQ(relate_segments(o, xy, xy, o), SegmentRelation::kOverlap);
  EXPECT_EQ(relate_segments(o, x, y, xy), SegmentRelation::kDisjoint);
  EXPECT_EQ(relate_segments(o, {1, 0}, x, {3, 0}), SegmentRelation::kDisjoint);
}

TEST(RelateSegments, TakesASegmentWithoutLengthForAPoint) {
  const Point2 o{0, 0}, xy{2, 2}, middle{1, 1}, off{1, 0};
  EXPECT_EQ(relate_segments(middle, middle, o, xy), SegmentRelation::kTouch);
  EXPECT_EQ(relate_segments(o, xy, off, off), SegmentRelation::kDisjoint);
  EXPECT_EQ(relate_segments(o, o, {-0.0, 0}, {0, -0.0}), SegmentRelation::kTouch);
  EXPECT_EQ(relate_segments(o, o, xy, xy), SegmentRelation::kDisjoint);
}

// ---- Decisions about crossings.

TEST(Crossing, LiesOnTheSideThatExactArithmeticSays) {
  Pairs pairs(3);
  for (int i = 0; i < 3000; ++i) {
    const Crossing p = pairs.next_crossing();
    const auto [q, r, s, t] = i % 2 == 0 ? pairs.next() : std::array{p.a, p.d, p.b, p.c};
    ASSERT_EQ(orient2d(q, r, p), slow_side(q, r, slow_crossing(p))) << "crossing " << i;
    ASSERT_EQ(orient2d(q, r, p), -orient2d(r, q, p));
    ASSERT_EQ(orient2d(p.a, p.b, p), 0);
    ASSERT_EQ(orient2d(p.c, p.d, p), 0);
  }
}

TEST(Crossing, IsOrderedAsExactArithmeticSays) {
  Pairs pairs(4);
  Crossing last = pairs.next_crossing();
  for (int i = 0; i < 3000; ++i) {
    const Crossing p = pairs.next_crossing();
    ASSERT_EQ(compare_xy(p, last), slow_compare_xy(slow_crossing(p), slow_crossing(last)));
    ASSERT_EQ(compare_xy(p, last), -compare_xy(last, p));
    ASSERT_EQ(compare_xy(p, last.a), slow_compare_xy(slow_crossing(p), slow_point(last.a)));
    last = p;
  }
}

TEST(Crossing, IsOnePointForAllSegmentsThroughIt) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Pencil pencil = random_pencil(random);
    const Crossing p = pencil.crossing(random), q = pencil.crossing(random);
    const auto [a, b] = pencil.segment(random);
    ASSERT_EQ(compare_xy(p, q), 0);
    ASSERT_EQ(compare_xy(p, {p.c, p.d, p.b, p.a}), 0);
    ASSERT_EQ(orient2d(a, b, p), 0);
  }
}

TEST(Crossing, IsAnotherPointOnceASegmentMovesByAnUlp) {
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Pencil pencil = random_pencil(random);
    const Crossing p = pencil.crossing(random);
    Crossing q = p;
    q.a.y = std::nextafter(q.a.y, 1e9);
    if (orient2d(p.a, p.b, q.a) == 0) continue;
    ASSERT_NE(compare_xy(p, q), 0);
    ASSERT_EQ(compare_xy(p, q), slow_compare_xy(slow_crossing(p), slow_crossing(q)));
  }
}

// Coordinates that fill each of the widths that the fixed integers come in.
TEST(Crossing, IsExactAtTheLimitsOfTheWidths) {
  const std::vector<std::vector<double>> sets = {
      {0x7FFFF, 0x7FFFE, 1, 0},                         // narrow for comparisons
      {0x1FFFFFFF, 0x1FFFFFFE, 1, 0},                   // narrow for sides and rounding
      {0x1.fffffffffffffp0, 1, 0x1p-59, 0x3p-59, 0},    // 60 bits
      {0x1.fffffffffffffp0, 1, 0x1p-118, 0x5p-90, 0}};  // 119 bits
  Random random(10);
  for (const auto& values : sets) {
    const auto coordinate = [&] {
      const double x = values[random.below(values.size())];
      return random.below(2) != 0 ? x : -x;
    };
    const auto crossing = [&]() -> Crossing {
      for (;;) {
        std::array<double, 8> x;
        for (double& value : x) value = coordinate();
        const auto [a, b, c, d] = points_of(x);
        if (relate_segments(a, b, c, d) == SegmentRelation::kCross) return {a, b, c, d};
      }
    };
    for (int i = 0; i < 200; ++i) {
      const Crossing p = crossing(), q = crossing();
      ASSERT_EQ(compare_xy(p, q), slow_compare_xy(slow_crossing(p), slow_crossing(q)));
      ASSERT_EQ(orient2d(q.a, q.b, p), slow_side(q.a, q.b, slow_crossing(p)));
      ASSERT_EQ(compare_xy(p, q.a), slow_compare_xy(slow_crossing(p), slow_point(q.a)));
    }
  }
}

// ---- Rounding.

// The sign of |p.x - x| - |p.x - y|.
int slow_compare_distances(const SlowPoint& p, double x, double y) {
  const auto distance = [&p](double z) {
    const SlowInteger d = p.x - slow(z) * p.w;
    return d.sign() < 0 ? -d : d;
  };
  return (distance(x) - distance(y)).sign();
}

// x is the double nearest to p.x, ties to even.
void expect_nearest(const SlowPoint& p, double x) {
  for (const double next : {std::nextafter(x, -kMost * 2), std::nextafter(x, kMost * 2)}) {
    if (!std::isfinite(next)) continue;
    const int order = slow_compare_distances(p, x, next);
    ASSERT_LE(order, 0);
    if (order == 0) ASSERT_EQ(std::bit_cast<std::uint64_t>(x) % 2, 0u);
  }
}

// |p.x - x| <= 2 ulp, where an ulp is the least distance of the doubles next to p.x.
void expect_within_two_ulp(const SlowPoint& p, double nearest, double x) {
  const bool exact = (p.x - slow(nearest) * p.w).sign() == 0;
  const bool above = (p.x - slow(nearest) * p.w).sign() > 0;
  const double up = std::nextafter(nearest, kMost * 2) - nearest;
  const double down = nearest - std::nextafter(nearest, -kMost * 2);
  const double ulp = exact ? std::min(up, down) : (above ? up : down);
  SlowInteger distance = p.x - slow(x) * p.w;
  if (distance.sign() < 0) distance = -distance;
  ASSERT_LE(distance, slow(ulp) * p.w * 2);
}

void expect_well_rounded(const Crossing& p) {
  const SlowPoint exact = slow_crossing(p), mirrored{exact.y, exact.x, exact.w};
  const RoundedCrossing rounded = round_crossing(p);
  ASSERT_GE(rounded.count, 1);
  const Point2 nearest = rounded.points[0];
  expect_nearest(exact, nearest.x);
  expect_nearest(mirrored, nearest.y);
  ASSERT_EQ(rounded.exact, slow_compare_xy(exact, slow_point(nearest)) == 0);
  std::set<std::pair<double, double>> distinct;
  for (int i = 0; i < rounded.count; ++i) {
    const Point2 q = rounded.points[i];
    ASSERT_TRUE(std::isfinite(q.x) && std::isfinite(q.y));
    expect_within_two_ulp(exact, nearest.x, q.x);
    expect_within_two_ulp(mirrored, nearest.y, q.y);
    distinct.insert({q.x, q.y});
  }
  ASSERT_EQ(distinct.size(), static_cast<std::size_t>(rounded.count));
}

TEST(RoundCrossing, GivesTheNearestDoublesFirstOnHardPairs) {
  Pairs pairs(7);
  for (int i = 0; i < 600; ++i) {
    expect_well_rounded(pairs.next_crossing());
    if (::testing::Test::HasFatalFailure()) FAIL() << "crossing " << i;
  }
}

TEST(RoundCrossing, GivesTheNearestDoublesFirstOnPencils) {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    expect_well_rounded(random_pencil(random).crossing(random));
    if (::testing::Test::HasFatalFailure()) FAIL() << "crossing " << i;
  }
}

TEST(RoundCrossing, GivesSixteenPointsAwayFromTheDoubles) {
  const Crossing thirds{{0, 0}, {1, 2}, {0, 1}, {1, 0}};  // at (1/3, 2/3)
  const RoundedCrossing rounded = round_crossing(thirds);
  EXPECT_FALSE(rounded.exact);
  EXPECT_EQ(rounded.count, 16);
  EXPECT_EQ(rounded.points[0], (Point2{1.0 / 3, 2.0 / 3}));
}

TEST(RoundCrossing, KnowsCrossingsThatAreDoubles) {
  const RoundedCrossing rounded = round_crossing({{1, 1}, {5, 5}, {1, 5}, {5, 1}});
  EXPECT_TRUE(rounded.exact);
  EXPECT_EQ(rounded.points[0], (Point2{3, 3}));
  EXPECT_EQ(rounded.count, 25);
}

TEST(RoundCrossing, WorksAtTheLimitsOfTheDoubles) {
  const double limits[] = {0, kLeast, -kLeast, 3 * kLeast, 1, kMost, -kMost, kMost / 3};
  Random random(9);
  int crossings = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<double, 8> x;
    for (double& value : x) value = limits[random.below(std::size(limits))];
    const auto [a, b, c, d] = points_of(x);
    if (relate_segments(a, b, c, d) != SegmentRelation::kCross) continue;
    ++crossings;
    expect_well_rounded({a, b, c, d});
    if (::testing::Test::HasFatalFailure()) FAIL() << "pair " << i;
  }
  EXPECT_GE(crossings, 100);
}

TEST(RoundCrossing, RoundsHalfwayCasesToEven) {
  // At (1 + 2^-53, 1/2) and (1 + 3 * 2^-53, 1/2).
  const Crossing down{{1, 0}, {1 + 0x1p-52, 1}, {0, 0.5}, {2, 0.5}};
  const Crossing up{{1 + 0x1p-52, 0}, {1 + 0x1p-51, 1}, {0, 0.5}, {2, 0.5}};
  EXPECT_EQ(round_crossing(down).points[0], (Point2{1, 0.5}));
  EXPECT_EQ(round_crossing(up).points[0], (Point2{1 + 0x1p-51, 0.5}));
}

}  // namespace
}  // namespace wellspaced::testing
