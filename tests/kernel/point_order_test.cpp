#include "wellspaced/kernel/point_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/point_families.hpp"
#include "tests/support/points3.hpp"

namespace wellspaced {
namespace {

bool is_permutation_of_numbers(std::vector<Index> order) {
  std::sort(order.begin(), order.end());
  for (Index i = 0; i < order.size(); ++i)
    if (order[i] != i) return false;
  return true;
}

TEST(PointOrder, HilbertCurveOfThePlaneStepsBetweenNeighbouringCells) {
  std::vector<Point2> points;
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y) points.push_back({x * (65536.0 / 63), y * (65536.0 / 63)});
  const auto order = hilbert_order(points);
  ASSERT_TRUE(is_permutation_of_numbers(order));
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto cell = [&](Index v) { return std::pair<int, int>(v / 64, v % 64); };
    const auto [x, y] = cell(order[i - 1]);
    const auto [u, v] = cell(order[i]);
    EXPECT_EQ(std::abs(x - u) + std::abs(y - v), 1);
  }
}

TEST(PointOrder, HilbertCurveOfSpaceStepsBetweenNeighbouringCells) {
  const auto points = test::lattice3(16, 16, 16);
  const auto order = hilbert_order(points);
  ASSERT_TRUE(is_permutation_of_numbers(order));
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point3 p = points[order[i - 1]], q = points[order[i]];
    EXPECT_EQ(std::fabs(p.x - q.x) + std::fabs(p.y - q.y) + std::fabs(p.z - q.z), 1);
  }
}

TEST(PointOrder, OrdersHoldEveryPointOnceForEveryDegenerateFamily) {
  for (const auto& [name, points] : test::degenerate_sets3()) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(is_permutation_of_numbers(hilbert_order(points)));
    EXPECT_TRUE(is_permutation_of_numbers(insertion_order(points)));
  }
  EXPECT_TRUE(hilbert_order(std::vector<Point3>{}).empty());
}

TEST(PointOrder, TheRoundsOfAHilbertOrderAreThoseOfThePoints) {
  const auto points = test::uniform_points(5000, 4);
  EXPECT_EQ(insertion_order(hilbert_order(points)), insertion_order(points));
  EXPECT_TRUE(insertion_order(std::vector<Index>{}).empty());
}

TEST(PointOrder, RunsCutEveryRoundAtTheSamePlacesOfTheCurve) {
  const auto points = test::uniform3(20000, 4);
  const InsertionRuns runs = insertion_runs(points, 2);
  EXPECT_EQ(runs.order, insertion_order(points));
  ASSERT_EQ(runs.ends.back(), points.size());
  ASSERT_TRUE(std::is_sorted(runs.ends.begin(), runs.ends.end()));
  std::vector<Index> place(points.size());
  const auto along_curve = hilbert_order(points);
  for (Index i = 0; i < along_curve.size(); ++i) place[along_curve[i]] = i;
  Index last_of_first = 0, first_of_second = kNoIndex, v = 0;
  for (std::size_t run = 0; run < runs.ends.size(); ++run) {
    for (; v < runs.ends[run]; ++v) {
      const Index i = place[runs.order[v]];
      if (run % 2 == 0)
        last_of_first = std::max(last_of_first, i);
      else
        first_of_second = std::min(first_of_second, i);
    }
  }
  EXPECT_EQ(last_of_first + 1, first_of_second);
}

TEST(PointOrder, RunsOfTheLastRoundAreEven) {
  const InsertionRuns runs = insertion_runs(test::uniform3(20000, 5), 4);
  const Index* const last = &runs.ends[runs.ends.size() - 5];
  for (int r = 0; r < 4; ++r) EXPECT_NEAR(last[r + 1] - last[r], (last[4] - last[0]) / 4.0, 16);
}

TEST(PointOrder, RunsOfEqualPointsHoldEachOnce) {
  const InsertionRuns runs = insertion_runs(std::vector<Point3>(5000, Point3{1, 2, 3}), 8);
  EXPECT_TRUE(is_permutation_of_numbers(runs.order));
  EXPECT_TRUE(std::is_sorted(runs.ends.begin(), runs.ends.end()));
  EXPECT_EQ(runs.ends.back(), 5000u);
  EXPECT_TRUE(insertion_runs(std::vector<Point3>{}, 8).ends.empty());
}

TEST(PointOrder, EqualPointsKeepTheirOrder) {
  const auto order = hilbert_order(std::vector<Point3>(100, Point3{1, 2, 3}));
  for (Index i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(PointOrder, CrowdsInACornerAreOrderedAsWellAsTheRest) {
  // Half of the points in a cube 2^-40 as wide: steps within it must be as short as its own scale.
  std::vector<Point3> points = test::uniform3(4096, 1);
  for (const Point3 p : test::scaled(test::uniform3(4096, 2), 0x1p-40)) points.push_back(p);
  const auto order = hilbert_order(points);
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i - 1] < 4096 || order[i] < 4096) continue;
    const Point3 p = points[order[i - 1]], q = points[order[i]];
    length += std::fabs(p.x - q.x) + std::fabs(p.y - q.y) + std::fabs(p.z - q.z);
  }
  EXPECT_LT(length, 4096 * 0x1p-40 / 8);
}

}  // namespace
}  // namespace wellspaced
