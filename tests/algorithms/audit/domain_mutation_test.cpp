// Plants faults in meshes that conform to a domain: each must be found by exactly the checks that
// should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/audit_tet_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"

namespace wellspaced {
namespace {

using test::any;
using test::Names;
using test::operator+;

// ---- The plane: an n x n lattice with a square hole, and its domain of eight segments

struct Conforming {
  TriangleMesh mesh;
  Pslg domain;
};

Conforming lattice_ring(Index n) {
  Conforming ring;
  const Index low = n / 3, high = n - n / 3;
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x <= n; ++x) ring.mesh.points.push_back({1.0 * x, 1.0 * y});
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      if (x >= low && x < high && y >= low && y < high) continue;
      const Index a = (n + 1) * y + x;
      ring.mesh.triangles.push_back({a, a + 1, a + n + 2});
      ring.mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  const double l = low, h = high, s = n;
  ring.domain.points = {{0, 0}, {s, 0}, {s, s}, {0, s}, {l, l}, {h, l}, {h, h}, {l, h}};
  ring.domain.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1},
                          {4, 5, 1}, {5, 6, 1}, {6, 7, 1}, {7, 4, 1}};
  ring.domain.holes = {{l + 0.5, l + 0.25}};
  return ring;
}

audit::Report audit_plane(const Conforming& input) {
  audit::MeshAuditOptions options;
  options.domain = &input.domain;
  return audit::audit_mesh(input.mesh, options);
}

const Names kRims = {"manifold_nodes", "no_unused_node", "circumcentres_inside", "gabriel",
                     "boundary_gabriel"};
const Names kCircles = {"constrained_delaunay", "delaunay", "gabriel", "boundary_gabriel",
                        "circumcentres_inside"};

Index node_at(const TriangleMesh& mesh, Point2 p) {
  const auto at = std::find(mesh.points.begin(), mesh.points.end(), p);
  return static_cast<Index>(at - mesh.points.begin());
}

bool fill_the_hole(Conforming& c, Random&) {
  const Point2 low = c.domain.points[4], high = c.domain.points[6];
  for (double y = low.y; y < high.y; ++y)
    for (double x = low.x; x < high.x; ++x) {
      const auto node = [&](double i, double j) { return node_at(c.mesh, {x + i, y + j}); };
      c.mesh.triangles.push_back({node(0, 0), node(1, 0), node(1, 1)});
      c.mesh.triangles.push_back({node(0, 0), node(1, 1), node(0, 1)});
    }
  return true;
}

bool lose_a_triangle(Conforming& c, Random& random) {
  c.mesh.triangles.erase(c.mesh.triangles.begin() + any(c.mesh.triangles.size(), random));
  return true;
}

// A node on the lower side that is no corner.
Index node_on_a_side(const Conforming& c, Random& random) {
  const auto n = static_cast<Index>(c.domain.points[1].x);
  return 1 + any(n - 1, random);
}

bool lift_a_boundary_node(Conforming& c, Random& random) {
  c.mesh.points[node_on_a_side(c, random)].y = 0.125;
  return true;
}

// A node of the right side, by 16 units in the last place: beyond what rounding excuses.
bool dent_a_side_by_a_hair(Conforming& c, Random& random) {
  const double side = c.domain.points[1].x;
  const Index v = node_at(c.mesh, {side, 1.0 + any(static_cast<std::size_t>(side) - 1, random)});
  for (int i = 0; i < 16; ++i) c.mesh.points[v].x = std::nextafter(c.mesh.points[v].x, 0);
  return true;
}

bool add_a_point(Conforming& c, Random& random) {
  c.domain.points.push_back({random.uniform(), random.uniform()});
  return true;
}

bool add_a_segment_against_the_diagonals(Conforming& c, Random&) {
  c.domain.segments.push_back({1, 5, 1});
  return true;
}

bool move_a_corner_of_the_domain(Conforming& c, Random& random) {
  Point2& p = c.domain.points[random.below(4)];
  p.x = std::nextafter(p.x, 100);
  return true;
}

bool move_the_hole_seed(Conforming& c, Random& random) {
  c.domain.holes[0] = {random.uniform(), random.uniform()};
  return true;
}

TEST(DomainMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  test::MutationTest<Conforming> table(audit_plane, {"no_unused_node"});
  for (const Index n : {6u, 9u, 14u})
    table.add_clean("ring of " + std::to_string(n), lattice_ring(n), 8);
  const Names moved = {"domain_segments_are_edges", "boundary_on_domain"};
  table.run({{"filled hole", fill_the_hole, {"holes_are_open"}, kCircles},
             {"missing triangle", lose_a_triangle, {"boundary_on_domain"}, kRims + moved},
             {"boundary node off its segment", lift_a_boundary_node, moved, kCircles},
             {"boundary node off by 16 units in the last place", dent_a_side_by_a_hair, moved,
              kCircles + Names{"domain_segments_exact"}},
             {"point without a node", add_a_point, {"domain_points_are_nodes"}, {}},
             {"segment that edges cross",
              add_a_segment_against_the_diagonals,
              {"domain_segments_are_edges"},
              {}},
             {"corner moved by a unit in the last place",
              move_a_corner_of_the_domain,
              {"domain_points_are_nodes", "domain_segments_are_edges", "boundary_on_domain"},
              {"domain_segments_exact"}},
             {"hole seed in the mesh", move_the_hole_seed, {"holes_are_open"}, {}}},
            10);
}

