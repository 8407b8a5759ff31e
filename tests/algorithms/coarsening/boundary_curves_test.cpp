#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"

namespace wellspaced {
namespace {

using Kind = BoundaryCurve::Kind;

Boundary boundary_of(const TriangleMesh& mesh) {
  return boundary_of(mesh, corner_table(mesh.triangles, static_cast<Index>(mesh.points.size())));
}

// A fan of four triangles around node 4 in the square 0 1 2 3.
TriangleMesh square() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

TEST(Boundary, IsOneClosedCurveAroundASquareWithTheDomainOnItsLeft) {
  TriangleMesh mesh = square();
  mesh.segments = {{1, 0, 7}, {1, 2, 8}};
  const Boundary boundary = boundary_of(mesh);
  ASSERT_EQ(boundary.curves.size(), 1u);
  EXPECT_EQ(boundary.curves[0].nodes, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(boundary.curves[0].markers, (std::vector<int>{7, 8, 1, 1}));
  EXPECT_TRUE(boundary.curves[0].closed);
  EXPECT_EQ(boundary.curves[0].kind, Kind::kDomain);
  EXPECT_EQ(boundary.nodes, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_TRUE(boundary.anchors.empty());
  EXPECT_FALSE(boundary.on_boundary[4]);
}

TEST(Boundary, SeparatesCurvesThatTouchInANode) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {3, 2}};
  mesh.triangles = {{0, 1, 2}, {2, 3, 4}};
  const Boundary boundary = boundary_of(mesh);
  ASSERT_EQ(boundary.curves.size(), 2u);
  EXPECT_EQ(boundary.curves[0].nodes, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(boundary.curves[1].nodes, (std::vector<Index>{2, 3, 4}));
}

TEST(Boundary, EndsInnerCurvesAtTheBoundaryAndWhereTheyDangle) {
  TriangleMesh mesh = square();
  mesh.segments = {{4, 0, 3}, {4, 2, 4}, {4, 2, 9}};  // the last is the one before again
  const Boundary boundary = boundary_of(mesh);
  ASSERT_EQ(boundary.curves.size(), 2u);
  const BoundaryCurve& inner = boundary.curves[1];
  EXPECT_EQ(inner.kind, Kind::kInner);
  EXPECT_FALSE(inner.closed);
  EXPECT_EQ(inner.nodes, (std::vector<Index>{0, 4, 2}));
  EXPECT_EQ(inner.markers, (std::vector<int>{3, 4}));
  EXPECT_EQ(boundary.anchors, (std::vector<Index>{0, 2}));
  EXPECT_TRUE(boundary.on_boundary[4]);

  mesh.segments = {{4, 0, 3}};
  EXPECT_EQ(boundary_of(mesh).curves[1].nodes, (std::vector<Index>{0, 4}));
  EXPECT_EQ(boundary_of(mesh).anchors, (std::vector<Index>{0, 4}));
}

TEST(Boundary, ClosesInnerCurvesThatMeetNothing) {
  const TriangleMesh grid = test::grid_mesh({.nx = 3, .ny = 3, .jitter = 0});
  TriangleMesh mesh = grid;
  mesh.segments = {{5, 6, 2}, {6, 10, 2}, {10, 9, 2}, {9, 5, 2}};
  const Boundary boundary = boundary_of(mesh);
  ASSERT_EQ(boundary.curves.size(), 2u);
  EXPECT_TRUE(boundary.curves[1].closed);
  EXPECT_EQ(boundary.curves[1].nodes, (std::vector<Index>{5, 6, 10, 9}));
  EXPECT_TRUE(boundary.anchors.empty());
}

TEST(Boundary, KeepsSegmentsAwayFromAllTriangles) {
  TriangleMesh mesh = square();
  mesh.points.insert(mesh.points.end(), {{5, 5}, {6, 5}, {7, 5}});
  mesh.segments = {{5, 6, 1}, {6, 7, 1}, {7, 7, 1}};
  const Boundary boundary = boundary_of(mesh);
  ASSERT_EQ(boundary.curves.size(), 2u);
  EXPECT_EQ(boundary.curves[1].nodes, (std::vector<Index>{5, 6, 7}));
}

TEST(Boundary, TiesTheLipsOfASlitAndAnchorsItsTips) {
  TriangleMesh mesh = test::grid_mesh({.nx = 6, .ny = 4, .jitter = 0});
  test::cut_slit(mesh, 7, 2, 1, 5);  // nodes 16, 17, 18 get the twins 35, 36, 37
  const Boundary boundary = boundary_of(mesh);
  ASSERT_EQ(boundary.curves.size(), 2u);
  EXPECT_EQ(boundary.curves[1].nodes, (std::vector<Index>{15, 35, 36, 37, 19, 18, 17, 16}));
  EXPECT_EQ(boundary.anchors, (std::vector<Index>{15, 19}));
  EXPECT_TRUE(boundary.twins.has_twin(16));
  EXPECT_FALSE(boundary.twins.has_twin(15));
  std::vector<Index> visited;
  boundary.twins.for_each(36, [&](Index v) { visited.push_back(v); });
  EXPECT_EQ(visited, (std::vector<Index>{36, 17}));
}

TEST(Boundary, GivesEveryBoundaryEdgeToOneCurve) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TriangleMesh mesh = test::grid_mesh({.nx = 9, .ny = 7, .hole = 0.25, .seed = seed});
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 5)
      mesh.segments.push_back({mesh.triangles[t][0], mesh.triangles[t][1], 2});
    std::multiset<std::pair<Index, Index>> expected, actual;
    const auto table = corner_table(mesh.triangles, static_cast<Index>(mesh.points.size()));
    for (const auto& [a, b] : boundary_edges(table)) expected.insert(std::minmax(a, b));
    for (const Segment& s : mesh.segments)
      if (!expected.contains(std::minmax(s.a, s.b))) expected.insert(std::minmax(s.a, s.b));
    for (const Segment& s : boundary_segments(boundary_of(mesh)))
      actual.insert(std::minmax(s.a, s.b));
    EXPECT_EQ(actual, expected);
  }
}

TEST(Boundary, OfTrianglesThatMakeNoMeshStillEnds) {
  TriangleMesh mesh = square();
  mesh.triangles = {{0, 1, 4}, {0, 1, 3}, {0, 1, 2}, {1, 2, 4}, {2, 1, 4}};
  EXPECT_LE(boundary_segments(boundary_of(mesh)).size(), 15u);
}

}  // namespace
}  // namespace wellspaced
