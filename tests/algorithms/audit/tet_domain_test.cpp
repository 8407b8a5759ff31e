#include "wellspaced/algorithms/audit/tet_domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/audit_tet_meshes.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"

namespace wellspaced {
namespace {

using audit::PolyhedralDomain;

audit::Report audit_against(const TetMesh& mesh, const PolyhedralDomain& domain) {
  audit::TetAuditOptions options;
  options.domain = &domain;
  return audit::audit_tet_mesh(mesh, options);
}

// Adds the six rectangles of a box to a domain.
void add_box(PolyhedralDomain& domain, Point3 low, Point3 high) {
  const auto first = static_cast<Index>(domain.points.size());
  for (int i = 0; i < 8; ++i)
    domain.points.push_back(
        {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  for (const std::array<Index, 4>& r : {std::array<Index, 4>{0, 1, 3, 2},
                                        {4, 5, 7, 6},
                                        {0, 1, 5, 4},
                                        {2, 3, 7, 6},
                                        {0, 2, 6, 4},
                                        {1, 3, 7, 5}})
    domain.facets.push_back({{first + r[0], first + r[1], first + r[2], first + r[3]}});
}

bool everywhere(Index, Index, Index) { return true; }

TEST(PolyhedralDomain, IsMetByABox) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {3, 2, 2});
  const auto report = audit_against(test::cubes(3, 2, 2, everywhere), domain);
  EXPECT_TRUE(report.pass());
  EXPECT_EQ(report.measure("facet_allowance")->value, 2);
}

// Areas and volumes of such boxes are no doubles.
TEST(PolyhedralDomain, IsMetByABoxOfAnyScale) {
  for (const double unit : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000})
    for (const double flatness : {0.0, 1e-6}) {
      TetMesh mesh = test::cubes(3, 2, 2, everywhere);
      for (Point3& p : mesh.points) p = {unit * p.x, unit * p.y, unit * p.z};
      Pls box;
      PolyhedralDomain sides;
      add_box(sides, {0, 0, 0}, {3 * unit, 2 * unit, 2 * unit});
      box.points = sides.points;
      for (const auto& facet : sides.facets) box.facets.push_back({facet, {}, 0});
      EXPECT_TRUE(audit_against(mesh, audit::domain_of(box, flatness)).pass())
          << unit << ' ' << flatness;
    }
}

// A block from one face of which a cavity opens; a facet closes the mouth.
PolyhedralDomain block_with_open_cavity() {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {3, 3, 3});
  add_box(domain, {1, 1, 1}, {2, 2, 3});
  domain.facets[1].push_back(domain.facets[7][0]);  // the mouth is a hole of the face above
  domain.holes = {{1.5, 1.5, 2}};
  return domain;
}

TEST(PolyhedralDomain, NeedsNoFacesWhereAHoleOpensToTheOutside) {
  const auto solid = [](Index x, Index y, Index z) { return !(x == 1 && y == 1 && z >= 1); };
  EXPECT_TRUE(audit_against(test::cubes(3, 3, 3, solid), block_with_open_cavity()).pass());
}

TEST(PolyhedralDomain, NeedsFacesAroundAHollowThatIsNoHole) {
  const auto solid = [](Index x, Index y, Index z) { return !(x == 1 && y == 1 && z >= 1); };
  PolyhedralDomain domain = block_with_open_cavity();
  domain.holes.clear();
  const auto report = audit_against(test::cubes(3, 3, 3, solid), domain);
  EXPECT_EQ(report.check("domain_facets_are_faces")->violations, 1u);  // the mouth
}

TEST(PolyhedralDomain, NeedsFacesOnAWallBetweenAHoleAndTheSolid) {
  const auto solid = [](Index x, Index y, Index z) { return !(x == 1 && y == 1 && z >= 1); };
  PolyhedralDomain domain = block_with_open_cavity();
  add_box(domain, {0, 0, 3}, {3, 3, 4});  // a second block on top, not meshed
  domain.facets.erase(domain.facets.begin() + 12);
  const auto report = audit_against(test::cubes(3, 3, 3, solid), domain);
  EXPECT_GE(report.check("domain_facets_are_faces")->violations, 5u);
}

TEST(PolyhedralDomain, IsMetByABoxWithACavity) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {5, 5, 5});
  add_box(domain, {1, 1, 1}, {4, 4, 4});
  const auto solid = [](Index x, Index y, Index z) {
    return !(1 <= x && x < 4 && 1 <= y && y < 4 && 1 <= z && z < 4);
  };
  domain.holes = {{2.5, 2.25, 2}};
  EXPECT_TRUE(audit_against(test::cubes(5, 5, 5, solid), domain).pass());
  const auto filled = audit_against(test::cubes(5, 5, 5, everywhere), domain);
  EXPECT_GT(filled.check("holes_are_open")->violations, 0u);
  domain.facets.resize(6);
  const auto unbounded = audit_against(test::cubes(5, 5, 5, solid), domain);
  EXPECT_EQ(unbounded.check("boundary_on_domain")->violations, 108u);
}

