// Plants faults in how the nodes of tetrahedral meshes are spaced: each must be found by exactly
// the checks that should.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/audit_tet_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/spaced_mesh.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using Spaced = test::SpacedMesh<TetMesh>;
using audit::Vec;

Vec<3> place(const Spaced& spaced, Index v) { return audit::coordinates_of(spaced.mesh.points[v]); }

std::vector<Index> inner_nodes(const TetMesh& mesh) {
  std::vector<std::uint8_t> outer(mesh.points.size(), 0);
  for (const auto& facet : mesh.facets)
    for (const Index v : facet.points) outer[v] = 1;
  std::vector<Index> inner;
  for (Index v = 0; v < outer.size(); ++v)
    if (outer[v] == 0) inner.push_back(v);
  return inner;
}

// Moves a node of a pair that is as close as beta allows closer by 1e-12.
bool break_beta(Spaced& spaced, Random&) {
  const auto report = test::audit_claims(spaced);
  const auto pair = std::find_if(report.witnesses.begin(), report.witnesses.end(),
                                 [](const auto& w) { return w.name == "beta"; });
  const Vec<3> p{pair->centre[0], pair->centre[1], pair->centre[2]};
  const Vec<3> q{pair->at[0], pair->at[1], pair->at[2]};
  const Vec<3> moved = audit::step(p, 1e-12, audit::difference(q, p));
  for (Point3& x : spaced.mesh.points)
    if (audit::coordinates_of(x) == p) x = audit::point_at(moved);
  return true;
}

// Takes the points out of larger and larger balls around an inner node until the gap there, as seen
// from the nearest point left, exceeds what is claimed. The domain is convex. They move onto a node
// of the boundary, with a value that says nothing.
bool empty_a_ball(Spaced& spaced, Random& random) {
  const auto inner = inner_nodes(spaced.mesh);
  if (inner.empty()) return false;
  const Vec<3> c = place(spaced, inner[random.below(inner.size())]);
  std::vector<std::pair<double, Index>> order;
  for (Index v = 0; v < spaced.spacing.size(); ++v)
    order.push_back({audit::distance_of(place(spaced, v), c), v});
  std::sort(order.begin(), order.end());
  const Point3 refuge = spaced.mesh.points[spaced.mesh.facets[0].points[0]];
  for (const auto& [distance, v] : order) {
    if (distance / spaced.spacing[v] > spaced.gap * 1.1) break;
    if (std::find(inner.begin(), inner.end(), v) == inner.end()) return false;
    spaced.mesh.points[v] = refuge;
    spaced.spacing[v] = 1e9;
  }
  return true;
}

bool raise_a_value(Spaced& spaced, Random& random) {
  const auto v = static_cast<Index>(random.below(spaced.spacing.size()));
  double least = INFINITY;
  for (Index w = 0; w < spaced.spacing.size(); ++w)
    if (w != v)
      least = std::min(least,
                       spaced.spacing[w] + audit::distance_of(place(spaced, v), place(spaced, w)));
  spaced.spacing[v] = least * (1 + 1e-12);
  return true;
}

// An inner node goes to within a hundredth of an edge of the middle of a boundary face.
bool push_to_the_boundary(Spaced& spaced, Random& random) {
  const auto inner = inner_nodes(spaced.mesh);
  if (inner.empty()) return false;
  const Index v = inner[random.below(inner.size())];
  const auto& facet = spaced.mesh.facets[random.below(spaced.mesh.facets.size())].points;
  Vec<3> middle{};
  for (const Index w : facet) middle = audit::step(middle, 1.0 / 3, place(spaced, w));
  const double h = 0.01 * audit::distance_of(place(spaced, facet[0]), place(spaced, facet[1]));
  const Vec<3> inwards = audit::difference(place(spaced, v), middle);
  spaced.mesh.points[v] = audit::point_at(audit::step(middle, h / audit::norm(inwards), inwards));
  return h < spaced.boundary_distance * spaced.spacing[v];
}

int orientation(const TetMesh& mesh, const std::array<Index, 4>& t) {
  return -orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
}

// Two tets on a face become three around the line between their apexes, if that crosses the face:
// some of their spheres then hold a corner of the face.
bool swallow_a_node(Spaced& spaced, Random& random) {
  TetMesh& mesh = spaced.mesh;
  const auto faces = audit::pair_tet_faces(mesh.tets, {}, static_cast<Index>(mesh.points.size()));
  const auto& p = mesh.points;
  for (int tries = 0; tries < 1000; ++tries) {
    const auto f = static_cast<Index>(random.below(faces.twin.size()));
    const Index twin = faces.twin[f];
    if (twin == kNoIndex) continue;
    const auto [a, b, c] = audit::face_nodes(mesh.tets, f);
    const Index d = audit::face_apex(mesh.tets, f), e = audit::face_apex(mesh.tets, twin);
    if (insphere(p[a], p[b], p[c], p[d], p[e]) >= 0) continue;
    std::array<std::array<Index, 4>, 3> three = {{{a, b, d, e}, {b, c, d, e}, {c, a, d, e}}};
    const int sign = orientation(mesh, three[0]);
    if (sign == 0 || orientation(mesh, three[1]) != sign || orientation(mesh, three[2]) != sign)
      continue;
    if (sign < 0)
      for (auto& tet : three) std::swap(tet[0], tet[1]);
    mesh.tets[f / 4] = three[0], mesh.tets[twin / 4] = three[1];
    mesh.tets.push_back(three[2]);
    return true;
  }
  return false;
}

bool lose_a_value(Spaced& spaced, Random& random) {
  spaced.spacing[random.below(spaced.spacing.size())] = random.below(2) == 0 ? 0.0 : NAN;
  return true;
}

TEST(TetSpacingMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  test::MutationTest<Spaced> table(test::audit_claims<TetMesh>, {});
  const auto all = [](Index, Index, Index) { return true; };
  table.add_clean("box", test::claim(test::cubes(4, 3, 3, all)), 3);
  table.add_clean("random", test::claim(test::random_tet_mesh(80, 1)), 3);
  table.add_clean("few", test::claim(test::random_tet_mesh(30, 4)), 3);
  table.run(test::spacing_faults<TetMesh>({break_beta, empty_a_ball, raise_a_value,
                                           push_to_the_boundary, swallow_a_node, lose_a_value},
                                          {}),
            3);
}

TEST(TetSpacing, SpheresAreEmptyWhereNoNodeLiesInThem) {
  for (const auto& [name, mesh] : test::clean_tet_meshes()) {
    const auto& p = mesh.points;
    std::vector<Index> full;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
      const auto& [a, b, c, d] = mesh.tets[t];
      const int inside = orient3d(p[a], p[b], p[c], p[d]);  // the sign of insphere there
      if (std::any_of(p.begin(), p.end(), [&](const Point3& x) {
            return insphere(p[a], p[b], p[c], p[d], x) * inside > 0;
          }))
        full.push_back(t);
    }
    audit::Report report;
    audit::audit_spacing(mesh, {}, report);
    EXPECT_EQ(report.check("spheres_empty")->ids, full) << name;
  }
}

}  // namespace
}  // namespace wellspaced
