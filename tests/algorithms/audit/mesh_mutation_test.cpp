// Plants faults in clean meshes: each must be found by exactly the checks that should find it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::any;
using test::Names;
using test::operator+;
using Fault = test::Fault<TriangleMesh>;

// What moving or losing triangles entails: the mesh has other edges, so other circles.
const Names kCircles = {"constrained_delaunay", "delaunay", "gabriel", "boundary_gabriel",
                        "circumcentres_inside"};
// What unpairing edges entails: they become boundary edges.
const Names kRims = {"boundary_has_segments", "manifold_nodes", "boundary_gabriel",
                     "circumcentres_inside", "gabriel"};

Index any_triangle(const TriangleMesh& mesh, Random& random) {
  return any(mesh.triangles.size(), random);
}

using EdgeMap = std::map<std::pair<Index, Index>, Index>;

// The triangle left of each directed edge.
EdgeMap left_triangles(const TriangleMesh& mesh) {
  EdgeMap edges;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) edges[{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]}] = t;
  return edges;
}

bool is_segment(const TriangleMesh& mesh, Index a, Index b) {
  return std::any_of(mesh.segments.begin(), mesh.segments.end(), [&](const Segment& s) {
    return (s.a == a && s.b == b) || (s.a == b && s.b == a);
  });
}

// An edge with a triangle on both sides: a -> b with apex c on its left and d on its right.
struct InnerEdge {
  Index a, b, c, d, left, right;
};

Index apex_of(const std::array<Index, 3>& t, Index a, Index b) {
  for (const Index v : t)
    if (v != a && v != b) return v;
  return kNoIndex;
}

std::optional<InnerEdge> any_inner_edge(const TriangleMesh& mesh, Random& random) {
  const EdgeMap edges = left_triangles(mesh);
  for (int tries = 0; tries < 1000; ++tries) {
    const Index t = any_triangle(mesh, random), i = any(3, random);
    const Index a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
    const auto twin = edges.find({b, a});
    if (twin == edges.end() || is_segment(mesh, a, b)) continue;
    const Index u = twin->second;
    return InnerEdge{a, b, apex_of(mesh.triangles[t], a, b), apex_of(mesh.triangles[u], a, b),
                     t, u};
  }
  return std::nullopt;
}

std::optional<Index> any_inner_node(const TriangleMesh& mesh, Random& random) {
  std::set<Index> outer;
  for (const Segment& s : mesh.segments) outer.insert({s.a, s.b});
  std::vector<Index> inner;
  for (Index v = 0; v < mesh.points.size(); ++v)
    if (outer.count(v) == 0) inner.push_back(v);
  if (inner.empty()) return std::nullopt;
  return inner[random.below(inner.size())];
}

Index new_node(TriangleMesh& mesh, Point2 p) {
  mesh.points.push_back(p);
  if (!mesh.point_markers.empty()) mesh.point_markers.push_back(0);
  return static_cast<Index>(mesh.points.size() - 1);
}

Point2 middle(Point2 p, Point2 q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

int orientation(const TriangleMesh& mesh, const std::array<Index, 3>& t) {
  return orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

// Moves an inner node towards the far edge of one of its triangles until that is no more
// counter-clockwise, and by no more than one unit in the last place beyond.
bool move_across_an_edge(TriangleMesh& mesh, Random& random, int wanted) {
  const auto v = any_inner_node(mesh, random);
  if (!v) return false;
  std::vector<Index> star;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), *v) > 0) star.push_back(t);
  const Index t = star[random.below(star.size())];
  const auto& corners = mesh.triangles[t];
  const int at = static_cast<int>(std::find(corners.begin(), corners.end(), *v) - corners.begin());
  const Point2 p = mesh.points[corners[(at + 1) % 3]], q = mesh.points[corners[(at + 2) % 3]];
  const Point2 inside = mesh.points[*v];
  mesh.points[*v] = middle(p, q);
  const bool by_x =
      std::fabs(inside.x - mesh.points[*v].x) > std::fabs(inside.y - mesh.points[*v].y);
  double& moving = by_x ? mesh.points[*v].x : mesh.points[*v].y;
  const double inwards = by_x ? inside.x : inside.y;
  const double outwards = inwards > moving ? -1e9 : 1e9;
  for (int step = 0; step < 8 && orientation(mesh, corners) < wanted; ++step)
    moving = std::nextafter(moving, inwards);
  for (int step = 0; step < 8 && orientation(mesh, corners) > wanted; ++step)
    moving = std::nextafter(moving, outwards);
  return orientation(mesh, corners) == wanted;
}

