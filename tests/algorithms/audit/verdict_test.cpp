// Attempts to talk the auditor into a wrong verdict: meshes that are right wherever one looks
// closely, and wrong as a whole; and sound ones that look suspicious.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/audit_tet_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

using test::Names;

Names required_failures(const audit::Report& report) {
  Names names;
  for (const auto& check : report.checks)
    if (check.required && !check.pass()) names.insert(check.name);
  return names;
}

Names verdict(const TriangleMesh& mesh) { return required_failures(audit::audit_mesh(mesh)); }
Names verdict(const TetMesh& mesh) { return required_failures(audit::audit_tet_mesh(mesh)); }

// A fan of n triangles around the origin that goes round it `turns` times and closes.
TriangleMesh closed_fan(Index n, Index turns) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}};
  for (Index i = 0; i < n; ++i) mesh.points.push_back(circle_point(double(i * turns) / n));
  for (Index i = 0; i < n; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  return mesh;
}

TriangleMesh square(Point2 low, double size) {
  TriangleMesh mesh;
  mesh.points = {low, {low.x + size, low.y}, {low.x + size, low.y + size}, {low.x, low.y + size}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Stops at the call number `last`; counts the calls.
Progress stop_at(int last, int& calls) {
  return [last, &calls](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(phase, "audit");
    EXPECT_LE(done, total);
    return ++calls < last;
  };
}

TEST(Verdict, OfACancelledAuditIsNoPass) {
  const TriangleMesh mesh = square({0, 0}, 1);
  int all = 0;
  ASSERT_TRUE(audit::audit_mesh(mesh, {.progress = stop_at(1000, all)}).pass());
  EXPECT_GE(all, 5);
  for (int last = 1; last <= all; ++last) {
    int calls = 0;
    const audit::Report report = audit::audit_mesh(mesh, {.progress = stop_at(last, calls)});
    EXPECT_FALSE(report.complete);
    EXPECT_FALSE(report.pass());
    EXPECT_EQ(calls, last) << "it asks again after it was stopped";
  }
}

TEST(Verdict, OnAFanThatWindsTwiceIsOverlap) {
  EXPECT_EQ(verdict(closed_fan(9, 1)), Names{});
  EXPECT_EQ(verdict(closed_fan(9, 2)), Names{"no_overlap"});
  EXPECT_EQ(verdict(closed_fan(16, 5)), Names{"no_overlap"});
}

// A band of triangles whose last edge is glued to the first one turned over.
TEST(Verdict, OnAMoebiusBandNamesTheEdgeWhereItTurns) {
  const Index n = 10;
  TriangleMesh mesh = test::spiral_strip(n, n, 0);
  for (auto& t : mesh.triangles)
    for (Index& v : t)
      if (v >= 2 * n) v = 1 - (v - 2 * n);
  mesh.points.resize(2 * n);
  mesh.segments.clear();
  const auto failures = verdict(mesh);
  EXPECT_EQ(failures.count("consistent_orientation"), 1u);
}

// A grid whose opposite sides are glued, one pair turned over: closed, without a boundary.
TEST(Verdict, OnAKleinBottleLaidFlatIsNotSound) {
  const Index n = 6;
  TriangleMesh mesh;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) mesh.points.push_back({1.0 * i + 0.1 * j, 1.0 * j});
  const auto node = [&](Index i, Index j) {
    const Index row = j == n ? 0 : j, column = (j == n ? n - i % n : i) % n;
    return row * n + column;
  };
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  const auto failures = verdict(mesh);
  EXPECT_EQ(failures.count("consistent_orientation"), 1u);
  EXPECT_EQ(failures.count("no_overlap"), 1u);
}

TEST(Verdict, AllowsAnIslandInAHoleAndNoOtherNesting) {
  const TriangleMesh ring = test::annulus(24);  // its hole has radius 1
  EXPECT_EQ(verdict(test::side_by_side(ring, square({-0.5, -0.5}, 1), {0, 0})), Names{});
  EXPECT_EQ(verdict(test::side_by_side(ring, square({-8, -8}, 16), {0, 0})), Names{"no_overlap"});
  EXPECT_EQ(verdict(test::side_by_side(square({0, 0}, 8), square({3, 3}, 1), {0, 0})),
            Names{"no_overlap"});
}

TEST(Verdict, AllowsPiecesThatTouch) {
  const TriangleMesh a = square({0, 0}, 1);
  EXPECT_EQ(verdict(test::side_by_side(a, square({1, 1}, 1), {0, 0})), Names{});  // in a corner
  EXPECT_EQ(verdict(test::side_by_side(a, square({1, 0}, 1), {0, 0})), Names{});  // along an edge
  // Along a part of an edge: the node of one hangs in the edge of the other.
  EXPECT_EQ(verdict(test::side_by_side(a, square({1, 0.25}, 0.5), {0, 0})),
            Names{"no_hanging_node"});
  EXPECT_EQ(verdict(test::side_by_side(a, square({std::nextafter(1, 0), -0.5}, 2), {0, 0})),
            Names{"no_overlap"});
}

// What fills a hole in the other direction winds -1 times: the sum over the plane is 0 there.
TEST(Verdict, SeesAHoleFilledWithReversedTriangles) {
  TriangleMesh mesh = test::annulus(24);
  mesh.points.push_back({0, 0});
  const Index centre = static_cast<Index>(mesh.points.size() - 1);
  for (Index i = 0; i < 24; ++i) mesh.triangles.push_back({centre, 2 * ((i + 1) % 24), 2 * i});
  const auto failures = verdict(mesh);
  EXPECT_EQ(failures, (Names{"consistent_orientation", "no_inverted"}));
  // With nodes of its own, so that no edge tells.
  TriangleMesh disc = closed_fan(24, 1);
  for (auto& t : disc.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(verdict(test::side_by_side(test::annulus(24), disc, {0, 0})).count("no_inverted"), 1u);
}

// Two sheets of opposite orientation, one over the other: their winding numbers cancel.
TEST(Verdict, SeesAnInvertedSheetOverAnUprightOne) {
  TriangleMesh inverted = square({0.25, 0.25}, 0.5);
  for (auto& t : inverted.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(verdict(test::side_by_side(square({0, 0}, 1), inverted, {0, 0})),
            (Names{"no_inverted", "no_overlap"}));
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Point2& p : mesh.points) p = {p.x * factor, p.y * factor};
  return mesh;
}

TetMesh scaled(TetMesh mesh, double factor) {
  for (Point3& p : mesh.points) p = {p.x * factor, p.y * factor, p.z * factor};
  return mesh;
}

// Powers of two change no sign; 2^-1050 leaves the coordinates subnormal.
TEST(Verdict, DoesNotDependOnTheScale) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    if (name.find('/') != name.npos) continue;
    const Names as_given = test::failing(audit::audit_mesh(mesh));
    for (const double factor : {0x1p1000, 0x1p-1050, 0x1p-1000, 0x1p500})
      EXPECT_EQ(test::failing(audit::audit_mesh(scaled(mesh, factor))), as_given)
          << name << " times " << factor;
  }
  for (const auto& [name, mesh] : test::clean_tet_meshes()) {
    const Names as_given = test::failing(audit::audit_tet_mesh(mesh));
    for (const double factor : {0x1p1000, 0x1p-1050, 0x1p-1000, 0x1p300})
      EXPECT_EQ(test::failing(audit::audit_tet_mesh(scaled(mesh, factor))), as_given)
          << name << " times " << factor;
  }
}

