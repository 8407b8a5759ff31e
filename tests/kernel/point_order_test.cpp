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
