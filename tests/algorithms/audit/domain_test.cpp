#include "wellspaced/algorithms/audit/domain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"

namespace wellspaced {
namespace {

Pslg domain_of(const TriangleMesh& mesh) {
  Pslg domain;
  domain.points = mesh.points;
  domain.segments = mesh.segments;
  return domain;
}

audit::Report audit_against(const TriangleMesh& mesh, const Pslg& domain) {
  audit::MeshAuditOptions options;
  options.domain = &domain;
  return audit::audit_mesh(mesh, options);
}

std::uint64_t violations(const audit::Report& report, const char* name) {
  const auto* check = report.check(name);
  return check == nullptr ? 0 : check->violations;
}

// A square with a hole, cut by a line across it: all nodes on a lattice.
TriangleMesh lattice_ring() {
  TriangleMesh mesh;
  for (int y = 0; y <= 6; ++y)
    for (int x = 0; x <= 6; ++x) mesh.points.push_back({double(x), double(y)});
  for (Index y = 0; y < 6; ++y)
    for (Index x = 0; x < 6; ++x) {
      if (x >= 2 && x < 4 && y >= 2 && y < 4) continue;
      const Index a = 7 * y + x;
      mesh.triangles.push_back({a, a + 1, a + 8});
      mesh.triangles.push_back({a, a + 8, a + 7});
    }
  return mesh;
}

Pslg ring_domain() {
  Pslg domain;
  domain.points = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {4, 4}, {2, 4}};
  domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  domain.holes = {{3, 3}};
  return domain;
}

TEST(Domain, AcceptsChainsOfEdgesAlongItsSegments) {
  auto domain = ring_domain();
  domain.segments.push_back({0, 4});  // a dangling segment along a diagonal
  const auto report = audit_against(lattice_ring(), domain);
  EXPECT_TRUE(report.pass());
  EXPECT_TRUE(report.check("domain_segments_exact")->pass());
  EXPECT_NE(report.check("boundary_on_domain"), nullptr);
}

TEST(Domain, EveryCleanMeshConformsToItsOwnBoundary) {
  for (const auto& [name, mesh] : test::clean_meshes())
    EXPECT_TRUE(audit_against(mesh, domain_of(mesh)).pass()) << name;
}

TEST(Domain, NamesThePointWithoutANode) {
  auto domain = ring_domain();
  domain.points.push_back({5, 2.5});
  const auto report = audit_against(lattice_ring(), domain);
  EXPECT_EQ(report.check("domain_points_are_nodes")->ids, std::vector<Index>{8});
  EXPECT_FALSE(report.pass());
}

TEST(Domain, NamesTheSegmentThatIsCrossed) {
  auto domain = ring_domain();
  domain.segments.push_back({1, 5});  // against the diagonals of the cells
  const auto report = audit_against(lattice_ring(), domain);
  EXPECT_EQ(report.check("domain_segments_are_edges")->ids, std::vector<Index>{8});
}

TEST(Domain, SeesAFilledHole) {
  TriangleMesh mesh = lattice_ring();
  for (const Index a : {16, 17, 23, 24}) {
    mesh.triangles.push_back({a, a + 1, a + 8});
    mesh.triangles.push_back({a, a + 8, a + 7});
  }
  const auto report = audit_against(mesh, ring_domain());
  EXPECT_GT(violations(report, "holes_are_open"), 0u);
  EXPECT_FALSE(report.pass());
  audit::MeshAuditOptions options;
  const std::vector<Point2> seeds = {{2.5, 3.25}};
  options.holes = seeds;
  EXPECT_EQ(violations(audit::audit_mesh(mesh, options), "holes_are_open"), 1u);
}

TEST(Domain, SeesAMissingTriangleAndAFilledNotch) {
  TriangleMesh mesh = lattice_ring();
  mesh.triangles.erase(mesh.triangles.begin() + 2);
  EXPECT_GT(violations(audit_against(mesh, ring_domain()), "boundary_on_domain"), 0u);
  TriangleMesh beyond = lattice_ring();
  beyond.points.push_back({7, 0});
  beyond.triangles.push_back({6, 49, 13});
  EXPECT_EQ(violations(audit_against(beyond, ring_domain()), "boundary_on_domain"), 2u);
}

TEST(Domain, TellsALostBoundaryNodeFromAKeptOne) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, 4}, {2, 0}};
  mesh.triangles = {{0, 3, 2}, {3, 1, 2}};
  Pslg domain = domain_of(mesh);
  domain.segments = {{0, 3}, {3, 1}, {1, 2}, {2, 0}};
  EXPECT_TRUE(audit_against(mesh, domain).pass());
  TriangleMesh lost = mesh;
  lost.triangles = {{0, 1, 2}};
  const auto report = audit_against(lost, domain);
  EXPECT_EQ(report.check("domain_segments_are_edges")->ids, (std::vector<Index>{0, 1}));
}

// One third of the way along a sloping segment there is no representable point.
TEST(Domain, AllowsNodesWithinRoundingOfASegmentAndListsThem) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {3, 1}, {0, 5}, {1, 1.0 / 3}};
  mesh.triangles = {{0, 3, 2}, {3, 1, 2}};
  Pslg domain;
  domain.points = {{0, 0}, {3, 1}, {0, 5}};
  domain.segments = {{0, 1}, {1, 2}, {2, 0}};
  auto report = audit_against(mesh, domain);
  EXPECT_TRUE(report.pass());
  EXPECT_EQ(report.check("domain_segments_exact")->ids, std::vector<Index>{3});
  for (int i = 0; i < 20; ++i) mesh.points[3].y = std::nextafter(mesh.points[3].y, 0);
  report = audit_against(mesh, domain);
  EXPECT_EQ(report.check("domain_segments_are_edges")->ids, std::vector<Index>{0});
}

TEST(Domain, MarksBothLipsOfASlit) {
  const TriangleMesh mesh = test::slit_square(4);
  Pslg domain;
  domain.points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {4, 4}};
  domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {4, 5}};
  EXPECT_TRUE(audit_against(mesh, domain).pass());
  domain.segments.pop_back();
  EXPECT_EQ(violations(audit_against(mesh, domain), "boundary_on_domain"), 8u);
}

TEST(Domain, LetsATriangulationOfTheHullBe) {
  const TriangleMesh mesh = test::random_mesh(50, 3);
  Pslg domain;
  domain.points = mesh.points;
  domain.segments = {{mesh.triangles[7][0], mesh.triangles[7][1]}};
  EXPECT_TRUE(audit_against(mesh, domain).pass());
}

}  // namespace
}  // namespace wellspaced
