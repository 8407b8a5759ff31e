// The auditor on meshes that CGAL makes: its Delaunay and conforming meshes are what they claim.
// Built only where CGAL is found.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <list>
#include <map>
#include <vector>

#include "tests/support/points3.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"

namespace wellspaced {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// ---- The plane

using PlaneMesher = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                 CGAL::Delaunay_mesh_face_base_2<Kernel>>>;

TriangleMesh mesh_of(const PlaneMesher& peer) {
  TriangleMesh mesh;
  std::map<PlaneMesher::Vertex_handle, Index> number;
  for (const auto v : peer.finite_vertex_handles()) {
    number[v] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back({v->point().x(), v->point().y()});
  }
  for (const auto f : peer.finite_face_handles())
    if (f->is_in_domain())
      mesh.triangles.push_back({number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)]});
  for (const auto& e : peer.constrained_edges())
    mesh.segments.push_back({number[e.first->vertex(peer.cw(e.second))],
                             number[e.first->vertex(peer.ccw(e.second))], 1});
  return mesh;
}

const Pslg kDomain = {{{0, 0}, {8, 0}, {8, 4}, {5, 4}, {5, 7}, {0, 7}, {2, 2}, {3, 2}, {2.5, 3}},
                      {{0, 1, 1},
                       {1, 2, 1},
                       {2, 3, 1},
                       {3, 4, 1},
                       {4, 5, 1},
                       {5, 0, 1},
                       {6, 7, 1},
                       {7, 8, 1},
                       {8, 6, 1}},
                      {{2.5, 2.5}},
                      {},
                      {}};

TEST(AuditOfCgal, FindsItsRefinedPlaneMeshAsGoodAsItClaims) {
  PlaneMesher peer;
  for (const Segment& s : kDomain.segments)
    peer.insert_constraint(Kernel::Point_2(kDomain.points[s.a].x, kDomain.points[s.a].y),
                           Kernel::Point_2(kDomain.points[s.b].x, kDomain.points[s.b].y));
  const std::list<Kernel::Point_2> seeds = {{2.5, 2.5}};
  CGAL::refine_Delaunay_mesh_2(peer, seeds.begin(), seeds.end(),
                               CGAL::Delaunay_mesh_size_criteria_2<PlaneMesher>(0.125, 0.5));
  const TriangleMesh mesh = mesh_of(peer);
  audit::MeshAuditOptions options;
  options.domain = &kDomain;
  const auto report = audit::audit_mesh(mesh, options);
  for (const auto& check : report.checks)
    EXPECT_TRUE(check.pass() || !check.required) << check.name << " " << check.violations;
  EXPECT_TRUE(report.check("constrained_delaunay")->pass());
  EXPECT_TRUE(report.check("boundary_gabriel")->pass());
  EXPECT_EQ(report.measure("holes")->value, 1);
  EXPECT_GE(report.measure("min_angle")->value, 20.7);
  EXPECT_LE(report.measure("longest_edge")->value, 0.5);
}

// ---- Space

using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using SolidPeer = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<VertexBase,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;

TEST(AuditOfCgal, FindsItsDelaunayMeshesOfEveryFamilySound) {
  for (const auto& [name, points] : test::degenerate_sets3()) {
    std::vector<std::pair<Kernel::Point_3, Index>> input;
    for (Index v = 0; v < points.size(); ++v)
      input.emplace_back(Kernel::Point_3(points[v].x, points[v].y, points[v].z), v);
    const SolidPeer peer(input.begin(), input.end());
    if (peer.dimension() < 3) continue;
    TetMesh mesh;
    mesh.points = points;
    for (const auto c : peer.finite_cell_handles())
      mesh.tets.push_back(
          {c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
    const auto report = audit::audit_tet_mesh(mesh);
    for (const auto& check : report.checks)
      EXPECT_TRUE(check.pass() || !check.required) << name << ": " << check.name;
    EXPECT_TRUE(report.check("delaunay")->pass()) << name;
  }
}

}  // namespace
}  // namespace wellspaced