// Two neighbours take each other's place, as if their lines in the file were swapped.
bool swap_two_nodes(TriangleMesh& mesh, Random& random) {
  std::set<Index> outer;
  for (const Segment& s : mesh.segments) outer.insert({s.a, s.b});
  for (int tries = 0; tries < 200; ++tries) {
    const auto e = any_inner_edge(mesh, random);
    if (!e) return false;
    if (outer.count(e->a) > 0 || outer.count(e->b) > 0) continue;
    std::swap(mesh.points[e->a], mesh.points[e->b]);
    return true;
  }
  return false;
}

bool split_one_side(TriangleMesh& mesh, Random& random) {
  const auto e = any_inner_edge(mesh, random);
  if (!e) return false;
  const Point2 p = middle(mesh.points[e->a], mesh.points[e->b]);
  if (orient2d(mesh.points[e->a], mesh.points[e->b], p) != 0) return false;
  const Index m = new_node(mesh, p);
  mesh.triangles[e->left] = {e->a, m, e->c};
  mesh.triangles.push_back({m, e->b, e->c});
  return true;
}

// Replaces one diagonal of a strictly convex quadrilateral by the other.
bool flip_edge(TriangleMesh& mesh, Random& random) {
  for (int tries = 0; tries < 50; ++tries) {
    const auto e = any_inner_edge(mesh, random);
    if (!e) return false;
    const auto& p = mesh.points;
    if (incircle(p[e->a], p[e->b], p[e->c], p[e->d]) == 0) continue;
    if (orient2d(p[e->c], p[e->d], p[e->a]) * orient2d(p[e->c], p[e->d], p[e->b]) >= 0) continue;
    mesh.triangles[e->left] = {e->c, e->a, e->d};
    mesh.triangles[e->right] = {e->d, e->b, e->c};
    return true;
  }
  return false;
}

// A square cut along a diagonal, whose far corner is nearer to the centre by one unit in the last
// place than the circle through the other three: as another component.
bool add_hair_fault(TriangleMesh& mesh, Random&) {
  TriangleMesh square;
  square.points = {{0, 0}, {1, 0}, {std::nextafter(1, 0), std::nextafter(1, 0)}, {0, 1}};
  square.triangles = {{0, 1, 3}, {1, 2, 3}};
  test::add_boundary_segments(square);
  const auto markers = mesh.point_markers;
  mesh = test::side_by_side(mesh, square, {0, 64});
  // Moving rounds the hair away; put it back at its scale.
  const std::size_t far = mesh.points.size() - 2;
  mesh.points[far] = {std::nextafter(1, 0), std::nextafter(65, 0)};
  mesh.point_markers = markers;
  mesh.point_markers.resize(markers.empty() ? 0 : mesh.points.size());
  return true;
}

bool add_shifted_sheet(TriangleMesh& mesh, Random& random) {
  const Index t = any_triangle(mesh, random);
  std::array<Index, 3> copy;
  for (int i = 0; i < 3; ++i) copy[i] = new_node(mesh, mesh.points[mesh.triangles[t][i]]);
  const Point2 a = mesh.points[copy[0]], b = mesh.points[copy[1]], c = mesh.points[copy[2]];
  mesh.points[copy[0]] = {(2 * a.x + b.x + c.x) / 4, (2 * a.y + b.y + c.y) / 4};
  mesh.triangles.push_back(copy);
  return true;
}

bool add_fin(TriangleMesh& mesh, Random& random) {
  const auto e = any_inner_edge(mesh, random);
  if (!e) return false;
  const Point2 p = middle(mesh.points[e->c], middle(mesh.points[e->a], mesh.points[e->b]));
  mesh.triangles.push_back({e->a, e->b, new_node(mesh, p)});
  return true;
}

bool crack_open(TriangleMesh& mesh, Random& random) {
  const auto e = any_inner_edge(mesh, random);
  if (!e) return false;
  const Index copy = new_node(mesh, mesh.points[e->c]);
  std::replace(mesh.triangles[e->left].begin(), mesh.triangles[e->left].end(), e->c, copy);
  return true;
}

