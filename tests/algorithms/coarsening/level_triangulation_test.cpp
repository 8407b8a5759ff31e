#include "wellspaced/algorithms/coarsening/level_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/mesh_checker.hpp"

namespace wellspaced {
namespace {

using Kind = ConstrainedEdge::Kind;
using Edges = std::vector<ConstrainedEdge>;

void add_loop(Edges& edges, const std::vector<Index>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    edges.push_back({nodes[i], nodes[(i + 1) % nodes.size()], 1, Kind::kDomain});
}

TriangleMesh triangulated(const std::vector<Point2>& points, const Edges& edges) {
  auto result = triangulate_domain(points, edges);
  EXPECT_TRUE(result.ok());
  if (!result) return {};
  return {points, result->triangles, result->segments, {}, {}};
}

void expect_valid(const TriangleMesh& mesh, double area) {
  test::MeshChecker checker(mesh);
  EXPECT_EQ(checker.check_validity(), std::vector<std::string>());
  EXPECT_EQ(checker.check_constrained_delaunay(), std::vector<std::string>());
  EXPECT_DOUBLE_EQ(checker.twice_area(), 2 * area);
}

const std::vector<Point2> kSquareAndHole = {{0, 0}, {9, 0}, {9, 9}, {0, 9},
                                            {3, 3}, {3, 6}, {6, 6}, {6, 3}};

TEST(TriangulateDomain, KeepsHolesOut) {
  Edges edges;
  add_loop(edges, {0, 1, 2, 3});
  add_loop(edges, {4, 5, 6, 7});
  const TriangleMesh mesh = triangulated(kSquareAndHole, edges);
  expect_valid(mesh, 72);
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_EQ(mesh.segments.size(), 8u);
}

TEST(TriangulateDomain, FillsIslandsInHoles) {
  Edges edges;
  add_loop(edges, {0, 1, 2, 3});
  add_loop(edges, {4, 5, 6, 7});
  std::vector<Point2> points = kSquareAndHole;
  points.insert(points.end(), {{4, 4}, {5, 4}, {4, 5}});
  add_loop(edges, {8, 9, 10});
  expect_valid(triangulated(points, edges), 72.5);
}

TEST(TriangulateDomain, ConformsToInnerEdgesWithoutCuttingThere) {
  Edges edges;
  add_loop(edges, {0, 1, 2, 3});
  edges.push_back({4, 6, 5, Kind::kInner});
  edges.push_back({5, 7, 6, Kind::kInner});
  const std::vector<Point2> points = {{0, 0}, {9, 0}, {9, 9}, {0, 9},
                                      {1, 4}, {1, 5}, {8, 4}, {8, 5}};
  const TriangleMesh mesh = triangulated(points, edges);
  expect_valid(mesh, 81);
  EXPECT_EQ(mesh.segments[5], (Segment{5, 7, 6}));
}

TEST(TriangulateDomain, TakesAnEdgeInBothDirectionsForNone) {
  Edges edges;
  add_loop(edges, {0, 1, 2, 3});
  add_loop(edges, {4, 6});  // a hole that has closed
  const TriangleMesh mesh = triangulated(kSquareAndHole, edges);
  expect_valid(mesh, 81);
}

TEST(TriangulateDomain, LeavesPointsOutsideAlone) {
  Edges edges;
  add_loop(edges, {0, 1, 2});
  const std::vector<Point2> points = {{0, 0}, {4, 0}, {0, 4}, {5, 5}, {-1, 2}};
  EXPECT_EQ(triangulated(points, edges).triangles.size(), 1u);
}

TEST(TriangulateDomain, SplitsEdgesAtPointsOnThem) {
  Edges edges;
  add_loop(edges, {0, 1, 2});
  const std::vector<Point2> points = {{0, 0}, {4, 0}, {0, 4}, {2, 0}};
  const TriangleMesh mesh = triangulated(points, edges);
  expect_valid(mesh, 8);
  EXPECT_EQ(mesh.segments[0], (Segment{0, 3, 1}));
  EXPECT_EQ(mesh.segments[1], (Segment{3, 1, 1}));
}

// A square with a slit from the left edge to (6, 5): upper lip 4, 5, lower lip 7, 8, tip 6.
TEST(TriangulateDomain, NamesCornersAlongASlitByTheirSide) {
  const std::vector<Point2> points = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 5},
                                      {3, 5}, {6, 5}, {3, 5}, {0, 5}};
  Edges edges;
  add_loop(edges, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  const TriangleMesh mesh = triangulated(points, edges);
  expect_valid(mesh, 81);
  EXPECT_EQ(test::MeshChecker(mesh).shape(), (test::MeshShape{1, 1}));
  for (const auto& triangle : mesh.triangles) {
    const double height =
        (mesh.points[triangle[0]].y + mesh.points[triangle[1]].y + mesh.points[triangle[2]].y) / 3;
    for (const Index v : triangle) {
      if (v == 4 || v == 5) EXPECT_GT(height, 5);
      if (v == 7 || v == 8) EXPECT_LT(height, 5);
    }
  }
  EXPECT_EQ(mesh.segments.size(), 9u);
}

TEST(TriangulateDomain, OpensASlitThatMeetsNoBoundary) {
  const std::vector<Point2> points = {{0, 0}, {9, 0}, {9, 9}, {0, 9},
                                      {2, 5}, {4, 5}, {7, 5}, {4, 5}};
  Edges edges;
  add_loop(edges, {0, 1, 2, 3});
  add_loop(edges, {4, 5, 6, 7});
  const TriangleMesh mesh = triangulated(points, edges);
  expect_valid(mesh, 81);
  EXPECT_EQ(test::MeshChecker(mesh).shape(), (test::MeshShape{1, 2}));
}

TEST(TriangulateDomain, RefusesEdgesThatCross) {
  Edges edges;
  add_loop(edges, {0, 2, 1, 3});
  const auto result = triangulate_domain(kSquareAndHole, edges);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(result.error().ids.size(), 4u);
}

TEST(TriangulateDomain, OfCollinearOrFewPointsHasNoTriangles) {
  const std::vector<Point2> points = {{0, 0}, {1, 1}, {2, 2}};
  const auto result = triangulate_domain(points, Edges{{0, 2, 4, Kind::kInner}});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->triangles.empty());
  EXPECT_EQ(result->segments, (std::vector<Segment>{{0, 2, 4}}));
  EXPECT_TRUE(triangulate_domain({}, {}).ok());
}

}  // namespace
}  // namespace wellspaced
