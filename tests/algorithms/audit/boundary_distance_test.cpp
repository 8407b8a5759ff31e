#include "wellspaced/algorithms/audit/boundary_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using audit::Line;

double distance_to(const Line& line, Point2 p) {
  double least = 1e300;
  for (int i = 0; i <= 400; ++i) {
    const double t = i / 400.0;
    least = std::min(least, std::hypot(p.x - line[0].x - t * (line[1].x - line[0].x),
                                       p.y - line[0].y - t * (line[1].y - line[0].y)));
  }
  return least;
}

double slow_one_sided(const std::vector<Line>& from, const std::vector<Line>& to) {
  double largest = 0;
  for (const Line& line : from)
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 100.0;
      const Point2 p{line[0].x + t * (line[1].x - line[0].x),
                     line[0].y + t * (line[1].y - line[0].y)};
      double least = 1e300;
      for (const Line& other : to) least = std::min(least, distance_to(other, p));
      largest = std::max(largest, least);
    }
  return largest;
}

TEST(HausdorffDistance, AgreesWithSamples) {
  Random random(4);
  for (int round = 0; round < 30; ++round) {
    std::vector<Line> a, b;
    const auto point = [&] { return Point2{random.uniform(), random.uniform()}; };
    for (std::uint64_t i = 0; i < 1 + random.below(4); ++i) a.push_back({point(), point()});
    for (std::uint64_t i = 0; i < 1 + random.below(4); ++i) b.push_back({point(), point()});
    EXPECT_NEAR(audit::hausdorff_distance(a, b),
                std::max(slow_one_sided(a, b), slow_one_sided(b, a)), 0.02);
  }
}

TEST(HausdorffDistance, FindsAFarthestPointInsideASegment) {
  // The middle of the long segment is farther from both posts than its ends are.
  const std::vector<Line> a = {{Point2{0, 0}, Point2{10, 0}}};
  const std::vector<Line> b = {{Point2{0, 0}, Point2{0, 0}}, {Point2{10, 0}, Point2{10, 0}}};
  EXPECT_NEAR(audit::hausdorff_distance(a, b), 5, 1e-5);
}

TEST(HausdorffDistance, IsNothingBetweenEqualBoundaries) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    const auto lines = audit::boundary_lines(mesh);
    EXPECT_LT(audit::hausdorff_distance(lines, lines), 1e-12) << name;
  }
}

TEST(HausdorffDistance, IsTheHeightOfADroppedCorner) {
  const std::vector<Line> fine = {{Point2{0, 0}, Point2{2, 1}}, {Point2{2, 1}, Point2{4, 0}}};
  const std::vector<Line> coarse = {{Point2{0, 0}, Point2{4, 0}}};
  EXPECT_NEAR(audit::hausdorff_distance(fine, coarse), 1, 1e-12);
  EXPECT_NEAR(audit::hausdorff_distance(coarse, fine), 1, 1e-12);
}

// Squares of such coordinates are no doubles, and halves of the smallest are 0.
TEST(HausdorffDistance, HoldsForTheLargestAndTheSmallestDoubles) {
  for (const double unit : {0x1p1020, 0x1p500, 0x1p-500, 0x1p-1070}) {
    const std::vector<Line> fine = {{Point2{0, 0}, Point2{2 * unit, unit}},
                                    {Point2{2 * unit, unit}, Point2{4 * unit, 0}}};
    const std::vector<Line> coarse = {{Point2{0, 0}, Point2{4 * unit, 0}}};
    EXPECT_EQ(audit::hausdorff_distance(fine, coarse), unit);
    EXPECT_EQ(audit::hausdorff_distance(coarse, fine), unit);
  }
}

TEST(HausdorffDistance, EndsWhereRoundingHidesTheNearestLine) {
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<Line> a, b;
    const auto near = [&](double x) { return x + static_cast<double>(random.below(9)) * 0x1p-52; };
    for (int i = 0; i < 6; ++i) {
      const Line line = {Point2{random.uniform(), 1}, Point2{random.uniform(), 1}};
      a.push_back(line);
      b.push_back({Point2{near(line[0].x), near(1)}, Point2{near(line[1].x), near(1)}});
    }
    EXPECT_LT(audit::hausdorff_distance(a, b), 1e-14);
  }
}

TEST(HausdorffDistance, IsInfiniteToNothing) {
  const std::vector<Line> a = {{Point2{0, 0}, Point2{1, 0}}};
  EXPECT_TRUE(std::isinf(audit::hausdorff_distance(a, {})));
  EXPECT_EQ(audit::hausdorff_distance({}, {}), 0);
}

}  // namespace
}  // namespace wellspaced
