#include "wellspaced/algorithms/generate/point_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace wellspaced {
namespace {

double norm(Point2 p) { return std::sqrt(p.x * p.x + p.y * p.y); }

bool before(Point2 p, Point2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

std::size_t count_distinct(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(), before);
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

TEST(PointSets, RandomPointsFillTheUnitSquareEvenly) {
  const auto points = random_points(100000, 7);
  int quadrants[4] = {};
  for (Point2 p : points) {
    ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
    ++quadrants[(p.x < 0.5 ? 0 : 1) + (p.y < 0.5 ? 0 : 2)];
  }
  for (int count : quadrants) EXPECT_NEAR(count, 25000, 600);
}

TEST(PointSets, SeedsDecideThePoints) {
  EXPECT_EQ(random_points(100, 3), random_points(100, 3));
  EXPECT_NE(random_points(100, 3), random_points(100, 4));
  EXPECT_NE(clustered_points(100, 5, 3), clustered_points(100, 5, 4));
}

TEST(PointSets, ClustersHaveTheDeviationOfTheNormalLaw) {
  const auto points = clustered_points(100000, 1, 5);
  Point2 mean;
  for (Point2 p : points) mean = {mean.x + p.x / 1e5, mean.y + p.y / 1e5};
  double variance = 0, within_one_deviation = 0;
  for (Point2 p : points) {
    variance += (p.x - mean.x) * (p.x - mean.x) / 1e5;
    if (std::abs(p.y - mean.y) < 0.01) within_one_deviation += 1e-5;
  }
  EXPECT_NEAR(variance, 1e-4, 2e-6);
  EXPECT_NEAR(within_one_deviation, 0.6827, 0.01);
}

TEST(PointSets, CirclePointsLieOnTheCircleThenInside) {
  const auto points = circle_points(1000, 2000, 1);
  ASSERT_EQ(points.size(), 3000u);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_NEAR(norm(points[i]), 1, 1e-15);
  for (std::size_t i = 1000; i < 3000; ++i) EXPECT_LE(norm(points[i]), 0.9991);
}

TEST(PointSets, ASpiralGrowsByTheGivenOctaves) {
  const auto points = spiral_points(1001, 40);
  EXPECT_EQ(points.front(), (Point2{1, 0}));
  EXPECT_NEAR(norm(points.back()) / 0x1p40, 1, 1e-14);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_NEAR(norm(points[i]) / norm(points[i - 1]), std::exp2(0.04), 1e-12);
}

TEST(PointSets, GridPointsRunRowByRow) {
  EXPECT_EQ(grid_points(2, 2), (std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
}

TEST(PointSets, ParabolaPointsLieOnTheParabola) {
  EXPECT_EQ(parabola_points(4), (std::vector<Point2>{{-2, 4}, {-1, 1}, {0, 0}, {1, 1}}));
}

TEST(PointSets, OnlyTheLastPointLeavesTheLine) {
  EXPECT_EQ(collinear_points_and_one(3), (std::vector<Point2>{{0, 0}, {1, 3}, {2, 6}, {0, 1}}));
}

TEST(PointSets, RepeatedPointsAreCopiesOfFew) {
  EXPECT_EQ(count_distinct(repeated_points(10000, 10, 1)), 10u);
}

TEST(PointSets, ShufflingPermutes) {
  auto points = grid_points(30, 30);
  const auto in_rows = points;
  shuffle_points(points, 1);
  EXPECT_NE(points, in_rows);
  EXPECT_TRUE(std::is_permutation(points.begin(), points.end(), in_rows.begin()));
}

TEST(PointSets, EmptySetsAreEmpty) {
  EXPECT_TRUE(random_points(0, 1).empty());
  EXPECT_TRUE(spiral_points(0, 40).empty());
  EXPECT_TRUE(parabola_points(0).empty());
}

}  // namespace
}  // namespace wellspaced