TEST(Verdict, OnNothingIsPass) {
  EXPECT_EQ(verdict(TriangleMesh{}), Names{});
  EXPECT_EQ(verdict(TetMesh{}), Names{});
  TriangleMesh points_alone;
  points_alone.points = {{0, 0}, {1, 0}};
  EXPECT_EQ(verdict(points_alone), Names{});
}

// ---- Space

// Tets around the edge from (0,0,0) to (0,0,1), `turns` times round it.
TetMesh closed_book(Index n, Index turns) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}};
  for (Index i = 0; i < n; ++i) {
    const Point2 p = circle_point(double(i * turns) / n);
    mesh.points.push_back({p.x, p.y, 0.5});
  }
  for (Index i = 0; i < n; ++i) mesh.tets.push_back({0, 2 + i, 2 + (i + 1) % n, 1});
  return mesh;
}

TEST(SolidVerdict, OnTetsThatGoRoundAnEdgeTwiceIsOverlap) {
  EXPECT_EQ(verdict(closed_book(9, 1)), Names{});
  EXPECT_EQ(verdict(closed_book(9, 2)).count("no_overlap"), 1u);
}

TetMesh one_tet(TetMesh mesh, std::array<Point3, 4> corners) {
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  return mesh;
}

// Two needles through each other: no node of either lies in the other, all edges miss each other.
TEST(SolidVerdict, SeesPiecesThatPierceEachOther) {
  const TetMesh a = one_tet({}, {{{-4, -1, 0}, {4, -1, 0}, {0, 1, -1}, {0, 1, 1}}});
  EXPECT_EQ(verdict(a), Names{});
  const TetMesh b = one_tet(a, {{{0.5, -4, 0.25}, {0.5, 4, 0.25}, {-0.25, 0, 3}, {1, 0, 3}}});
  const Names failures =
      verdict(b).count("no_inverted") > 0
          ? verdict(one_tet(a, {{{0.5, -4, 0.25}, {0.5, 4, 0.25}, {1, 0, 3}, {-0.25, 0, 3}}}))
          : verdict(b);
  EXPECT_EQ(failures, (Names{"no_overlap", "no_improper_contact"}));
}

TEST(SolidVerdict, AllowsABodyInACavityAndNotInTheSolid) {
  const auto all = [](Index, Index, Index) { return true; };
  const TetMesh box = test::cubes(5, 5, 5, all), small = test::cubes(1, 1, 1, all);
  const TetMesh hollow = test::cubes(5, 5, 5, [](Index x, Index y, Index z) {
    return !(1 <= x && x < 4 && 1 <= y && y < 4 && 1 <= z && z < 4);
  });
  EXPECT_EQ(verdict(test::side_by_side(hollow, small, {2, 2, 2})), Names{});
  EXPECT_EQ(verdict(test::side_by_side(box, small, {2.25, 2.25, 2.25})), Names{"no_overlap"});
  TetMesh reversed = test::cubes(3, 3, 3, all);  // fills the cavity, turned inside out
  for (auto& t : reversed.tets) std::swap(t[2], t[3]);
  EXPECT_EQ(verdict(test::side_by_side(hollow, reversed, {1, 1, 1})), Names{"no_inverted"});
}

}  // namespace
}  // namespace wellspaced
