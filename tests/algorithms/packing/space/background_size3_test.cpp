#include "wellspaced/algorithms/packing/space/background_size3.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

std::vector<Point3> points_in_cube(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

std::vector<Point3> cube_corners() {
  std::vector<Point3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  return corners;
}

BackgroundSize3 background(const std::vector<Point3>& points, const std::vector<double>& values,
                           double slope) {
  auto result = BackgroundSize3::build(points, values, slope);
  EXPECT_TRUE(result.ok());
  return std::move(*result);
}

TEST(BackgroundSize3, InterpolatesLinearly) {
  std::vector<double> values;
  for (const Point3 p : cube_corners()) values.push_back(1 + (p.x + 2 * p.y + 3 * p.z) / 8);
  BackgroundSize3 size = background(cube_corners(), values, 0.5);
  for (const Point3 p : points_in_cube(100, 1))
    EXPECT_NEAR(size(p), 1 + (p.x + 2 * p.y + 3 * p.z) / 8, 1e-15);
  EXPECT_NEAR(size.steepest(), std::sqrt(14.0) / 8, 1e-12);
}

TEST(BackgroundSize3, GrowsByAtMostTheSlopeAlongEdges) {
  std::vector<double> values(8, 50);
  values[0] = 0.1;
  BackgroundSize3 size = background(cube_corners(), values, 0.2);
  EXPECT_EQ(size({0, 0, 0}), 0.1);
  EXPECT_NEAR(size({1, 0, 0}), 0.3, 1e-15);
  EXPECT_GE(size({1, 1, 1}), 0.1 + 0.2 * std::sqrt(3.0) - 1e-12);
  EXPECT_LE(size({1, 1, 1}), 0.7 + 1e-12);
}

// The difference of any two places, against the steepest slope.
TEST(BackgroundSize3, IsNowhereSteeperThanItSays) {
  const std::vector<Point3> points = points_in_cube(300, 2);
  Random random(3);
  std::vector<double> values(points.size());
  for (double& value : values) value = random.uniform(0.01, 1);
  BackgroundSize3 size = background(points, values, 0.2);
  const double steepest = size.steepest();
  EXPECT_GT(steepest, 0.2);
  const std::vector<Point3> places = points_in_cube(400, 4);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Point3 near = places[i] + 0.01 * (places[i - 1] - places[i]);
    EXPECT_LE(std::fabs(size(near) - size(places[i])),
              steepest * length(near - places[i]) * (1 + 1e-9));
  }
}

TEST(BackgroundSize3, GoesOnBeyondTheHullWithoutAJump) {
  BackgroundSize3 size = background(cube_corners(), std::vector<double>(8, 0.25), 0.2);
  EXPECT_NEAR(size({0.5, 0.5, 1 + 1e-9}), 0.25, 1e-8);
  EXPECT_GT(size({2, 0.5, 0.5}), 0.26);
  EXPECT_LT(size({2, 0.5, 0.5}), 1);
  EXPECT_GE(size({1000, 0, 0}), 0.25);
}

TEST(BackgroundSize3, CoversTheHullOfItsPoints) {
  const BackgroundSize3 size = background(cube_corners(), std::vector<double>(8, 0.25), 0.2);
  for (const Point3 p : points_in_cube(50, 5)) EXPECT_TRUE(size.covers(p));
  for (const Point3 p : cube_corners()) EXPECT_TRUE(size.covers(p));
  EXPECT_TRUE(size.covers({0.3, 0.4, 1}));
  EXPECT_FALSE(size.covers({0.3, 0.4, 1.0000001}));
  EXPECT_FALSE(size.covers({-1, 0, 0}));
  EXPECT_FALSE(size.covers({-1000, 0, 0}));
}

TEST(BackgroundSize3, TakesPointsThatSpanNoVolume) {
  EXPECT_NEAR(background({{5, 5, 5}}, {2}, 0.2)({5, 5, 5}), 2, 1e-12);
  BackgroundSize3 flat = background({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {1, 1, 3, 1}, 1);
  EXPECT_NEAR(flat({0.25, 0.25, 0}), 1, 1e-12);
  EXPECT_NEAR(flat({0, 1, 0}), 1, 1e-12) << "of coincident points the smallest counts";
}

TEST(BackgroundSize3, RefusesWhatIsNoSize) {
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    std::vector<double> values(8, 1);
    values[3] = bad;
    const auto result = BackgroundSize3::build(cube_corners(), values, 0.2);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::kUsage);
    EXPECT_EQ(result.error().ids, std::vector<Index>{3});
  }
  EXPECT_FALSE(BackgroundSize3::build(cube_corners(), std::vector<double>(7, 1), 0.2).ok());
  EXPECT_FALSE(BackgroundSize3::build({}, {}, 0.2).ok());
  std::vector<Point3> nowhere = cube_corners();
  nowhere[2].y = NAN;
  EXPECT_FALSE(BackgroundSize3::build(nowhere, std::vector<double>(8, 1), 0.2).ok());
}

}  // namespace
}  // namespace wellspaced
