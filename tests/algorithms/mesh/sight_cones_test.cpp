#include "wellspaced/algorithms/mesh/sight_cones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "tests/support/slow_sight.hpp"

namespace wellspaced {
namespace {

using Nodes = std::set<Index>;

bool everywhere(Index, Index) { return true; }

Nodes seen_from(SightCones& cones, Index p) {
  Nodes seen;
  cones.spread(p, everywhere, [&](Index v) { seen.insert(v); });
  return seen;
}

std::vector<Nodes> seen_from_all(const TriangleMesh& mesh) {
  const Visibility visibility(mesh);
  SightCones cones(visibility);
  std::vector<Nodes> seen;
  for (Index p = 0; p < mesh.points.size(); ++p) seen.push_back(seen_from(cones, p));
  return seen;
}

// What each node sees beside itself, by a relation of nodes.
template <class Sees>
void expect_seen(const TriangleMesh& mesh, Sees sees) {
  const std::vector<Nodes> seen = seen_from_all(mesh);
  for (Index p = 0; p < mesh.points.size(); ++p) {
    Nodes expected;
    for (Index q = 0; q < mesh.points.size(); ++q)
      if (q != p && sees(p, q)) expected.insert(q);
    ASSERT_EQ(seen[p], expected) << "from node " << p;
  }
}

void expect_that_of_the_union(const TriangleMesh& mesh) {
  const Visibility visibility(mesh);
  expect_seen(mesh, [&](Index p, Index q) {
    return !visibility.links().around(p).empty() &&
           test::slow_sees(mesh, mesh.points[p], mesh.points[q]);
  });
}

// Lines of sight run along walls, and through nodes and gaps without width.
TEST(SightCones, SeeWhatTheTrianglesCoverOnALattice) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    expect_that_of_the_union(
        test::grid_mesh({.nx = 8, .ny = 7, .jitter = 0, .hole = 0.1 * seed, .seed = seed}));
}

TEST(SightCones, SeeWhatTheTrianglesCoverOffTheLattice) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    TriangleMesh mesh =
        test::grid_mesh({.nx = 8, .ny = 7, .jitter = 0.2, .hole = 0.25, .seed = seed});
    for (Point2& p : mesh.points) p = {std::round(8 * p.x), std::round(8 * p.y)};
    expect_that_of_the_union(mesh);
  }
}

TEST(SightCones, DoNotCrossASlitAndPassItsTips) {
  constexpr Index kColumns = 9, kRow = 3, kFrom = 2, kTo = 6;
  TriangleMesh mesh = test::grid_mesh({.nx = 8, .ny = 6, .jitter = 0, .seed = 2});
  const auto first_twin = static_cast<Index>(mesh.points.size());
  test::cut_slit(mesh, kColumns, kRow, kFrom, kTo);
  const auto is_on_slit = [&](Index v) {
    const Point2 p = mesh.points[v];
    return p.y == kRow && kFrom < p.x && p.x < kTo;
  };
  // 0: on the line of the slit, beyond its tips. Its upper lip has the twins.
  const auto side = [&](Index v) {
    if (is_on_slit(v)) return v >= first_twin ? 1 : -1;
    return mesh.points[v].y > kRow ? 1 : mesh.points[v].y < kRow ? -1 : 0;
  };
  expect_seen(mesh, [&](Index v, Index w) {
    if (side(v) * side(w) >= 0) return true;
    if (is_on_slit(v) || is_on_slit(w)) return false;
    const Point2 p = mesh.points[v], q = mesh.points[w];
    const double rise = q.y - p.y, at = p.x * rise + (q.x - p.x) * (kRow - p.y);
    return (at - kFrom * rise) * (at - kTo * rise) >= 0;
  });
}

TEST(SightCones, MeetInANodeThatTwoFansShare) {
  TriangleMesh bow_tie;
  bow_tie.points = {{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  bow_tie.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(seen_from_all(bow_tie),
            (std::vector<Nodes>{{1, 2, 3, 4}, {0, 2, 3}, {0, 1, 4}, {0, 1, 4}, {0, 2, 3}}));
}

TEST(SightCones, FromANodeInNoTriangleSeeNothing) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {0.25, 0.25}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(seen_from_all(mesh), (std::vector<Nodes>{{1, 2}, {0, 2}, {0, 1}, {}}));
}

TEST(SightCones, AreTheSameAtEveryScale) {
  const TriangleMesh mesh =
      test::grid_mesh({.nx = 8, .ny = 7, .jitter = 0.2, .hole = 0.25, .seed = 9});
  const std::vector<Nodes> seen = seen_from_all(mesh);
  for (const int exponent : {-1000, -300, 300, 1000}) {
    TriangleMesh scaled = mesh;
    for (Point2& p : scaled.points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    EXPECT_EQ(seen_from_all(scaled), seen) << "2^" << exponent;
  }
}

// Nodes two cells from the boundary or more: nothing leads on from their neighbours.
TEST(SightCones, StopAtEdgesThatAreNotEntered) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 6, .ny = 6, .jitter = 0, .seed = 3});
  const Visibility visibility(mesh);
  SightCones cones(visibility);
  const auto is_inside = [](double x) { return 2 <= x && x <= 4; };
  for (Index p = 0; p < mesh.points.size(); ++p) {
    if (!is_inside(mesh.points[p].x) || !is_inside(mesh.points[p].y)) continue;
    Nodes neighbours, seen;
    for (const Index t : visibility.links().around(p))
      for (const Index v : mesh.triangles[t])
        if (v != p) neighbours.insert(v);
    cones.spread(
        p, [](Index, Index) { return false; }, [&](Index v) { seen.insert(v); });
    EXPECT_EQ(seen, neighbours) << p;
  }
}

}  // namespace
}  // namespace wellspaced
