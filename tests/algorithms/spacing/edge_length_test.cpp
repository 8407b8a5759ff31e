#include "wellspaced/algorithms/spacing/edge_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

TriangleMesh two_triangles() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {4, 3}, {5, 0}, {9, 9}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  return mesh;
}

TEST(EdgeLengthFunction, IsTheLongestEdgeOfTheTrianglesAroundAPlace) {
  const TriangleMesh mesh = two_triangles();
  const EdgeLengthFunction el(mesh);
  EXPECT_EQ(el({3, 1}), 5);                   // inside the first
  EXPECT_EQ(el({4.5, 0.5}), std::sqrt(10.));  // inside the second
  EXPECT_EQ(el({4, 1}), 5);                   // on their common edge
  EXPECT_EQ(el({5, 0}), std::sqrt(10.));      // at a node of the second alone
  EXPECT_EQ(el({0, 1}), 0);                   // outside
}

TEST(EdgeLengthSpacing, IsTheFunctionAtTheNodesAndZeroAtNodesInNoTriangle) {
  const TriangleMesh mesh = two_triangles();
  EXPECT_EQ(edge_length_spacing(mesh), (std::vector<double>{5, 5, 5, std::sqrt(10.), 0}));
  const TriangleMesh grid = test::grid_mesh({.nx = 9, .ny = 7, .hole = 0.2, .seed = 4});
  const EdgeLengthFunction el(grid);
  const std::vector<double> values = edge_length_spacing(grid);
  for (std::size_t v = 0; v < grid.points.size(); ++v) EXPECT_EQ(values[v], el(grid.points[v]));
}

}  // namespace
}  // namespace wellspaced
