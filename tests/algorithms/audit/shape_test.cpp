#include "wellspaced/algorithms/audit/shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/algorithms/audit/interval_counts.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using audit::triangle_shape;

constexpr double kFarAway = std::numeric_limits<double>::infinity();

TEST(TriangleShape, AnEquilateralTriangleIsTheBestByEveryMeasure) {
  const auto shape = triangle_shape({0, 0}, {2, 0}, {1, std::sqrt(3.0)});
  EXPECT_NEAR(shape.min_angle, 60, 1e-12);
  EXPECT_NEAR(shape.max_angle, 60, 1e-12);
  EXPECT_NEAR(shape.aspect_ratio, 2, 1e-14);
  EXPECT_NEAR(shape.circumradius_to_inradius, 2, 1e-14);
  EXPECT_NEAR(shape.radius_edge, 1 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(shape.edge_to_height, 2 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(shape.area, std::sqrt(3.0), 1e-14);
}

TEST(TriangleShape, ARightTriangleHasItsLongestEdgeForADiameter) {
  const auto shape = triangle_shape({0, 0}, {3, 0}, {0, 4});
  EXPECT_EQ(shape.max_angle, 90);
  EXPECT_NEAR(shape.min_angle, std::atan2(3, 4) * 57.29577951308232, 1e-12);
  EXPECT_NEAR(shape.aspect_ratio, 2.5 / 1, 1e-14);
  EXPECT_NEAR(shape.radius_edge, 2.5 / 3, 1e-14);
  EXPECT_NEAR(shape.edge_to_height, 5 / 2.4, 1e-14);
  EXPECT_EQ(shape.shortest_edge, 3);
  EXPECT_EQ(shape.longest_edge, 5);
}

TEST(TriangleShape, AnObtuseTriangleFitsADiscSmallerThanItsCircumscribedOne) {
  const auto shape = triangle_shape({-8, 0}, {8, 0}, {0, 1});
  EXPECT_NEAR(shape.circumradius_to_inradius / shape.aspect_ratio, 32.5 / 8, 1e-12);
  EXPECT_NEAR(shape.radius_edge, 32.5 / std::sqrt(65.0), 1e-12);
}

TEST(IntervalCounts, AreThoseOfASearchAmongTheThresholds) {
  const std::array<double, 9> thresholds = {-3.5, -1.75, -1e-300, 0, 0.125, 2.5, 3, 1000, 1e300};
  std::vector<double> values(thresholds.begin(), thresholds.end());
  for (const double t : thresholds)
    for (const double to : {-kFarAway, kFarAway}) values.push_back(std::nextafter(t, to));
  values.insert(values.end(), {-kFarAway, kFarAway, -0.0, 5e-324, -5e-324, 1e-310, 2.75, -2});
  Random random(3);
  for (int i = 0; i < 10000; ++i)
    values.push_back(std::ldexp(random.uniform() - 0.5, static_cast<int>(random.below(40)) - 20));
  audit::IntervalCounts<9> counts(thresholds);
  std::vector<std::uint64_t> expected(10, 0);
  for (const double v : values) {
    counts.add(v);
    ++expected[std::upper_bound(thresholds.begin(), thresholds.end(), v) - thresholds.begin()];
  }
  counts.add(std::numeric_limits<double>::quiet_NaN());
  ++expected[0];
  EXPECT_EQ(counts.histogram("x", {}).counts, expected);
}

TEST(TriangleShape, RatiosDoNotDependOnTheScale) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    std::array<Point2, 3> p;
    for (Point2& q : p) q = {random.uniform(), random.uniform()};
    const auto shape = triangle_shape(p[0], p[1], p[2]);
    for (const double scale : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
      const auto other =
          triangle_shape({p[0].x * scale, p[0].y * scale}, {p[1].x * scale, p[1].y * scale},
                         {p[2].x * scale, p[2].y * scale});
      EXPECT_NEAR(other.min_angle, shape.min_angle, 1e-9);
      EXPECT_NEAR(other.aspect_ratio / shape.aspect_ratio, 1, 1e-9);
      EXPECT_NEAR(other.radius_edge / shape.radius_edge, 1, 1e-9);
      EXPECT_NEAR(other.longest_edge / scale, shape.longest_edge, 1e-12);
    }
  }
}

TEST(TriangleShape, AFlatTriangleIsInfinitelyBad) {
  const auto shape = triangle_shape({0, 0}, {1, 1}, {3, 3});
  EXPECT_EQ(shape.min_angle, 0);
  EXPECT_EQ(shape.max_angle, 180);
  EXPECT_TRUE(std::isinf(shape.aspect_ratio));
  EXPECT_TRUE(std::isinf(shape.radius_edge));
  EXPECT_EQ(shape.area, 0);
}

TEST(Shape, AGridHasTheFiguresThatItsSizesGive) {
  const auto report = audit::audit_mesh(generate_grid({.nx = 11, .ny = 6, .aspect = 2}).value());
  const auto measured = [&](const char* name) { return report.measure(name)->value; };
  EXPECT_EQ(measured("area"), 100);
  EXPECT_EQ(measured("perimeter"), 40);
  EXPECT_EQ(measured("shortest_edge"), 1);
  EXPECT_NEAR(measured("gradation"), std::log2(std::sqrt(5.0)), 1e-14);
  EXPECT_EQ(measured("max_angle"), 90);
  EXPECT_NEAR(measured("min_angle"), std::atan(0.5) * 57.29577951308232, 1e-12);
}

// The histogram is found by a guess that is put right; this counts the slow way.
TEST(Shape, TheHistogramCountsEveryAngleInItsInterval) {
  const TriangleMesh mesh = test::random_mesh(2000, 9);
  const auto report = audit::audit_mesh(mesh);
  std::vector<std::uint64_t> counts(18, 0);
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Point2 p = mesh.points[t[i]], q = mesh.points[t[(i + 1) % 3]];
      const Point2 r = mesh.points[t[(i + 2) % 3]];
      const double angle = std::atan2((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x),
                                      (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y));
      ++counts[static_cast<std::size_t>(angle * 57.29577951308232 / 10)];
    }
  }
  EXPECT_EQ(report.histograms.at(0).counts, counts);
}

TEST(Shape, TheWorstTrianglesAreListedWorstFirst) {
  const TriangleMesh mesh = test::random_mesh(500, 11);
  const auto report = audit::audit_mesh(mesh);
  const auto& worst = report.worst.at(0);
  ASSERT_EQ(worst.measure, "min_angle");
  ASSERT_EQ(worst.ids.size(), 10u);
  EXPECT_TRUE(std::is_sorted(worst.values.begin(), worst.values.end()));
  EXPECT_EQ(worst.values[0], report.measure("min_angle")->value);
  const auto& t = mesh.triangles[worst.ids[0]];
  EXPECT_NEAR(triangle_shape(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]).min_angle,
              worst.values[0], 1e-12);
}

}  // namespace
}  // namespace wellspaced
