#include "wellspaced/algorithms/mesh/prepare_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/cancelling.hpp"
#include "wellspaced/algorithms/mesh/coincident_points.hpp"
#include "wellspaced/algorithms/mesh/directed_edges.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// A unit square cut along its diagonal 0-2.
TriangleMesh square() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// A square around the centre 0 whose left half axis is slit: 1 (upper lip) and 2 (lower lip)
// coincide at its mouth, the tip is 0.
TriangleMesh slit_square() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {-1, 0}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}};
  return mesh;
}

Error error_of(TriangleMesh mesh, Index base = 0) {
  const auto result = prepare_mesh(mesh, base);
  EXPECT_FALSE(result.ok());
  return result.ok() ? Error{} : result.error();
}

void expect_invalid(const TriangleMesh& mesh, const std::vector<Index>& ids,
                    const std::string& part) {
  const Error error = error_of(mesh);
  EXPECT_EQ(error.code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(error.ids, ids) << error.message;
  EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
}

TEST(PrepareMesh, RecoversTheBoundaryWhereNoneIsGiven) {
  TriangleMesh mesh = square();
  const auto found = prepare_mesh(mesh);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->recovered_segments, 4u);
  EXPECT_FALSE(found->turned);
  const std::vector<Segment> expected = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  EXPECT_EQ(mesh.segments, expected);
}

TEST(PrepareMesh, KeepsGivenSegmentsAndTheirMarkersAndDropsRepetitions) {
  TriangleMesh mesh = square();
  mesh.segments = {{2, 0, 7}, {1, 0, 5}, {0, 1, 9}};
  const auto found = prepare_mesh(mesh);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->recovered_segments, 3u);
  EXPECT_EQ(found->repeated_segments, 1u);
  const std::vector<Segment> expected = {{2, 0, 7}, {1, 0, 5}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  EXPECT_EQ(mesh.segments, expected);
}

TEST(PrepareMesh, TurnsAMeshThatIsClockwiseThroughout) {
  TriangleMesh mesh = square();
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  const auto found = prepare_mesh(mesh);
  ASSERT_TRUE(found.ok());
  EXPECT_TRUE(found->turned);
  EXPECT_EQ(mesh.triangles[0], (std::array<Index, 3>{1, 2, 0}));
}

TEST(PrepareMesh, RefusesMixedOrientation) {
  TriangleMesh mesh = square();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  expect_invalid(mesh, {1, 0}, "triangle 1 (2, 0, 3) is clockwise");
}

TEST(PrepareMesh, RefusesTrianglesWithoutAreaExactly) {
  TriangleMesh mesh = square();
  mesh.triangles.push_back({0, 1, 1});
  expect_invalid(mesh, {2}, "has no area");
  mesh = square();
  mesh.points = {{0, 0}, {0.1, 0.1}, {0.3, 0.3}, {0, 1}};
  expect_invalid(mesh, {0}, "has no area");
  mesh.points[1].x = 0.10000000000000002;  // one ulp off the line: thin, but a triangle
  EXPECT_TRUE(prepare_mesh(mesh).ok());
}

TEST(PrepareMesh, RefusesIndicesOutOfRange) {
  TriangleMesh mesh = square();
  mesh.triangles.push_back({0, 1, 4});
  expect_invalid(mesh, {2}, "names point 4");
  mesh = square();
  mesh.segments = {{0, 1, 0}, {9, 0, 0}};
  expect_invalid(mesh, {1}, "names point 9");
}

TEST(PrepareMesh, RefusesTwoTrianglesOnOneSideOfAnEdge) {
  TriangleMesh mesh = square();
  mesh.points.push_back({0.5, 2});
  mesh.triangles.push_back({0, 1, 4});
  expect_invalid(mesh, {0, 2}, "edge 0-1 has triangles 0 and 2 on the same side");
  mesh = square();
  mesh.triangles.push_back({2, 0, 1});
  expect_invalid(mesh, {0, 2}, "same side");
}

TEST(PrepareMesh, RefusesSegmentsThatAreNoEdges) {
  TriangleMesh mesh = square();
  mesh.segments = {{1, 3, 0}};
  expect_invalid(mesh, {0}, "segment 0 (1-3) is no edge");
  mesh.segments = {{1, 1, 0}};
  expect_invalid(mesh, {0}, "is no edge");
}

TEST(PrepareMesh, CountsFromTheGivenBaseInMessagesAndFromZeroInIds) {
  TriangleMesh mesh = square();
  mesh.segments = {{1, 3, 0}};
  const Error error = error_of(mesh, 1);
  EXPECT_NE(error.message.find("segment 1 (2-4)"), std::string::npos);
  EXPECT_EQ(error.ids, std::vector<Index>{0});
}

