#include "wellspaced/algorithms/generate/points3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "wellspaced/kernel/space/delaunay3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

namespace wellspaced {
namespace {

std::size_t tet_count(const std::vector<Point3>& points) {
  const auto built = Delaunay3::build(points);
  return built.ok() ? real_tets(*built).size() : 0;
}

TEST(Points3, BoxPointsFillTheUnitCubeEvenly) {
  std::array<int, 8> octants{};
  for (const Point3 p : box_points3(80000, 7)) {
    ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 && p.z >= 0 && p.z < 1);
    ++octants[(p.x < 0.5) + 2 * (p.y < 0.5) + 4 * (p.z < 0.5)];
  }
  for (const int count : octants) EXPECT_NEAR(count, 10000, 500);
}

TEST(Points3, SeedsDecideThePoints) {
  EXPECT_EQ(box_points3(100, 3), box_points3(100, 3));
  EXPECT_NE(box_points3(100, 3), box_points3(100, 4));
  EXPECT_NE(sphere_points3(100, 3), sphere_points3(100, 4));
}

TEST(Points3, LatticeHasEveryPointOnce) {
  const auto points = lattice_points3(3, 4, 5);
  ASSERT_EQ(points.size(), 60u);
  EXPECT_EQ(points[0], (Point3{0, 0, 0}));
  EXPECT_EQ(points[1], (Point3{0, 0, 1}));
  EXPECT_EQ(points[5], (Point3{0, 1, 0}));
  EXPECT_EQ(points[59], (Point3{2, 3, 4}));
}

TEST(Points3, SpherePointsLieOnTheSphereEvenlyUpToRounding) {
  Point3 mean;
  for (const Point3 p : sphere_points3(10000, 1)) {
    EXPECT_NEAR(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z), 1, 1e-15);
    mean = {mean.x + p.x / 1e4, mean.y + p.y / 1e4, mean.z + p.z / 1e4};
  }
  EXPECT_NEAR(mean.x, 0, 0.03);
  EXPECT_NEAR(mean.y, 0, 0.03);
  EXPECT_NEAR(mean.z, 0, 0.03);
}

TEST(Points3, MomentCurveHasAsManyTetsAsPointsCanHave) {
  EXPECT_EQ(moment_points3(5).front(), (Point3{-2, 4, -8}));
  EXPECT_EQ(tet_count(moment_points3(40)), 38u * 37 / 2);  // of a cyclic polytope's lower side
}

TEST(Points3, LinesHaveTheProductOfTheirSegments) {
  EXPECT_EQ(tet_count(line_points3(40)), 39u * 39);
}

TEST(Points3, HelixRises) {
  const auto points = helix_points3(9, 4, 2);
  EXPECT_EQ(points[0], (Point3{1, 0, 0}));
  EXPECT_EQ(points[1], (Point3{0, 1, 0.5}));
  EXPECT_EQ(points[8], (Point3{1, 0, 4}));
}

TEST(Points3, ShufflingKeepsThePoints) {
  auto points = box_points3(100, 1);
  const auto original = points;
  shuffle_points(points, 2);
  EXPECT_NE(points, original);
  EXPECT_TRUE(std::is_permutation(points.begin(), points.end(), original.begin()));
}

}  // namespace
}  // namespace wellspaced
