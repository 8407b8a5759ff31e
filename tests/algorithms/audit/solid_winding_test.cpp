#include "wellspaced/algorithms/audit/solid_winding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/audit_tet_meshes.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using audit::TetCorners;

struct Soup {
  std::vector<Point3> points;
  std::vector<std::array<Index, 4>> tets;  // positive, each with nodes of its own

  TetCorners corners(Index t) const {
    const auto& [a, b, c, d] = tets[t];
    return {points[a], points[b], points[c], points[d]};
  }
  std::vector<audit::ChainFace> chain() const {
    std::vector<audit::ChainFace> faces;
    for (Index f = 0; f < 4 * tets.size(); ++f)
      faces.push_back({audit::face_nodes(tets, f), points[audit::face_apex(tets, f)]});
    return faces;
  }
  bool any_pair_overlaps() const {
    for (Index t = 0; t < tets.size(); ++t)
      for (Index u = 0; u < t; ++u)
        if (audit::interiors_overlap(corners(t), corners(u))) return true;
    return false;
  }
};

// Random tets on a small lattice, so that every degenerate contact occurs.
Soup lattice_tets(std::size_t count, std::uint64_t side, Random& random) {
  Soup soup;
  while (soup.tets.size() < count) {
    TetCorners c;
    for (Point3& p : c)
      p = {double(random.below(side)), double(random.below(side)), double(random.below(side))};
    const int sign = -orient3d(c[0], c[1], c[2], c[3]);
    if (sign == 0) continue;
    if (sign < 0) std::swap(c[2], c[3]);
    const auto first = static_cast<Index>(soup.points.size());
    soup.points.insert(soup.points.end(), c.begin(), c.end());
    soup.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  return soup;
}

TEST(SolidWinding, AgreesWithAllPairsWhereContactsAreProper) {
  Random random(1);
  int disjoint = 0, overlapping = 0, improper = 0;
  for (int round = 0; round < 30000; ++round) {
    const Soup soup = lattice_tets(2 + random.below(3), 2 + random.below(2), random);
    const auto verdict = audit::cover_at_most_once(soup.points, soup.chain());
    const bool overlaps = soup.any_pair_overlaps();
    if (!verdict.improper_contacts.empty()) {
      ++improper;
      continue;
    }
    ASSERT_EQ(verdict.at_most_once, !overlaps) << "round " << round;
    ++(overlaps ? overlapping : disjoint);
  }
  EXPECT_GT(disjoint, 300);
  EXPECT_GT(overlapping, 100);
  EXPECT_GT(improper, 300);
}

// Two tets overlap, by definition, if some small ball is in both: sampled on a finer lattice.
TEST(TetOverlap, AgreesWithSamples) {
  Random random(2);
  int overlapping = 0;
  for (int round = 0; round < 3000; ++round) {
    const Soup soup = lattice_tets(2, 3, random);
    const TetCorners a = soup.corners(0), b = soup.corners(1);
    const auto inside = [](const TetCorners& t, Point3 p) {
      return orient3d(p, t[1], t[2], t[3]) < 0 && orient3d(t[0], p, t[2], t[3]) < 0 &&
             orient3d(t[0], t[1], p, t[3]) < 0 && orient3d(t[0], t[1], t[2], p) < 0;
    };
    bool sampled = false;
    for (int i = 0; i < 4000 && !sampled; ++i) {
      const Point3 p{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)};
      sampled = inside(a, p) && inside(b, p);
    }
    if (sampled) EXPECT_TRUE(audit::interiors_overlap(a, b)) << round;
    if (!audit::interiors_overlap(a, b)) EXPECT_FALSE(sampled) << round;
    overlapping += sampled;
  }
  EXPECT_GT(overlapping, 300);
}

TEST(SolidWinding, AcceptsTilingsWhateverTheOrderAndSeesOneTetTooMany) {
  Random random(3);
  for (const auto& [name, mesh] : test::clean_tet_meshes()) {
    Soup soup;
    soup.points = mesh.points;
    soup.tets = mesh.tets;
    EXPECT_TRUE(audit::cover_at_most_once(soup.points, soup.chain()).at_most_once) << name;
    soup.tets.push_back(soup.tets[random.below(soup.tets.size())]);
    EXPECT_FALSE(audit::cover_at_most_once(soup.points, soup.chain()).at_most_once) << name;
  }
}

