#include "wellspaced/algorithms/coarsening/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"

namespace wellspaced {
namespace {

TEST(AngleStatistics, AUniformGridHasAnglesOf45And90Degrees) {
  const auto mesh = generate_grid({.nx = 10, .ny = 10}).value();
  const AngleStatistics angles = angle_statistics(mesh);
  EXPECT_EQ(angles.interior_min_deg, 45.0);
  EXPECT_EQ(angles.boundary_min_deg, 45.0);
  EXPECT_EQ(angles.max_deg, 90.0);
  EXPECT_EQ(angles.interior_le_10 + angles.boundary_le_10, 0u);
}

TEST(AngleStatistics, GridOfAspect10HasTheSmallAnglesOfTable84) {
  const auto mesh = generate_grid({.nx = 1000, .ny = 1000, .aspect = 10}).value();
  const AngleStatistics angles = angle_statistics(mesh);
  EXPECT_NEAR(angles.interior_min_deg.value(), 5.71, 0.005);
  EXPECT_NEAR(angles.boundary_min_deg.value(), 5.71, 0.005);
  // The table prints the sums over five runs.
  EXPECT_EQ(5 * angles.interior_le_10, 9940090u);
  EXPECT_EQ(5 * angles.boundary_le_10, 39920u);
}

TEST(AngleStatistics, TrianglesWithANodeOnASegmentAreBoundaryTriangles) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {0, 4}, {10, 10}, {20, 10}, {10, 11}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  mesh.segments = {{5, 3, 1}};
  const AngleStatistics angles = angle_statistics(mesh);
  EXPECT_EQ(angles.interior_min_deg, 45.0);
  EXPECT_NEAR(angles.boundary_min_deg.value(), std::atan(0.1) * 57.29577951308232, 1e-12);
  EXPECT_EQ(angles.interior_le_10, 0u);
  EXPECT_EQ(angles.boundary_le_10, 1u);
}

TEST(AngleStatistics, AFlatTriangleHasTheAngles0And180) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}};
  mesh.triangles = {{0, 1, 2}};
  const AngleStatistics angles = angle_statistics(mesh);
  EXPECT_EQ(angles.interior_min_deg, 0.0);
  EXPECT_EQ(angles.max_deg, 180.0);
  EXPECT_EQ(angles.interior_le_10, 2u);
}

TEST(AngleStatistics, AMeshWithoutTrianglesHasNone) {
  const AngleStatistics angles = angle_statistics({});
  EXPECT_FALSE(angles.interior_min_deg || angles.boundary_min_deg || angles.max_deg);
}

TEST(Gradation, IsTheBinaryLogarithmOfLongestOverShortestEdge) {
  EXPECT_EQ(gradation(generate_grid({.nx = 5, .ny = 5}).value()), 0.5);
  EXPECT_NEAR(gradation(generate_grid({.nx = 5, .ny = 5, .aspect = 10}).value()).value(),
              std::log2(std::sqrt(101.0)), 1e-14);
  EXPECT_FALSE(gradation({}).has_value());
}

TEST(HierarchyStatistics, GivesEveryLevelItsRow) {
  CoarseningOptions options;
  options.factor = 2;
  options.count_work = true;
  const Hierarchy hierarchy = coarsen(generate_grid({.nx = 40, .ny = 40}).value(), options).value();
  const auto rows = hierarchy_statistics(hierarchy);
  ASSERT_EQ(rows.size(), hierarchy.levels.size());
  ASSERT_GE(rows.size(), 3u);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].nodes, hierarchy.levels[k].mesh.points.size());
    EXPECT_EQ(rows[k].triangles, hierarchy.levels[k].mesh.triangles.size());
    EXPECT_EQ(rows[k].boundary_edges, hierarchy.levels[k].mesh.segments.size());
    EXPECT_EQ(rows[k].intersection.has_value(), k > 0);
    const bool has_next = k + 1 < rows.size();
    EXPECT_EQ(rows[k].search.has_value(), has_next);
    EXPECT_EQ(rows[k].edge_search.has_value(), has_next);
    EXPECT_EQ(rows[k].path_depth.has_value(), has_next);
  }
}

TEST(HierarchyStatistics, IntersectionCountsTheFinerTrianglesThatATriangleMeets) {
  Hierarchy hierarchy;
  hierarchy.levels.resize(2);
  hierarchy.levels[0].mesh = generate_grid({.nx = 3, .ny = 3}).value();
  hierarchy.levels[1].mesh.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  hierarchy.levels[1].mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  hierarchy.levels[1].parent = {0, 2, 8, 6};
  const auto rows = hierarchy_statistics(hierarchy);
  ASSERT_TRUE(rows[1].intersection.has_value());
  EXPECT_EQ(rows[1].intersection->mean, 4);
  EXPECT_EQ(rows[1].intersection->max, 4u);
}

TEST(HierarchyStatistics, MisHasNoPathsAndNoSearches) {
  CoarseningOptions options;
  options.method = CoarseningMethod::kMis;
  options.count_work = true;
  const auto rows =
      hierarchy_statistics(coarsen(generate_grid({.nx = 20, .ny = 20}).value(), options).value());
  EXPECT_FALSE(rows[0].path_depth || rows[0].search);
  EXPECT_TRUE(rows[0].edge_search.has_value());
}

}  // namespace
}  // namespace wellspaced