// Two triangles on nodes of their own, the second inside the first but for one common corner.
bool add_glued_overlap(TriangleMesh& mesh, Random&) {
  const Index a = new_node(mesh, {100, 100}), b = new_node(mesh, {108, 100});
  const Index c = new_node(mesh, {100, 108});
  const Index d = new_node(mesh, {102, 100.5}), e = new_node(mesh, {100.5, 102});
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, d, e});
  return true;
}

bool add_triangles_glued_at_a_node(TriangleMesh& mesh, Random&) {
  const Index a = new_node(mesh, {100, 100}), b = new_node(mesh, {108, 100});
  const Index c = new_node(mesh, {100, 108}), d = new_node(mesh, {92, 100});
  const Index e = new_node(mesh, {100, 92});
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, d, e});
  return true;
}

// A torus of quads laid flat: every edge has two triangles, half of which must be inverted.
bool add_handle(TriangleMesh& mesh, Random&) {
  const Index n = 4, base = static_cast<Index>(mesh.points.size());
  for (Index i = 0; i < n * n; ++i)
    new_node(mesh, {100.0 + i % n + 0.125 * (i / n), 100.0 + i / n});
  const auto node = [&](Index i, Index j) { return base + (i % n) + n * (j % n); };
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  return true;
}

std::vector<Fault> syntax_faults() {
  return {
      {"index out of range",
       [](TriangleMesh& m, Random& r) {
         m.triangles[any_triangle(m, r)][r.below(3)] =
             static_cast<Index>(m.points.size() + r.below(2) * 1000000);
         return true;
       },
       {"valid_indices"},
       {}},
      {"triangle names a node twice",
       [](TriangleMesh& m, Random& r) {
         auto& t = m.triangles[any_triangle(m, r)];
         const Index i = any(3, r);
         t[i] = t[(i + 1) % 3];
         return true;
       },
       {"distinct_corners"},
       {}},
      {"coordinate not a number",
       [](TriangleMesh& m, Random& r) {
         m.points[r.below(m.points.size())].y = std::numeric_limits<double>::quiet_NaN();
         return true;
       },
       {"finite_coordinates"},
       {}},
      {"infinite coordinate",
       [](TriangleMesh& m, Random& r) {
         m.points[r.below(m.points.size())].x = -std::numeric_limits<double>::infinity();
         return true;
       },
       {"finite_coordinates"},
       {}},
      {"segment to nowhere",
       [](TriangleMesh& m, Random& r) {
         m.segments[r.below(m.segments.size())].b = static_cast<Index>(m.points.size());
         return true;
       },
       {"valid_segments"},
       {}},
      {"segment without length",
       [](TriangleMesh& m, Random& r) {
         auto& s = m.segments[r.below(m.segments.size())];
         s.b = s.a;
         return true;
       },
       {"valid_segments"},
       {}},
      {"marker missing",
       [](TriangleMesh& m, Random&) {
         m.point_markers.assign(m.points.size() - 1, 0);
         return true;
       },
       {"valid_node_data"},
       {}},
      {"fixed node missing",
       [](TriangleMesh& m, Random&) {
         m.fixed = {static_cast<Index>(m.points.size())};
         return true;
       },
       {"valid_node_data"},
       {}},
  };
}

