// Plants faults in clean tetrahedral meshes: each must be found by exactly the checks that should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tests/support/audit_tet_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::any;
using test::Names;
using test::operator+;
using Fault = test::Fault<TetMesh>;

const Names kSpheres = {"constrained_delaunay", "delaunay",  "gabriel",
                        "boundary_gabriel",     "no_sliver", "circumcentres_inside"};
const Names kRims = {"boundary_has_facets",     "manifold_boundary_edges",
                     "manifold_boundary_nodes", "gabriel",
                     "boundary_gabriel",        "circumcentres_inside"};

std::optional<Index> any_inner_face(const TetMesh& mesh, Random& random) {
  const auto faces = audit::pair_tet_faces(mesh.tets, {}, static_cast<Index>(mesh.points.size()));
  for (int tries = 0; tries < 1000; ++tries) {
    const Index f = any(faces.twin.size(), random);
    if (faces.twin[f] != kNoIndex) return f;
  }
  return std::nullopt;
}

std::optional<Index> any_inner_node(const TetMesh& mesh, Random& random) {
  std::vector<std::uint8_t> outer(mesh.points.size(), 0);
  for (const auto& f : mesh.facets)
    for (const Index v : f.points) outer[v] = 1;
  std::vector<Index> inner;
  for (Index v = 0; v < outer.size(); ++v)
    if (outer[v] == 0) inner.push_back(v);
  if (inner.empty()) return std::nullopt;
  return inner[random.below(inner.size())];
}

int orientation(const TetMesh& mesh, const std::array<Index, 4>& t) {
  return -orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
}

Index new_node(TetMesh& mesh, Point3 p) {
  mesh.points.push_back(p);
  return static_cast<Index>(mesh.points.size() - 1);
}

Point3 mean(const TetMesh& mesh, const std::array<Index, 4>& t) {
  Point3 sum;
  for (const Index v : t) {
    sum.x += mesh.points[v].x / 4;
    sum.y += mesh.points[v].y / 4;
    sum.z += mesh.points[v].z / 4;
  }
  return sum;
}

// Moves an inner node to the far face of one of its tets and, where wanted < 0, one unit in the
// last place beyond.
bool move_across_a_face(TetMesh& mesh, Random& random, int wanted) {
  const auto v = any_inner_node(mesh, random);
  if (!v) return false;
  std::vector<Index> star;
  for (Index t = 0; t < mesh.tets.size(); ++t)
    if (std::count(mesh.tets[t].begin(), mesh.tets[t].end(), *v) > 0) star.push_back(t);
  const auto& tet = mesh.tets[star[random.below(star.size())]];
  std::vector<Point3> face;
  for (const Index w : tet)
    if (w != *v) face.push_back(mesh.points[w]);
  const Point3 inside = mesh.points[*v];
  Point3& p = mesh.points[*v];
  p = {(face[0].x + face[1].x + 2 * face[2].x) / 4, (face[0].y + face[1].y + 2 * face[2].y) / 4,
       (face[0].z + face[1].z + 2 * face[2].z) / 4};
  double* const moving[] = {&p.x, &p.y, &p.z};
  const double from[] = {inside.x, inside.y, inside.z};
  for (int axis = 0; axis < 3; ++axis) {
    const double towards = from[axis] > *moving[axis] ? 1e9 : -1e9;
    for (int step = 0; step < 4 && orientation(mesh, tet) < wanted; ++step)
      *moving[axis] = std::nextafter(*moving[axis], towards);
    for (int step = 0; step < 4 && orientation(mesh, tet) > wanted; ++step)
      *moving[axis] = std::nextafter(*moving[axis], -towards);
  }
  return orientation(mesh, tet) == wanted;
}

