#include "wellspaced/algorithms/audit/winding.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/triangle_overlap.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using audit::Corners;

// Random counter-clockwise triangles on a small lattice, so that every degenerate contact occurs.
std::vector<Corners> lattice_triangles(std::size_t count, std::uint64_t side, Random& random) {
  std::vector<Corners> triangles;
  while (triangles.size() < count) {
    Corners c;
    for (Point2& p : c)
      p = {static_cast<double>(random.below(side)), static_cast<double>(random.below(side))};
    const int sign = orient2d(c[0], c[1], c[2]);
    if (sign != 0) triangles.push_back(audit::counter_clockwise(c, sign));
  }
  return triangles;
}

bool any_pair_overlaps(const std::vector<Corners>& triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (audit::interiors_overlap(triangles[i], triangles[j])) return true;
  return false;
}

std::vector<audit::ChainEdge> chain_of(const std::vector<Corners>& triangles) {
  std::vector<audit::ChainEdge> chain;
  for (const Corners& c : triangles)
    for (int i = 0; i < 3; ++i) chain.push_back({c[i], c[(i + 1) % 3], 0, 0});
  return chain;
}

bool strictly_inside(Point2 p, Point2 a, Point2 b) {
  return orient2d(a, b, p) == 0 && p != a && p != b && std::min(a.x, b.x) <= p.x &&
         p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool any_corner_hangs(const std::vector<audit::ChainEdge>& chain) {
  for (const auto& e : chain)
    for (const auto& f : chain)
      if (strictly_inside(f.from, e.from, e.to)) return true;
  return false;
}

TEST(Winding, AgreesWithAllPairsOnRandomLatticeTriangles) {
  Random random(1);
  int disjoint = 0, hanging = 0;
  for (int round = 0; round < 40000; ++round) {
    const auto triangles = lattice_triangles(2 + random.below(4), 3 + random.below(6), random);
    const auto chain = chain_of(triangles);
    const auto verdict = audit::cover_at_most_once(chain);
    ASSERT_EQ(verdict.at_most_once, !any_pair_overlaps(triangles)) << "round " << round;
    if (!verdict.at_most_once) continue;
    ++disjoint;
    ASSERT_EQ(!verdict.hanging_nodes.empty(), any_corner_hangs(chain)) << "round " << round;
    hanging += !verdict.hanging_nodes.empty();
  }
  EXPECT_GT(disjoint, 3000);
  EXPECT_GT(hanging, 300);
}

TEST(Winding, AcceptsTilingsWhateverTheOrderAndNumberOfPieces) {
  Random random(2);
  const TriangleMesh mesh = test::random_mesh(300, 5);
  std::vector<Corners> triangles;
  for (const auto& t : mesh.triangles) triangles.push_back(audit::corners_of(mesh.points, t));
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = triangles.size(); i > 1; --i)
      std::swap(triangles[i - 1], triangles[random.below(i)]);
    EXPECT_TRUE(audit::cover_at_most_once(chain_of(triangles)).at_most_once);
    auto twice = triangles;
    twice.push_back(triangles[random.below(triangles.size())]);
    EXPECT_FALSE(audit::cover_at_most_once(chain_of(twice)).at_most_once);
    triangles.pop_back();
  }
}

TEST(Winding, SeesASpiralThatOverlapsItselfAlthoughNothingIsWrongLocally) {
  const auto clean = audit::audit_mesh(test::spiral_strip(100, 40, 0.0078125));
  EXPECT_TRUE(clean.pass());
  const auto report = audit::audit_mesh(test::spiral_strip(45, 40, 0));
  EXPECT_GT(report.check("no_overlap")->violations, 0u);
  for (const auto& check : report.checks)
    EXPECT_TRUE(check.pass() || !check.required || check.name == "no_overlap") << check.name;
}

TEST(Winding, SeesAStripThatClosesAfterTwoTurns) {
  TriangleMesh mesh = test::spiral_strip(80, 40, 0);
  for (auto& t : mesh.triangles)
    for (Index& v : t) v %= 160;
  mesh.points.resize(160);
  mesh.segments.clear();
  const auto report = audit::audit_mesh(mesh);
  EXPECT_EQ(report.check("no_overlap")->violations, 80u);
  EXPECT_EQ(report.measure("boundary_loops")->value, 2);
  EXPECT_TRUE(report.check("euler")->pass());
}

TEST(Winding, CancelsCoincidentEdgesOfASlitEvenWhereTheLipsAreSplitDifferently) {
  const std::vector<Corners> triangles = {{Point2{0, 0}, {4, 0}, {2, 3}},
                                          {Point2{0, 0}, {2, -3}, {1, 0}},
                                          {Point2{1, 0}, {2, -3}, {4, 0}}};
  const auto verdict = audit::cover_at_most_once(chain_of(triangles));
  EXPECT_TRUE(verdict.at_most_once);
  EXPECT_EQ(verdict.hanging_nodes.size(), 1u);
}

TEST(Winding, TellsAContactFromAnOverlapByOneUnitInTheLastPlace) {
  const double x = 0.1;
  const std::vector<Corners> touching = {{Point2{-1, 0}, {x, -1}, {x, 1}},
                                         {Point2{x, 0}, {1, -1}, {1, 1}}};
  EXPECT_TRUE(audit::cover_at_most_once(chain_of(touching)).at_most_once);
  auto overlapping = touching;
  overlapping[1][0].x = std::nextafter(x, 0);
  EXPECT_FALSE(audit::cover_at_most_once(chain_of(overlapping)).at_most_once);
}

}  // namespace
}  // namespace wellspaced
