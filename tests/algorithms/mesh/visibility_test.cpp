#include "wellspaced/algorithms/mesh/visibility.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

struct Interval {
  double low, high;
};

// The part of the segment from p to q inside a closed triangle.
Interval part_inside(const TriangleMesh& mesh, Index t, Point2 p, Point2 q) {
  Interval part{0, 1};
  for (int i = 0; i < 3; ++i) {
    const Point2 a = mesh.points[mesh.triangles[t][i]],
                 b = mesh.points[mesh.triangles[t][(i + 1) % 3]];
    const auto side = [&](Point2 x) {
      return (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x);
    };
    const double at_p = side(p), at_q = side(q);
    if (at_p < 0 && at_q < 0) return {1, 0};
    if (at_p < 0 && at_q >= 0) part.low = std::max(part.low, at_p / (at_p - at_q));
    if (at_p >= 0 && at_q < 0) part.high = std::min(part.high, at_p / (at_p - at_q));
  }
  return part;
}

// Whether the triangles cover the segment. On small whole coordinates no gap is below 1e-6.
bool slow_sees(const TriangleMesh& mesh, Point2 p, Point2 q) {
  std::vector<Interval> parts;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Interval part = part_inside(mesh, t, p, q);
    if (part.low <= part.high) parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end(), [](Interval a, Interval b) { return a.low < b.low; });
  double covered = 0;
  bool starts = false;
  for (const Interval part : parts) {
    if (part.low > covered + 1e-9) return false;
    starts = starts || part.low == 0;
    covered = std::max(covered, part.high);
  }
  return starts && covered > 1 - 1e-9;
}

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
        const bool expected = slow_sees(mesh, mesh.points[p], mesh.points[q]);
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
        ASSERT_EQ(visibility.sees(x, t, v), slow_sees(mesh, x, mesh.points[v])) << t << ' ' << v;
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