// ---- Space: a box of cubes with a cavity

struct ConformingSolid {
  TetMesh mesh;
  audit::PolyhedralDomain domain;
};

void add_box(audit::PolyhedralDomain& domain, double low, double high) {
  const auto first = static_cast<Index>(domain.points.size());
  for (int i = 0; i < 8; ++i)
    domain.points.push_back({i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low});
  for (const std::array<Index, 4>& r : {std::array<Index, 4>{0, 1, 3, 2},
                                        {4, 5, 7, 6},
                                        {0, 1, 5, 4},
                                        {2, 3, 7, 6},
                                        {0, 2, 6, 4},
                                        {1, 3, 7, 5}})
    domain.facets.push_back({{first + r[0], first + r[1], first + r[2], first + r[3]}});
}

ConformingSolid hollow_box(Index n) {
  const Index low = 1, high = n - 1;
  ConformingSolid solid;
  solid.mesh = test::cubes(n, n, n, [=](Index x, Index y, Index z) {
    return !(low <= x && x < high && low <= y && y < high && low <= z && z < high);
  });
  add_box(solid.domain, 0, n);
  add_box(solid.domain, low, high);
  solid.domain.holes = {{n / 2.0 + 0.125, n / 2.0 + 0.25, n / 2.0}};
  return solid;
}

audit::Report audit_solid(const ConformingSolid& input) {
  audit::TetAuditOptions options;
  options.domain = &input.domain;
  return audit::audit_tet_mesh(input.mesh, options);
}

bool lose_a_tet(ConformingSolid& s, Random& random) {
  s.mesh.tets.erase(s.mesh.tets.begin() + any(s.mesh.tets.size(), random));
  s.mesh.facets.clear();
  return true;
}

// A node inside a face of the outer box.
bool dent_a_face(ConformingSolid& s, Random& random) {
  const double n = s.domain.points[1].x;
  const Point3 place{1 + std::floor(random.uniform() * (n - 1)),
                     1 + std::floor(random.uniform() * (n - 1)), n};
  for (Point3& p : s.mesh.points)
    if (p == place) {
      for (int i = 0; i < 16; ++i) p.z = std::nextafter(p.z, 0);
      return true;
    }
  return false;
}

bool drop_the_cavity_from_the_domain(ConformingSolid& s, Random&) {
  s.domain.facets.resize(6);
  return true;
}

bool move_the_seed_into_the_solid(ConformingSolid& s, Random& random) {
  s.domain.holes[0] = {random.uniform(), random.uniform(), random.uniform()};
  return true;
}

bool add_a_facet_through_tets(ConformingSolid& s, Random&) {
  s.domain.facets.push_back({{0, 1, 6}});
  return true;
}

bool add_a_point_in_space(ConformingSolid& s, Random& random) {
  s.domain.points.push_back({random.uniform(), random.uniform(), random.uniform()});
  return true;
}

TEST(SolidDomainMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  const Names optional = {"gabriel", "boundary_gabriel", "circumcentres_inside", "no_sliver"};
  const Names spheres = optional + Names{"constrained_delaunay", "delaunay"};
  const Names rims =
      optional + Names{"no_unused_node", "manifold_boundary_edges", "manifold_boundary_nodes",
                       "domain_segments_are_edges", "domain_facets_are_faces"};
  test::MutationTest<ConformingSolid> table(audit_solid, optional);
  for (const Index n : {3u, 5u}) table.add_clean("box of " + std::to_string(n), hollow_box(n), 6);
  table.run({{"missing tet", lose_a_tet, {"boundary_on_domain"}, rims},
             {"face dented by 16 units in the last place",
              dent_a_face,
              {"domain_facets_are_faces", "boundary_on_domain"},
              spheres},
             {"cavity that the domain has not",
              drop_the_cavity_from_the_domain,
              {"boundary_on_domain"},
              {}},
             {"hole seed in the solid", move_the_seed_into_the_solid, {"holes_are_open"}, {}},
             {"facet that tets cross",
              add_a_facet_through_tets,
              {"domain_facets_are_faces", "domain_segments_are_edges"},
              {}},
             {"point without a node", add_a_point_in_space, {"domain_points_are_nodes"}, {}}},
            10);
}

}  // namespace
}  // namespace wellspaced
