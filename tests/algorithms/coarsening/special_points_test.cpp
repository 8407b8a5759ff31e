#include "wellspaced/algorithms/coarsening/special_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/data_files.hpp"
#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

using Nodes = std::vector<Index>;

Nodes special_points(const TriangleMesh& mesh) {
  return automatic_special_points(mesh, skeleton_of(mesh));
}

// A regular polygon, its centre the last node.
TriangleMesh polygon(Index corners) {
  TriangleMesh mesh;
  for (Index i = 0; i < corners; ++i) {
    mesh.points.push_back(circle_point(static_cast<double>(i) / corners));
    mesh.triangles.push_back({i, (i + 1) % corners, corners});
  }
  mesh.points.push_back({0, 0});
  return mesh;
}

TEST(SpecialPoints, AreTheCornersOfASquare) {
  EXPECT_EQ(special_points(test::grid_mesh({.nx = 4, .ny = 3, .jitter = 0})),
            (Nodes{0, 4, 15, 19}));
}

TEST(SpecialPoints, AreWhereTheBoundaryTurnsByMoreThanThirtyDegrees) {
  EXPECT_EQ(special_points(polygon(11)).size(), 11u);  // 32.7 degrees each
  EXPECT_EQ(special_points(polygon(13)).size(), 4u);   // 27.7 degrees each: far points instead
  EXPECT_EQ(special_points(polygon(64)), (Nodes{0, 16, 32, 48}));
}

TEST(OutlineSpecialPoints, AreSharpCornersAndWhatIsFarFromTheLinesBetween) {
  const auto outline = [](const TriangleMesh& mesh) {
    return outline_special_points(mesh, skeleton_of(mesh));
  };
  EXPECT_EQ(outline(polygon(5)).size(), 5u);            // 72 degrees each
  EXPECT_EQ(outline(polygon(8)), (Nodes{0, 2, 4, 6}));  // 45 degrees: no corners, but a diamond
  EXPECT_EQ(outline(polygon(64)), (Nodes{0, 16, 32, 48}));
}

TEST(CompletedSpecialPoints, AreThoseGivenAndAtLeastThreeOnALoop) {
  const TriangleMesh mesh = polygon(64);
  const auto completed = [&](Nodes given) {
    return completed_special_points(mesh, skeleton_of(mesh), given);
  };
  EXPECT_EQ(completed({5, 20, 41}), (Nodes{5, 20, 41}));
  const Nodes from_one = completed({5, 64});
  EXPECT_EQ(from_one.size(), 5u);
  for (const Index v : {5, 37, 64}) EXPECT_TRUE(std::ranges::binary_search(from_one, v));
}

TEST(SpecialPoints, AreWhereMarkersChange) {
  TriangleMesh mesh = polygon(64);
  for (Index i = 0; i < 64; ++i)
    mesh.segments.push_back({i, (i + 1) % 64, i >= 5 && i < 30 ? 2 : 1});
  const Nodes special = special_points(mesh);
  EXPECT_EQ(special.size(), 4u);
  for (const Index v : {5, 30}) EXPECT_TRUE(std::ranges::binary_search(special, v));
}

TEST(SpecialPoints, AreWhereInnerSegmentsEndOrMeet) {
  TriangleMesh mesh = test::grid_mesh({.nx = 4, .ny = 4, .jitter = 0});
  mesh.segments = {{10, 11, 1}, {11, 12, 1}, {12, 13, 1}, {12, 17, 1}};
  const Nodes special = special_points(mesh);
  EXPECT_EQ(special, (Nodes{0, 4, 10, 12, 13, 17, 20, 24}));
}

TEST(SpecialPoints, AreAtLeastThreeOnAHoleAndOnAnInterface) {
  // A disc of rings, 48 nodes each; the innermost ring bounds a hole.
  TriangleMesh mesh;
  constexpr Index kAround = 48;
  for (Index ring = 0; ring < 5; ++ring)
    for (Index i = 0; i < kAround; ++i) {
      const Point2 p = circle_point(static_cast<double>(i) / kAround);
      mesh.points.push_back({p.x * (1 + ring), p.y * (1 + ring)});
      if (ring == 4) continue;
      const Index a = ring * kAround + i, b = ring * kAround + (i + 1) % kAround;
      mesh.triangles.push_back({a, b + kAround, b});
      mesh.triangles.push_back({a, a + kAround, b + kAround});
    }
  const auto on_ring = [](const Nodes& nodes, Index ring) {
    return std::ranges::count_if(nodes, [=](Index v) { return v / kAround == ring; });
  };
  const Nodes special = special_points(mesh);
  EXPECT_EQ(on_ring(special, 0), 3);
  EXPECT_EQ(on_ring(special, 4), 4);
  EXPECT_EQ(special.size(), 7u);

  for (Index i = 0; i < kAround; ++i)  // an interface along ring 2
    mesh.segments.push_back({2 * kAround + i, 2 * kAround + (i + 1) % kAround, 5});
  EXPECT_EQ(on_ring(special_points(mesh), 2), 4);

  mesh.segments.resize(kAround / 2);  // half of it: an arc with two ends, which encloses nothing
  EXPECT_EQ(on_ring(special_points(mesh), 2), 2);
}

TEST(SpecialPoints, OfNothingAreNone) { EXPECT_TRUE(special_points(TriangleMesh{}).empty()); }

// Some of tables/special_points.csv: the leading edges, each one of the farthest pair of its wing.
TEST(SpecialPoints, IncludeTheFarPointsOfTheWingsOfAirfoil1) {
  const auto mesh = test::data_mesh("thesis/airfoil1");
  if (!mesh) GTEST_SKIP() << "no " << test::data_path("thesis/airfoil1");
  const Nodes special = special_points(*mesh);
  EXPECT_GE(special.size(), 13u);
  for (const Index v : {2354, 3283, 3998}) EXPECT_TRUE(std::ranges::binary_search(special, v)) << v;
}

}  // namespace
}  // namespace wellspaced
