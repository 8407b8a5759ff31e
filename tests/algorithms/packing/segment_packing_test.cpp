#include "wellspaced/algorithms/packing/segment_packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wellspaced/algorithms/packing/point_on_segment.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// Whether the line ab passes through the box of one unit in the last place around p.
bool runs_by(Point2 a, Point2 b, Point2 p) {
  const double inf = std::numeric_limits<double>::infinity();
  int least = 1, most = -1;
  for (const double x : {std::nextafter(p.x, -inf), std::nextafter(p.x, inf)})
    for (const double y : {std::nextafter(p.y, -inf), std::nextafter(p.y, inf)}) {
      const int side = orient2d(a, b, {x, y});
      least = std::min(least, side);
      most = std::max(most, side);
    }
  return least <= 0 && most >= 0;
}

TEST(PointOnSegment, IsWithinAUnitInTheLastPlaceOfIt) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const double size = std::ldexp(1, static_cast<int>(random.below(60)) - 30);
    const Point2 a{random.uniform(-1, 1), random.uniform(-size, size)};
    const Point2 b{random.uniform(-1, 1), random.uniform(-size, size)};
    for (const double t : {1e-9, 0.3, 0.5, 0.999})
      EXPECT_TRUE(runs_by(a, b, point_on_segment(a, b, t)));
  }
}

TEST(PointOnSegment, IsSoWhereTheSegmentPassesTheOriginToo) {
  const Point2 a{-1, -0.3}, b{1, 0.30000000000000004};
  for (int k = 1; k < 50; ++k)
    EXPECT_TRUE(runs_by(a, b, point_on_segment(a, b, 0.5 + std::ldexp(1, -k))));
}

TEST(PointOnSegment, IsExactOnAxisParallelSegments) {
  EXPECT_EQ(point_on_segment({0, 3}, {8, 3}, 0.25), (Point2{2, 3}));
  EXPECT_EQ(point_on_segment({3, 8}, {3, 0}, 0.25), (Point2{3, 6}));
}

struct PackingCase {
  const char* name;
  BallRadius radius;
};

// Figure 4.3: the balls are disjoint, and none fits around the middle of a gap.
TEST(PackSegment, IsSpacedAndMaximal) {
  const PackingCase cases[] = {
      {"constant", [](Point2) { return 0.013; }},
      {"steep", [](Point2 p) { return 0.001 + 0.5 * std::fabs(p.x - 0.4); }},
      {"gentle", [](Point2 p) { return 0.01 + 0.05 * p.x; }},
      {"large", [](Point2) { return 0.26; }},
      {"tiny at an end", [](Point2 p) { return 1e-7 + 0.1 * (1 - p.x); }},
  };
  for (const auto& [name, radius] : cases) {
    const Point2 a{0, 0}, b{1, 0.5};
    const auto inner = pack_segment({a, b}, radius, 100'000);
    ASSERT_TRUE(inner.ok()) << name;
    std::vector<Point2> points{a};
    points.insert(points.end(), inner->begin(), inner->end());
    points.push_back(b);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Point2 p = points[i], q = points[i + 1];
      EXPECT_GE(distance(p, q), radius(p) + radius(q)) << name;
      const Point2 middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
      EXPECT_LT(distance(p, q) / 2, radius(middle) + std::max(radius(p), radius(q)) + 1e-12)
          << name;
    }
  }
}

TEST(PackSegment, LeavesAShortSegmentWhole) {
  EXPECT_TRUE(pack_segment(
                  {{0, 0}, {1, 0}}, [](Point2) { return 0.3; }, 10)
                  ->empty());
  EXPECT_TRUE(pack_segment(
                  {{0, 0}, {1, 0}}, [](Point2) { return 3.0; }, 10)
                  ->empty());
}

TEST(PackSegment, KeepsToItsPart) {
  const SegmentPart part{{0, 0}, {1, 0}, 0.25, 0.5};
  EXPECT_EQ(part.length(), 0.25);
  const auto points = pack_segment(
      part, [](Point2) { return 0.01; }, 100);
  ASSERT_TRUE(points.ok());
  EXPECT_GE(points->size(), 9u);
  EXPECT_GE(points->front().x, 0.25 + 0.02);
  EXPECT_LE(points->back().x, 0.5 - 0.02);
}

TEST(PackSegment, RefusesARadiusThatIsNotPositive) {
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    const auto result = pack_segment(
        {{0, 0}, {1, 0}}, [bad](Point2) { return bad; }, 100);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kUsage);
  }
}

TEST(PackSegment, StopsAtTheLimit) {
  const auto result = pack_segment(
      {{0, 0}, {1, 0}}, [](Point2) { return 1e-9; }, 100);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kLimit);
  const auto far = pack_segment(
      {{1e9, 0}, {1e9 + 1, 0}}, [](Point2) { return 1e-17; }, 100);
  ASSERT_FALSE(far.ok()) << "less than the coordinates can tell apart";
}

}  // namespace
}  // namespace wellspaced