TEST(PrepareMesh, AcceptsPairsAcrossASlit) {
  TriangleMesh mesh = slit_square();
  const auto found = prepare_mesh(mesh);
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_EQ(found->slit_points, 2u);
  EXPECT_EQ(found->recovered_segments, 6u);
}

TEST(PrepareMesh, RefusesCoincidentPointsThatOnlyTouch) {
  TriangleMesh mesh = square();
  mesh.points.insert(mesh.points.end(), {{1, 1}, {2, 1}, {2, 2}});
  mesh.triangles.push_back({4, 5, 6});
  expect_invalid(mesh, {2, 4}, "points 2 and 4 coincide");
}

TEST(PrepareMesh, RefusesAPairWhoseLipsLieOnTheSameSide) {
  TriangleMesh mesh;  // two triangles, one on top of the other
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 2}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  expect_invalid(mesh, {0, 3}, "coincide");
}

TEST(PrepareMesh, KeepsPointsInNoTriangleEvenWhereTheyCoincide) {
  TriangleMesh mesh = square();
  mesh.points.insert(mesh.points.end(), {{1, 1}, {5, 5}, {-0.0, 0}});
  const auto found = prepare_mesh(mesh);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->unused_points, 3u);
  EXPECT_EQ(mesh.points.size(), 7u);
}

TEST(PrepareMesh, AcceptsTheEmptyMesh) {
  TriangleMesh mesh;
  EXPECT_TRUE(prepare_mesh(mesh).ok());
  mesh.points = {{0, 0}, {0, 0}};
  EXPECT_TRUE(prepare_mesh(mesh).ok());
}

TEST(PrepareMesh, TakesALargeFanInItsStride) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}};
  constexpr Index kBlades = 200000;
  for (Index i = 0; i <= kBlades; ++i) mesh.points.push_back({1.0, static_cast<double>(i)});
  for (Index i = 1; i <= kBlades; ++i) mesh.triangles.push_back({0, i, i + 1});
  const auto found = prepare_mesh(mesh);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->recovered_segments, kBlades + 2);
}

TEST(PrepareMesh, CanBeCancelled) {
  test::phases_that_cancel([](const Progress& progress) {
    TriangleMesh mesh = square();
    return prepare_mesh(mesh, 0, progress);
  });
}

TEST(FirstCoincident, NamesTheLowestNumberAndTakesZerosAsEqual) {
  const std::vector<Point2> points = {{1, 0}, {0.0, 0}, {1, 0}, {-0.0, 0}, {0, 1}};
  EXPECT_EQ(first_coincident(points), (std::vector<Index>{0, 1, 0, 1, 4}));
  const std::vector<Point3> solid = {{1, 0, 0}, {1, 0, 1}, {1, 0, -0.0}};
  EXPECT_EQ(first_coincident(solid), (std::vector<Index>{0, 1, 0}));
}

TEST(DirectedEdges, FindsTrianglesBoundaryAndConflicts) {
  TriangleMesh mesh = square();
  const DirectedEdges edges(mesh.triangles);
  EXPECT_EQ(edges.triangle_of(0, 1), 0u);
  EXPECT_EQ(edges.triangle_of(0, 2), 1u);
  EXPECT_EQ(edges.triangle_of(2, 0), 0u);
  EXPECT_EQ(edges.triangle_of(1, 0), kNoIndex);
  EXPECT_TRUE(edges.has_edge(1, 0));
  EXPECT_FALSE(edges.has_edge(1, 3));
  EXPECT_EQ(edges.boundary().size(), 4u);
  EXPECT_FALSE(edges.find_conflict().has_value());
}

TEST(DirectedEdges, HaveTheBoundaryThatLookingUpEachOppositeTells) {
  Random random(3);
  for (int run = 0; run < 200; ++run) {
    std::vector<std::array<Index, 3>> triangles(random.below(30));
    for (auto& t : triangles)
      t = {Index(random.below(9)), Index(random.below(9)), Index(random.below(9))};
    const DirectedEdges edges(triangles);
    std::vector<DirectedEdges::Edge> expected;
    for (const auto& [a, b, c] : triangles)
      for (const DirectedEdges::Edge e : {DirectedEdges::Edge{a, b}, {b, c}, {c, a}})
        if (edges.triangle_of(e[1], e[0]) == kNoIndex) expected.push_back(e);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(edges.boundary(), expected);
  }
}

}  // namespace
}  // namespace wellspaced