// A frame: the facets above and below have a square hole; one polygon more.
PolyhedralDomain frame() {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {3, 3, 1});
  add_box(domain, {1, 1, 0}, {2, 2, 1});
  domain.facets[0].push_back(domain.facets[6][0]);
  domain.facets[1].push_back(domain.facets[7][0]);
  domain.facets.erase(domain.facets.begin() + 6, domain.facets.begin() + 8);
  return domain;
}

bool in_frame(Index x, Index y, Index) { return x != 1 || y != 1; }

TEST(PolyhedralDomain, HasFacetsWithHoles) {
  EXPECT_TRUE(audit_against(test::cubes(3, 3, 1, in_frame), frame()).pass());
  // Filling the hole of the frame: the inner walls are faces still, but the caps are too many.
  const auto filled = audit_against(test::cubes(3, 3, 1, everywhere), frame());
  EXPECT_EQ(filled.check("boundary_on_domain")->violations, 4u);
}

TEST(PolyhedralDomain, HasInnerFacetsAndDanglingEdges) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {2, 2, 2});
  const Index first = 8;
  domain.points.insert(domain.points.end(),
                       {{1, 0, 0}, {1, 2, 0}, {1, 2, 2}, {1, 0, 2}, {1, 1, 1}});
  domain.facets.push_back({{first, first + 1, first + 2, first + 3}});
  domain.facets[0].push_back({first, first + 1});  // on the bottom, an edge there and back
  domain.segments.push_back({0, first + 4, 0});    // along a diagonal
  const auto report = audit_against(test::cubes(2, 2, 2, everywhere), domain);
  EXPECT_TRUE(report.pass());
}

TEST(PolyhedralDomain, NamesWhatIsMissing) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {2, 2, 2});
  domain.points.push_back({0.5, 1, 1});
  domain.segments.push_back({1, 6, 0});  // a diagonal that the cubes are not cut along
  domain.facets.push_back({{0, 1, 6}});
  const auto report = audit_against(test::cubes(2, 2, 2, everywhere), domain);
  EXPECT_EQ(report.check("domain_points_are_nodes")->ids, std::vector<Index>{8});
  EXPECT_EQ(report.check("domain_segments_are_edges")->ids, (std::vector<Index>{0, 26}));
  EXPECT_EQ(report.check("domain_facets_are_faces")->ids, std::vector<Index>{6});
}

TEST(PolyhedralDomain, RefusesAFacetWithoutArea) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {2, 2, 2});
  domain.points.push_back({1, 0, 0});
  domain.facets.push_back({{0, 8, 1}});
  const auto report = audit_against(test::cubes(2, 2, 2, everywhere), domain);
  EXPECT_EQ(report.check("domain_facets_are_faces")->ids, std::vector<Index>{6});
}

TEST(PolyhedralDomain, SeesAMissingTet) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {3, 2, 2});
  TetMesh mesh = test::cubes(3, 2, 2, everywhere);
  mesh.tets.erase(mesh.tets.begin() + 7);
  EXPECT_GT(audit_against(mesh, domain).check("boundary_on_domain")->violations, 0u);
}

TEST(PolyhedralDomain, SeesABoundaryNodeOffItsFacet) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {2, 2, 2});
  TetMesh mesh = test::cubes(2, 2, 2, everywhere);
  const auto middle = std::find(mesh.points.begin(), mesh.points.end(), Point3{1, 1, 2});
  middle->z = std::nextafter(2, 3);
  EXPECT_TRUE(audit_against(mesh, domain).pass());  // within the allowance
  for (int i = 0; i < 4; ++i) middle->z = std::nextafter(middle->z, 3);
  const auto report = audit_against(mesh, domain);
  EXPECT_EQ(report.check("domain_facets_are_faces")->ids, std::vector<Index>{1});
}

// Turned about two axes: neither the domain's points nor the mesh's are exactly in planes any more.
TEST(PolyhedralDomain, AllowsForRoundingOfSlopingFacets) {
  const auto turned = [](Point3 p) {
    const Point3 q{p.x * 0.8 - p.y * 0.6, p.x * 0.6 + p.y * 0.8, p.z};
    return Point3{q.x, q.y * 0.96 - q.z * 0.28, q.y * 0.28 + q.z * 0.96};
  };
  PolyhedralDomain domain = frame();
  for (Point3& p : domain.points) p = turned(p);
  TetMesh mesh = test::cubes(3, 3, 1, in_frame);
  for (Point3& p : mesh.points) p = turned(p);
  const auto report = audit_against(mesh, domain);
  EXPECT_TRUE(report.check("domain_points_are_nodes")->pass());
  EXPECT_TRUE(report.check("domain_segments_are_edges")->pass());
  EXPECT_TRUE(report.check("domain_facets_are_faces")->pass());
  EXPECT_TRUE(report.check("boundary_on_domain")->pass());
  EXPECT_LE(report.measure("facet_allowance")->value, 64);
}