// Two tets on a face become three around the line between their apexes, if that crosses the face.
bool flip_a_face(TetMesh& mesh, Random& random) {
  for (int tries = 0; tries < 100; ++tries) {
    const auto f = any_inner_face(mesh, random);
    if (!f) return false;
    const auto faces = audit::pair_tet_faces(mesh.tets, {}, static_cast<Index>(mesh.points.size()));
    const Index g = faces.twin[*f];
    const auto [a, b, c] = audit::face_nodes(mesh.tets, *f);
    const Index p = audit::face_apex(mesh.tets, *f), q = audit::face_apex(mesh.tets, g);
    const std::array<std::array<Index, 4>, 3> three = {{{a, b, p, q}, {b, c, p, q}, {c, a, p, q}}};
    const int sign = orientation(mesh, three[0]);
    if (sign == 0 || orientation(mesh, three[1]) != sign || orientation(mesh, three[2]) != sign)
      continue;
    const auto& x = mesh.points;
    if (insphere(x[a], x[b], x[c], x[p], x[q]) >= 0) continue;
    const Index t = *f / 4, u = g / 4;
    mesh.tets[t] = three[0], mesh.tets[u] = three[1];
    mesh.tets.push_back(three[2]);
    if (sign < 0)
      for (auto* tet : {&mesh.tets[t], &mesh.tets[u], &mesh.tets.back()})
        std::swap((*tet)[0], (*tet)[1]);
    return true;
  }
  return false;
}

