#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/point_families.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// The second smallest distance, equal places counted once.
double slow_nearest_neighbor(std::vector<Point2> points, Point2 x) {
  const auto less = [](Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return HUGE_VAL;
  std::vector<double> distances;
  for (const Point2 p : points) distances.push_back(distance(x, p));
  std::nth_element(distances.begin(), distances.begin() + 1, distances.end());
  return distances[1];
}

TEST(NearestNeighborFunction, IsTheRadiusOfTheSmallestBallWithTwoPoints) {
  for (const auto& [name, points] : test::point_families(80, 5)) {
    const NearestNeighborFunction nn(points);
    const std::vector<double> values = nn.at_points();
    for (std::size_t v = 0; v < points.size(); ++v) {
      const double expected = slow_nearest_neighbor(points, points[v]);
      ASSERT_DOUBLE_EQ(values[v], expected) << name;
      ASSERT_DOUBLE_EQ(nn(points[v]), expected) << name;
    }
    const Point2 far{points[0].x * 2 - points[1].x, points[0].y};
    ASSERT_DOUBLE_EQ(nn(far), slow_nearest_neighbor(points, far)) << name;
  }
}

TEST(NearestNeighborFunction, IsInfiniteForFewerThanTwoPlaces) {
  EXPECT_EQ(NearestNeighborFunction({})({0, 0}), HUGE_VAL);
  const std::vector<Point2> twice = {{1, 1}, {1, 1}};
  EXPECT_EQ(NearestNeighborFunction(twice)({0, 0}), HUGE_VAL);
  EXPECT_EQ(nearest_neighbor_spacing(twice), (std::vector<double>{HUGE_VAL, HUGE_VAL}));
}

// Definition 2.2.1.
TEST(NearestNeighborFunction, IsOneLipschitz) {
  const std::vector<Point2> points = test::uniform_points(300, 6);
  const NearestNeighborFunction nn(points);
  Random random(7);
  for (int trial = 0; trial < 1000; ++trial) {
    const Point2 x{random.uniform(-1, 2), random.uniform(-1, 2)};
    const Point2 y{x.x + random.uniform(-0.1, 0.1), x.y + random.uniform(-0.1, 0.1)};
    EXPECT_LE(std::fabs(nn(x) - nn(y)), distance(x, y) * (1 + 1e-12));
  }
}

// Lemma 2.4.2.
TEST(NearestNeighborFunction, SpacesThePointsByTwo) {
  const std::vector<Point2> points = test::uniform_points(150, 8);
  const std::vector<double> nn = nearest_neighbor_spacing(points);
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      EXPECT_LE(nn[p] / 2 + nn[q] / 2, distance(points[p], points[q]) * (1 + 1e-15));
}

// Where the mesh is not Delaunay, the nearest neighbour need not be a neighbour in it.
TEST(NearestNeighborFunction, FindsNeighborsThatNoEdgeLeadsTo) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {10, 1}, {20, 0}, {10, -1}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  EXPECT_EQ(nearest_neighbor_spacing(mesh.points)[1], 2);
  EXPECT_GT(mesh_spacing(mesh_graph(mesh))[1], 5);
}

}  // namespace
}  // namespace wellspaced