TEST(SolidWinding, SeesABodyInsideAnother) {
  const auto all = [](Index, Index, Index) { return true; };
  const TetMesh big = test::cubes(4, 4, 4, all), small = test::cubes(1, 1, 1, all);
  // Free of the big one's nodes, and with a corner on one of them.
  for (const Point3 offset : {Point3{1.25, 1.5, 1.375}, {1, 1, 1}}) {
    const auto report = audit::audit_tet_mesh(test::side_by_side(big, small, offset));
    EXPECT_GT(report.check("no_overlap")->violations, 0u);
    EXPECT_TRUE(report.check("no_improper_contact")->pass());
  }
  EXPECT_TRUE(audit::audit_tet_mesh(test::side_by_side(big, small, {5, 0, 0})).pass());
}

TEST(SolidWinding, AllowsBodiesThatTouchInANodeAnEdgeOrAFace) {
  const auto all = [](Index, Index, Index) { return true; };
  const TetMesh cube = test::cubes(1, 1, 1, all);
  for (const Point3 offset : {Point3{1, 1, 1}, {1, 1, 0}, {1, 0, 0}}) {
    const auto report = audit::audit_tet_mesh(test::side_by_side(cube, cube, offset));
    EXPECT_TRUE(report.pass());
    EXPECT_GT(report.measure("coincident_nodes")->value, 0);
  }
}

TEST(SolidWinding, SeesImproperContacts) {
  const auto all = [](Index, Index, Index) { return true; };
  const TetMesh cube = test::cubes(1, 1, 1, all), big = test::cubes(2, 2, 2, all);
  // A node in a face, an edge across an edge, a node in an edge: no overlap, yet no mesh.
  for (const Point3 offset : {Point3{1, 0.5, 0.25}, {1, 0.5, 1}, {1, 0.5, 0}}) {
    const auto report = audit::audit_tet_mesh(test::side_by_side(cube, cube, offset));
    EXPECT_TRUE(report.check("no_overlap")->pass());
    EXPECT_GT(report.check("no_improper_contact")->violations, 0u);
  }
  const auto report = audit::audit_tet_mesh(test::side_by_side(big, cube, {1.5, 1.5, 1.5}));
  EXPECT_GT(report.check("no_overlap")->violations, 0u);
}

// As tetgen meshes the face of a cube: triangles of a fan around a node whose far edges lie in
// line.
TEST(SolidWinding, AllowsFacesOfOneFanWithTheirFarEdgesInLine) {
  const std::array<Point3, 3> a = {{{-1, 0, -1}, {-1, -0.125, -1}, {-0.75, -0.1875, -1}}};
  const std::array<Point3, 3> b = {{{-1, -0.25, -1}, {-1, -0.375, -1}, {-0.75, -0.1875, -1}}};
  EXPECT_FALSE(audit::meet_improperly(a, {0, 1, 2}, b, {3, 4, 2}));
  EXPECT_FALSE(audit::meet_improperly(b, {3, 4, 2}, a, {0, 1, 2}));
  const std::array<Point3, 3> c = {{{-1, -0.0625, -1}, {-1, -0.375, -1}, {-0.75, -0.1875, -1}}};
  EXPECT_TRUE(audit::meet_improperly(a, {0, 1, 2}, c, {3, 4, 2}));
}

TEST(SolidWinding, TellsAContactFromAnOverlapByOneUnitInTheLastPlace) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0},      {1, 0, 0},      {0, 1, 0},      {0, 0, 1},
                 {0.1, 0.1, -1}, {0.2, 0.1, -1}, {0.1, 0.2, -1}, {0.25, 0.25, 0}};
  mesh.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  auto report = audit::audit_tet_mesh(mesh);
  EXPECT_TRUE(report.check("no_overlap")->pass());
  EXPECT_EQ(report.check("no_improper_contact")->ids, (std::vector<Index>{0, 1}));
  mesh.points[7].z = 0x1p-1074;
  report = audit::audit_tet_mesh(mesh);
  EXPECT_EQ(report.check("no_overlap")->ids, (std::vector<Index>{0, 1}));
  mesh.points[7].z = -0x1p-1074;
  EXPECT_TRUE(audit::audit_tet_mesh(mesh).pass());
}

}  // namespace
}  // namespace wellspaced