// Cuts one of the tets on an inner edge in two at the middle of the edge; the others keep it whole.
bool split_one_tet(TetMesh& mesh, Random& random) {
  auto& tet = mesh.tets[any(mesh.tets.size(), random)];
  const Point3 a = mesh.points[tet[0]], b = mesh.points[tet[1]];
  const Index m = new_node(mesh, {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
  auto half = tet;
  half[0] = m;
  tet[1] = m;
  mesh.tets.push_back(half);
  return true;
}

std::vector<Fault> syntax_faults() {
  return {
      {"index out of range",
       [](TetMesh& m, Random& r) {
         m.tets[any(m.tets.size(), r)][r.below(4)] = static_cast<Index>(m.points.size());
         return true;
       },
       {"valid_indices"},
       {}},
      {"tet names a node twice",
       [](TetMesh& m, Random& r) {
         auto& t = m.tets[any(m.tets.size(), r)];
         t[0] = t[3];
         return true;
       },
       {"distinct_corners"},
       {}},
      {"coordinate not a number",
       [](TetMesh& m, Random& r) {
         m.points[any(m.points.size(), r)].z = std::numeric_limits<double>::quiet_NaN();
         return true;
       },
       {"finite_coordinates"},
       {}},
      {"facet to nowhere",
       [](TetMesh& m, Random& r) {
         m.facets[any(m.facets.size(), r)].points[1] = kNoIndex;
         return true;
       },
       {"valid_facets"},
       {}},
      {"marker missing",
       [](TetMesh& m, Random&) {
         m.point_markers.assign(m.points.size() + 1, 0);
         return true;
       },
       {"valid_node_data"},
       {}},
  };
}

std::vector<Fault> topology_faults() {
  return {
      {"doubled tet",
       [](TetMesh& m, Random& r) {
         auto t = m.tets[any(m.tets.size(), r)];
         std::rotate(t.begin(), t.begin() + 1, t.end());
         std::swap(t[0], t[1]);
         m.tets.push_back(t);
         return true;
       },
       {"no_duplicate_tet", "no_overlap"},
       kRims + Names{"manifold_faces", "consistent_orientation"}},
      {"third tet on a face",
       [](TetMesh& m, Random& r) {
         const auto f = any_inner_face(m, r);
         if (!f) return false;
         auto tet = m.tets[*f / 4];
         tet[*f % 4] = new_node(m, mean(m, tet));
         m.tets.push_back(tet);
         return true;
       },
       {"manifold_faces", "no_overlap"},
       kRims + kSpheres},
      {"missing tet",
       [](TetMesh& m, Random& r) {
         const auto f = any_inner_face(m, r);
         if (!f) return false;
         m.tets.erase(m.tets.begin() + *f / 4);
         return true;
       },
       {"boundary_has_facets"},
       kRims + Names{"facets_are_faces", "no_unused_node"}},
      {"tet cut loose at a corner",
       [](TetMesh& m, Random& r) {
         const auto f = any_inner_face(m, r);
         if (!f) return false;
         Index& corner = m.tets[*f / 4][(*f + 1) % 4];
         corner = new_node(m, m.points[corner]);
         return true;
       },
       {"boundary_has_facets"},
       kRims + Names{"facets_are_faces", "no_unused_node"}},
  };
}

std::vector<Fault> node_and_facet_faults() {
  return {
      {"unused node",
       [](TetMesh& m, Random& r) {
         new_node(m, {r.uniform(), r.uniform(), r.uniform()});
         return true;
       },
       {"no_unused_node"},
       {}},
      {"doubled facet with another marker",
       [](TetMesh& m, Random& r) {
         auto facet = m.facets[any(m.facets.size(), r)];
         facet.marker += 1;
         std::swap(facet.points[0], facet.points[2]);
         m.facets.push_back(facet);
         return true;
       },
       {"no_duplicate_facet", "one_marker_per_facet"},
       {}},
      {"lost facet",
       [](TetMesh& m, Random& r) {
         m.facets.erase(m.facets.begin() + any(m.facets.size(), r));
         return true;
       },
       {"boundary_has_facets"},
       {}},
      {"segment that is no edge",
       [](TetMesh& m, Random&) {
         const Index a = new_node(m, {50, 50, 50});
         m.segments.push_back({0, a, 1});
         return true;
       },
       {"segments_are_edges", "no_unused_node"},
       {}},
      {"components glued at a node",
       [](TetMesh& m, Random&) {
         const Point3 p = m.points[0];
         if (p != Point3{0, 0, 0}) return false;
         const Index a = new_node(m, {p.x - 64, p.y - 64, p.z - 64});
         const Index b = new_node(m, {p.x - 64, p.y - 32, p.z - 64});
         const Index c = new_node(m, {p.x - 32, p.y - 64, p.z - 64});
         m.tets.push_back({0, a, b, c});
         if (orientation(m, m.tets.back()) < 0) std::swap(m.tets.back()[1], m.tets.back()[2]);
         return true;
       },
       {"manifold_boundary_nodes"},
       kRims + kSpheres},
  };
}

std::vector<Fault> embedding_faults() {
  return {
      {"flipped tet",
       [](TetMesh& m, Random& r) {
         const auto f = any_inner_face(m, r);
         if (!f) return false;
         std::swap(m.tets[*f / 4][0], m.tets[*f / 4][1]);
         return true;
       },
       {"no_inverted", "consistent_orientation"},
       kRims},
      {"overlapping sheet",
       [](TetMesh& m, Random& r) {
         const auto tet = m.tets[any(m.tets.size(), r)];
         const Point3 centre = mean(m, tet);
         std::array<Index, 4> copy;
         for (int i = 0; i < 4; ++i) {
           const Point3 p = m.points[tet[i]];
           copy[i] =
               new_node(m, {(p.x + centre.x) / 2, (p.y + centre.y) / 2, (p.z + centre.z) / 2});
         }
         m.tets.push_back(copy);
         return true;
       },
       {"no_overlap"},
       kRims + kSpheres},
      {"node moved across a face by a unit in the last place",
       [](TetMesh& m, Random& r) { return move_across_a_face(m, r, -1); },
       {"no_inverted", "no_overlap"},
       kSpheres + Names{"no_improper_contact"}},
      {"node moved onto a face",
       [](TetMesh& m, Random& r) { return move_across_a_face(m, r, 0); },
       {"no_flat"},
       kSpheres + Names{"no_improper_contact", "no_overlap", "no_inverted"}},
      {"hanging node",
       split_one_tet,
       {"no_improper_contact"},
       kRims + kSpheres + Names{"facets_are_faces"}},
      {"mesh turned inside out",
       [](TetMesh& m, Random&) {
         for (auto& t : m.tets) std::swap(t[2], t[3]);
         return true;
       },
       {"no_inverted"},
       {}},
  };
}

std::vector<Fault> delaunay_faults() {
  return {
      {"face flipped the wrong way", flip_a_face, {"constrained_delaunay", "delaunay"}, kSpheres},
  };
}

TEST(TetMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  test::MutationTest<TetMesh> table(
      [](const TetMesh& mesh) { return audit::audit_tet_mesh(mesh); },
      {"gabriel", "boundary_gabriel", "circumcentres_inside", "no_sliver"});
  for (const auto& [name, mesh] : test::clean_tet_meshes()) table.add_clean(name, mesh, 4);
  for (const auto& family : {syntax_faults(), topology_faults(), node_and_facet_faults(),
                             embedding_faults(), delaunay_faults()})
    table.run(family, 4);
}

}  // namespace
}  // namespace wellspaced