std::vector<Fault> topology_faults() {
  return {
      {"doubled triangle",
       [](TriangleMesh& m, Random& r) {
         auto t = m.triangles[any_triangle(m, r)];
         std::rotate(t.begin(), t.begin() + any(3, r), t.end());
         m.triangles.push_back(t);
         return true;
       },
       {"no_duplicate_triangle", "no_overlap"},
       Names{"manifold_edges", "consistent_orientation"} + kRims},
      {"third triangle on an edge", add_fin, {"manifold_edges", "no_overlap"}, kRims + kCircles},
      {"handle",
       add_handle,
       {"euler", "no_inverted", "no_overlap"},
       kRims + kCircles + Names{"no_flat", "no_hanging_node"}},
      {"components glued at a node", add_triangles_glued_at_a_node, {"manifold_nodes"}, kRims},
      {"unused node",
       [](TriangleMesh& m, Random& r) {
         new_node(m, {r.uniform(), r.uniform()});
         return true;
       },
       {"no_unused_node"},
       {}},
      {"doubled marker",
       [](TriangleMesh& m, Random& r) {
         Segment s = m.segments[r.below(m.segments.size())];
         if (r.below(2) == 0) std::swap(s.a, s.b);
         s.marker += 1;
         m.segments.push_back(s);
         return true;
       },
       {"no_duplicate_segment", "one_marker_per_edge"},
       {}},
      {"lost segment",
       [](TriangleMesh& m, Random& r) {
         m.segments.erase(m.segments.begin() + any(m.segments.size(), r));
         return true;
       },
       {"boundary_has_segments"},
       {}},
      {"segment that is no edge",
       [](TriangleMesh& m, Random& r) {
         const EdgeMap edges = left_triangles(m);
         for (;;) {
           const Index a = any(m.points.size(), r), b = any(m.points.size(), r);
           if (a == b || edges.count({a, b}) + edges.count({b, a}) > 0) continue;
           m.segments.push_back({a, b, 1});
           return true;
         }
       },
       {"segments_are_edges"},
       {}},
      {"missing triangle",
       [](TriangleMesh& m, Random& r) {
         const auto e = any_inner_edge(m, r);
         if (!e) return false;
         m.triangles.erase(m.triangles.begin() + e->left);
         return true;
       },
       {"boundary_has_segments"},
       kRims + Names{"segments_are_edges", "no_unused_node"}},
      {"crack opened at an edge",
       crack_open,
       {"boundary_has_segments"},
       kRims + Names{"segments_are_edges"}},
  };
}

std::vector<Fault> embedding_faults() {
  return {
      {"flipped triangle",
       [](TriangleMesh& m, Random& r) {
         const auto e = any_inner_edge(m, r);
         if (!e) return false;
         std::swap(m.triangles[e->left][0], m.triangles[e->left][1]);
         return true;
       },
       {"no_inverted", "consistent_orientation"},
       kRims},
      {"all triangles clockwise",
       [](TriangleMesh& m, Random&) {
         for (auto& t : m.triangles) std::swap(t[0], t[1]);
         return true;
       },
       {"no_inverted"},
       {}},
      {"node moved across an edge by a unit in the last place",
       [](TriangleMesh& m, Random& r) { return move_across_an_edge(m, r, -1); },
       {"no_inverted", "no_overlap"},
       kCircles + Names{"no_hanging_node"}},
      {"node moved onto an edge",
       [](TriangleMesh& m, Random& r) { return move_across_an_edge(m, r, 0); },
       {"no_flat"},
       kCircles + Names{"no_hanging_node", "no_overlap", "no_inverted"}},
      {"two neighbouring nodes swapped",
       swap_two_nodes,
       {"no_inverted", "no_overlap"},
       kCircles + Names{"no_flat", "no_hanging_node"}},
      {"hanging node", split_one_side, {"no_hanging_node"}, kRims + kCircles},
      {"overlapping sheet", add_shifted_sheet, {"no_overlap"}, kRims},
      {"overlap of pieces glued at a node",
       add_glued_overlap,
       {"no_overlap", "manifold_nodes"},
       kRims},
  };
}

std::vector<Fault> delaunay_faults() {
  return {
      {"edge flipped the wrong way", flip_edge, {"constrained_delaunay", "delaunay"}, kCircles},
      {"edge not Delaunay by a hair",
       add_hair_fault,
       {"constrained_delaunay", "delaunay"},
       {"gabriel"}},
  };
}

TEST(MeshMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  // What a sound constrained Delaunay mesh may lack.
  test::MutationTest<TriangleMesh> table(
      [](const TriangleMesh& mesh) { return audit::audit_mesh(mesh); },
      {"gabriel", "boundary_gabriel", "circumcentres_inside"});
  for (const auto& [name, mesh] : test::clean_meshes())
    table.add_clean(name, mesh, mesh.triangles.size() < 5000 ? 12 : 3);
  for (const auto& family :
       {syntax_faults(), topology_faults(), embedding_faults(), delaunay_faults()})
    table.run(family, 40);
}

}  // namespace
}  // namespace wellspaced
