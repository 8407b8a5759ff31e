#include "wellspaced/algorithms/packing/background_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/point_families.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

BackgroundSize background(const std::vector<Point2>& points, const std::vector<double>& values) {
  auto result = BackgroundSize::build(points, values);
  EXPECT_TRUE(result.ok());
  return std::move(*result);
}

TEST(BackgroundSize, InterpolatesLinearly) {
  BackgroundSize size = background({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {1, 1.5, 2, 1.5});
  for (const Point2 x : test::uniform_points(100, 1))
    EXPECT_NEAR(size(x), 1 + (x.x + x.y) / 2, 1e-15);
}

TEST(BackgroundSize, GrowsByAtMostTheDistanceFromPointToPoint) {
  const std::vector<Point2> points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  BackgroundSize size = background(points, {0.1, 50, 50, 50});
  EXPECT_EQ(size(points[0]), 0.1);
  EXPECT_NEAR(size(points[1]), 1.1, 1e-15);
  EXPECT_NEAR(size(points[3]), 0.1 + std::sqrt(2.0), 1e-15);
}

TEST(BackgroundSize, GoesOnBeyondTheHull) {
  BackgroundSize size = background({{0, 0}, {1, 0}, {0, 1}}, {0.25, 0.5, 0.5});
  EXPECT_EQ(size({-3, 0}), 3.25);
  EXPECT_EQ(size({2, 0}), 1.5);
}

TEST(BackgroundSize, TakesPointsOnALine) {
  BackgroundSize size = background({{0, 0}, {1, 0}, {2, 0}}, {0.5, 0.25, 0.5});
  EXPECT_EQ(size({1, 0.5}), 0.75);
  EXPECT_EQ(background({{5, 5}}, {2})({5, 8}), 5);
}

TEST(BackgroundSize, RefusesWhatIsNoSize) {
  const std::vector<Point2> points = {{0, 0}, {1, 0}, {0, 1}};
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const auto result = BackgroundSize::build(points, std::vector<double>{1, bad, 1});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kUsage);
    EXPECT_EQ(result.error().ids, std::vector<Index>{1});
  }
  EXPECT_FALSE(BackgroundSize::build(points, std::vector<double>{1, 1}).ok());
  EXPECT_FALSE(BackgroundSize::build({}, {}).ok());
}

}  // namespace
}  // namespace wellspaced