// ---- Piecewise linear systems

// The six squares of a box, each cut in two triangles, or whole.
Pls box_system(double n, bool triangulated) {
  PolyhedralDomain domain;
  add_box(domain, {0, 0, 0}, {n, n, n});
  Pls system;
  system.points = domain.points;
  for (const auto& facet : domain.facets) {
    const auto& p = facet[0];
    if (!triangulated) {
      system.facets.push_back({{p}, {}, 1});
      continue;
    }
    system.facets.push_back({{{p[0], p[1], p[2]}}, {}, 1});
    system.facets.push_back({{{p[2], p[3], p[0]}}, {}, 1});
  }
  return system;
}

TEST(PolyhedralDomain, UnitesFlatNeighboursOfOneMarker) {
  const Pls system = box_system(2, true);
  const auto domain = audit::domain_of(system);
  ASSERT_EQ(domain.facets.size(), 6u);
  for (const auto& facet : domain.facets) {
    ASSERT_EQ(facet.size(), 1u);
    EXPECT_EQ(facet[0].size(), 4u);
  }
  EXPECT_TRUE(audit_against(test::cubes(2, 2, 2, everywhere), domain).pass());
  Pls marked = system;
  marked.facets[0].marker = 7;
  EXPECT_EQ(audit::domain_of(marked).facets.size(), 7u);
}

TEST(PolyhedralDomain, UnitesNeighboursThatAreNearlyFlatIfToldTo) {
  Pls system = box_system(1, true);
  system.points[0].x -= 1e-9;
  system.points[7].y += 1e-9;
  EXPECT_GT(audit::domain_of(system).facets.size(), 6u);
  EXPECT_EQ(audit::domain_of(system, 1e-10).facets.size(), audit::domain_of(system).facets.size());
  const auto domain = audit::domain_of(system, 1e-6);
  ASSERT_EQ(domain.facets.size(), 6u);
  TetMesh mesh = test::cubes(1, 1, 1, everywhere);
  for (Point3& p : mesh.points) {
    if (p == Point3{0, 0, 0}) p.x -= 1e-9;
    if (p == Point3{1, 1, 1}) p.y += 1e-9;
  }
  EXPECT_TRUE(audit_against(mesh, domain).check("domain_facets_are_faces")->pass());
  EXPECT_TRUE(audit_against(mesh, domain).check("boundary_on_domain")->pass());
}

TEST(PolyhedralDomain, NeedsNoNodesInsideFlatParts) {
  Pls system = box_system(3, true);
  auto& bottom = system.facets[0].polygons[0];
  const Index a = bottom[0], b = bottom[1], c = bottom[2], middle = system.points.size();
  system.points.push_back({1.25, 0.5, 0});
  system.facets[0] = {{{a, b, middle}}, {}, 1};
  system.facets.push_back({{{b, c, middle}}, {}, 1});
  system.facets.push_back({{{c, a, middle}}, {}, 1});
  const auto domain = audit::domain_of(system);
  EXPECT_EQ(domain.facets.size(), 6u);
  EXPECT_EQ(domain.inner_points, std::vector<Index>{middle});
  EXPECT_TRUE(audit_against(test::cubes(3, 3, 3, everywhere), domain)
                  .check("domain_points_are_nodes")
                  ->pass());
}

// The lower square has an inner square of cells as a polygon: an outline unless it is a hole.
TEST(PolyhedralDomain, TakesAnInnerPolygonForAHoleOnlyWithAHolePoint) {
  Pls system = box_system(3, false);
  for (const Point3 p : {Point3{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}})
    system.points.push_back(p);
  system.facets[0].polygons.push_back({8, 9, 10, 11});
  const TetMesh solid = test::cubes(3, 3, 3, everywhere);
  EXPECT_TRUE(audit_against(solid, audit::domain_of(system)).pass());
  system.facets[0].holes = {{1.5, 1.25, 0}};
  const auto report = audit_against(solid, audit::domain_of(system));
  EXPECT_TRUE(report.check("domain_facets_are_faces")->pass());
  EXPECT_EQ(report.check("boundary_on_domain")->violations, 2u);
}

}  // namespace
}  // namespace wellspaced
