#include "wellspaced/algorithms/mesh/visibility.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "tests/support/slow_sight.hpp"

namespace wellspaced {
namespace {

TriangleMesh grid_with_holes(std::uint64_t seed) {
  return test::grid_mesh({.nx = 7, .ny = 6, .jitter = 0, .hole = 0.25, .seed = seed});
}

TEST(Visibility, IsThatOfTheUnionOfAllTriangles) {
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TriangleMesh mesh = grid_with_holes(seed);
    const Visibility visibility(mesh);
    for (Index p = 0; p < mesh.points.size(); ++p) {
      if (visibility.links().around(p).empty()) continue;
      for (Index q = 0; q < mesh.points.size(); ++q) {
        const bool expected = test::slow_sees(mesh, mesh.points[p], mesh.points[q]);
        ASSERT_EQ(visibility.sees(p, q), expected) << p << ' ' << q << " seed " << seed;
        blocked += !expected;
      }
    }
  }
  EXPECT_GT(blocked, 1000);
}

TEST(Visibility, FromAPointInATriangleIsThatOfTheUnion) {
  const TriangleMesh mesh = grid_with_holes(5);
  const Visibility visibility(mesh);
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    const Point2 inside{(p.x + q.x + 2 * r.x) / 4, (p.y + q.y + 2 * r.y) / 4};
    const Point2 middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    for (Index v = 0; v < mesh.points.size(); ++v)
      for (const Point2 x : {inside, middle, r})
        ASSERT_EQ(visibility.sees(x, t, v), test::slow_sees(mesh, x, mesh.points[v]))
            << t << ' ' << v;
  }
}

TEST(Visibility, EndsAtTheLipsOfASlit) {
  TriangleMesh mesh = test::grid_mesh({.nx = 8, .ny = 6, .jitter = 0, .seed = 2});
  test::cut_slit(mesh, 9, 3, 2, 6);
  const Visibility visibility(mesh);
  const auto node = [](Index x, Index y) { return y * 9 + x; };
  EXPECT_FALSE(visibility.sees(node(4, 2), node(4, 4)));  // across the slit
  EXPECT_TRUE(visibility.sees(node(1, 1), node(3, 5)));   // through its tip
  EXPECT_TRUE(visibility.sees(node(2, 3), node(6, 3)));   // along it
  for (Index v = 0; v < mesh.points.size(); ++v) {        // along either lip
    if (mesh.points[v].y != 3 || mesh.points[v].x <= 2 || mesh.points[v].x >= 6) continue;
    EXPECT_TRUE(visibility.sees(node(0, 3), v)) << v;
    EXPECT_TRUE(visibility.sees(v, node(7, 3))) << v;
  }
  std::size_t twins = 0;
  for (Index p = 0; p < mesh.points.size(); ++p)
    for (Index q = 0; q < p; ++q)
      if (mesh.points[p] == mesh.points[q]) {
        EXPECT_FALSE(visibility.sees(p, q));
        ++twins;
      }
  EXPECT_GT(twins, 0u);
}

}  // namespace
}  // namespace wellspaced
