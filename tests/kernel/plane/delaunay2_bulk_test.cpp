// The bulk insertion of Delaunay2::build. Up to 2,000 points, which make one round, go in by the
// order of the curve that is given: here that of their numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/support/triangulation_checks.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"

namespace wellspaced {
namespace {

Delaunay2 build_in_order(const std::vector<Point2>& points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  return *Delaunay2::build(points, order);
}

// Every point lies beyond the hull of those before it, so all goes by way of ghosts; at the ends of
// the range the square that the ghost is seen with overflows and underflows.
TEST(Delaunay2Bulk, TakesPointsBeyondTheHullFromTheLeastToTheLargestDouble) {
  const int steps[][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (const int exponent : {-1074, -1060, -600, -500, 0, 300, 500, 600, 1017}) {
    std::vector<Point2> points;
    for (int i = 0; i < 32; ++i) {
      const double radius = 1 + i / 8;
      points.push_back({std::ldexp(radius * steps[3 * i % 8][0], exponent),
                        std::ldexp(radius * steps[3 * i % 8][1], exponent)});
    }
    SCOPED_TRACE(exponent);
    const Delaunay2 dt = build_in_order(points);
    EXPECT_TRUE(test::is_constrained_delaunay(dt));
    EXPECT_EQ(dt.topology().size(), 62u);
  }
}

// The centre of a circle, inserted last, is joined to all points on it.
TEST(Delaunay2Bulk, FillsStarsLargerThanUsual) {
  std::vector<Point2> points;
  for (int i = 0; i < 400; ++i) {
    const double t = (i + 0.5) / 200 - 1;
    const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    points.push_back({x, y});
    points.push_back({-x, -y});
  }
  points.push_back({0, 0});
  const Delaunay2 dt = build_in_order(points);
  EXPECT_TRUE(test::is_constrained_delaunay(dt));
  EXPECT_EQ(dt.topology().size(), 1600u);
  EXPECT_EQ(dt.topology().degree(dt.edge_from(800)), 800u);
}

TEST(Delaunay2Bulk, ReportsPointsThatEqualAVertex) {
  const std::vector<Point2> points{{0, 0},    {4, 0}, {0, 4}, {1, 1}, {4, 0},
                                   {-0.0, 0}, {1, 1}, {5, 5}, {0, 4}};
  const Delaunay2 dt = build_in_order(points);
  EXPECT_TRUE(test::is_constrained_delaunay(dt));
  const Index expected[] = {0, 1, 2, 3, 1, 0, 3, 7, 2};
  for (Index i = 0; i < points.size(); ++i) EXPECT_EQ(dt.representative(i), expected[i]);
}

// Neighbouring doubles around 1, in an order that makes the walk long, and cocircular besides.
TEST(Delaunay2Bulk, TellsApartNeighbouringDoublesOnALattice) {
  std::vector<Point2> points;
  for (int i = 0; i < 400; ++i) {
    const int k = 147 * i % 400;
    points.push_back({1 + k % 20 * 0x1p-52, 1 + k / 20 * 0x1p-52});
  }
  const Delaunay2 dt = build_in_order(points);
  EXPECT_TRUE(test::is_constrained_delaunay(dt));
  EXPECT_EQ(dt.topology().size(), 798u);
}

}  // namespace
}  // namespace wellspaced
