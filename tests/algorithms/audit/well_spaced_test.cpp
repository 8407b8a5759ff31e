#include "wellspaced/algorithms/audit/well_spaced.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/audit_tet_meshes.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/spaced_mesh.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using audit::Vec;

template <class Mesh>
audit::Report spacing_of(const Mesh& mesh, const audit::SpacingAuditOptions& options = {}) {
  audit::Report report;
  audit::audit_spacing(mesh, options, report);
  return report;
}

double measured(const audit::Report& report, const std::string& name) {
  const auto* measure = report.measure(name);
  EXPECT_NE(measure, nullptr) << name;
  return measure == nullptr ? NAN : measure->value;
}

const audit::Witness& witness(const audit::Report& report, const std::string& name) {
  return *std::find_if(report.witnesses.begin(), report.witnesses.end(),
                       [&](const auto& w) { return w.name == name; });
}

void expect_bracket(const audit::Report& report, const std::string& name, double value) {
  EXPECT_LE(measured(report, name + "_lower"), value * (1 + 1e-9)) << name;
  EXPECT_GE(measured(report, name + "_upper"), value * (1 - 1e-9)) << name;
  EXPECT_LE(measured(report, name + "_upper"),
            1.05 * measured(report, name + "_lower") * (1 + 1e-9))
      << name;
}

bool everywhere(Index, Index, Index) { return true; }

// ---- Point sets whose figures are known

TEST(WellSpaced, ASquareGridHasTheFiguresOfItsCells) {
  const auto mesh = generate_grid({.nx = 9, .ny = 7}).value();
  const auto report = spacing_of(mesh);
  EXPECT_DOUBLE_EQ(measured(report, "beta"), 2);
  EXPECT_DOUBLE_EQ(measured(report, "boundary_distance"), 1);
  EXPECT_EQ(measured(report, "spacing_to_nn_min"), 1);
  expect_bracket(report, "gap_interior", std::sqrt(0.5));
  expect_bracket(report, "gap_segment", 0.5);
  EXPECT_TRUE(report.check("lipschitz")->pass());
  EXPECT_TRUE(report.check("gaps_certified")->pass());
  EXPECT_TRUE(report.check("well_spaced")->pass());
}

TEST(WellSpaced, ACubicGridHasTheFiguresOfItsCells) {
  const auto report = spacing_of(test::cubes(4, 3, 3, everywhere));
  EXPECT_DOUBLE_EQ(measured(report, "beta"), 2);
  EXPECT_DOUBLE_EQ(measured(report, "boundary_distance"), 1);
  expect_bracket(report, "gap_interior", std::sqrt(0.75));
  expect_bracket(report, "gap_face", std::sqrt(0.5));
  expect_bracket(report, "gap_segment", 0.5);
  EXPECT_TRUE(report.check("gaps_certified")->pass());
}

// Rows shifted by half a step: the hexagonal lattice, whose largest empty circles have radius
// 1/sqrt 3; erratum of Theorem 2.5.1.
TEST(WellSpaced, TheHexagonalLatticeHasGapsOfOneBySquareRootOfThree) {
  TriangleMesh mesh;
  const Index n = 8;
  const double height = std::sqrt(0.75);
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) mesh.points.push_back({i + 0.5 * j, height * j});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index v = j * (n + 1) + i;
      mesh.triangles.push_back({v, v + 1, v + n + 1});
      mesh.triangles.push_back({v + 1, v + n + 2, v + n + 1});
    }
  const auto report = spacing_of(mesh);
  expect_bracket(report, "gap_interior", 1 / std::sqrt(3));
  EXPECT_NEAR(measured(report, "boundary_distance"), height, 1e-12);
}

TEST(WellSpaced, FiguresDoNotDependOnTheScale) {
  const TriangleMesh mesh = test::random_mesh(60, 1);
  const auto as_given = spacing_of(mesh);
  for (const double factor : {0x1p300, 0x1p-300}) {
    TriangleMesh scaled = mesh;
    for (Point2& p : scaled.points) p = {p.x * factor, p.y * factor};
    const auto report = spacing_of(scaled);
    for (const char* name : {"beta", "gap_interior_lower", "gap_interior_upper",
                             "gap_segment_upper", "boundary_distance"})
      EXPECT_NEAR(measured(report, name), measured(as_given, name), 1e-9) << name;
  }
}

// ---- Against sampling

// f, d and gaps by looking at all points, and visibility by looking at all boundary edges.
struct Sampler {
  const TriangleMesh mesh;
  std::vector<double> f;

  double spacing_at(Point2 x) const {
    double least = INFINITY;
    for (Index v = 0; v < f.size(); ++v)
      least = std::min(least, f[v] + std::hypot(x.x - mesh.points[v].x, x.y - mesh.points[v].y));
    return least;
  }
  double distance_at(Point2 x) const {
    double least = INFINITY;
    for (const Point2 p : mesh.points) least = std::min(least, std::hypot(x.x - p.x, x.y - p.y));
    return least;
  }
  bool contains(Point2 x) const {
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
      const auto& p = mesh.points;
      return orient2d(p[t[0]], p[t[1]], x) >= 0 && orient2d(p[t[1]], p[t[2]], x) >= 0 &&
             orient2d(p[t[2]], p[t[0]], x) >= 0;
    });
  }
  bool sees(Point2 a, Point2 b) const {
    for (int i = 0; i <= 20; ++i)
      if (!contains({a.x + (b.x - a.x) * i / 20, a.y + (b.y - a.y) * i / 20})) return false;
    return true;
  }
  // The largest parameter of gaps around c in 48 directions, for balls as large as can be.
  double gap_around(Point2 c) const {
    const double r = distance_at(c);
    double largest = 0;
    for (int i = 0; i < 48; ++i) {
      const Point2 u = circle_point(i / 48.0), x{c.x + r * u.x, c.y + r * u.y};
      const double parameter = r / spacing_at(x);
      if (parameter > largest && sees(c, x)) largest = parameter;
    }
    return largest;
  }
};

double sampled_gap(const Sampler& sampler, int steps) {
  Point2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Point2 p : sampler.mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double largest = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const Point2 c{low.x + (high.x - low.x) * i / steps, low.y + (high.y - low.y) * j / steps};
      if (sampler.contains(c)) largest = std::max(largest, sampler.gap_around(c));
    }
  return largest;
}

TEST(WellSpaced, BracketsHoldWhatSamplingFinds) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    if (mesh.points.size() > 110) continue;
    for (const double stretch : {1.0, 0.3}) {
      std::vector<double> f = test::nearest_distances(mesh);
      for (double& value : f) value *= stretch;
      audit::SpacingAuditOptions options;
      options.spacing = f;
      const auto report = spacing_of(mesh, options);
      const double sampled = sampled_gap({mesh, f}, 40);
      EXPECT_LE(sampled, measured(report, "gap_interior_upper")) << name << " " << stretch;
      EXPECT_GE(measured(report, "gap_interior_lower"), 0.95 * sampled) << name << " " << stretch;
      EXPECT_LE(measured(report, "gap_interior_upper"),
                1.06 * measured(report, "gap_interior_lower"))
          << name << " " << stretch;
    }
  }
}

TEST(WellSpaced, TheWitnessOfAGapIsAGap) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    if (mesh.points.size() > 2000) continue;
    const Sampler sampler{mesh, test::nearest_distances(mesh)};
    const auto report = spacing_of(mesh);
    const auto& gap = witness(report, "gap_interior");
    const Point2 c{gap.centre[0], gap.centre[1]}, x{gap.at[0], gap.at[1]};
    const double radius = std::hypot(c.x - x.x, c.y - x.y);
    EXPECT_LE(radius, sampler.distance_at(c)) << name;
    EXPECT_TRUE(sampler.sees(c, x)) << name;
    EXPECT_NEAR(radius / sampler.spacing_at(x), measured(report, "gap_interior_lower"), 1e-9)
        << name;
  }
}

// A circle may reach across a slit, where the triangles do not see the nodes in it.
TEST(WellSpaced, SpheresAreEmptyWhereNoNodeLiesInThem) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    if (mesh.points.size() > 2000) continue;
    const auto& p = mesh.points;
    std::vector<Index> full;
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      if (std::any_of(p.begin(), p.end(),
                      [&](Point2 x) { return incircle(p[a], p[b], p[c], x) > 0; }))
        full.push_back(t);
    }
    EXPECT_EQ(spacing_of(mesh).check("spheres_empty")->ids, full) << name;
  }
}

TEST(WellSpaced, BetaIsTheWorstOfAllPairs) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    if (mesh.points.size() > 2000) continue;
    const auto f = test::nearest_distances(mesh);
    double worst = 0;
    for (Index i = 0; i < f.size(); ++i)
      for (Index j = 0; j < i; ++j) {
        const Point2 p = mesh.points[i], q = mesh.points[j];
        if (!(p == q)) worst = std::max(worst, (f[i] + f[j]) / std::hypot(p.x - q.x, p.y - q.y));
      }
    EXPECT_NEAR(measured(spacing_of(mesh), "beta"), worst, 1e-12) << name;
  }
}

// ---- In space, against sampling

TEST(WellSpaced, BracketsInSpaceHoldWhatSamplingFinds) {
  const TetMesh mesh = test::random_tet_mesh(60, 5);
  const auto report = spacing_of(mesh);
  EXPECT_TRUE(report.check("gaps_certified")->pass());
  const auto at = [&](Index v) { return audit::coordinates_of(mesh.points[v]); };
  std::vector<double> f(mesh.points.size(), INFINITY);
  for (Index v = 0; v < f.size(); ++v)
    for (Index w = 0; w < f.size(); ++w)
      if (v != w) f[v] = std::min(f[v], audit::distance_of(at(v), at(w)));
  Random random(1);
  double sampled = 0;
  for (int i = 0; i < 4000; ++i) {  // gaps inside one tet see all of it
    const auto& t = mesh.tets[random.below(mesh.tets.size())];
    Vec<3> c{};
    std::array<double, 4> w{};
    double sum = 0;
    for (double& value : w) sum += value = random.uniform();
    for (int k = 0; k < 4; ++k) c = audit::step(c, w[k] / sum, at(t[k]));
    double d = INFINITY;
    for (Index v = 0; v < f.size(); ++v) d = std::min(d, audit::distance_of(c, at(v)));
    for (const Index v : t) {
      const auto direction = audit::difference(at(v), c);
      const auto x = audit::step(c, d / audit::norm(direction), direction);
      double value = INFINITY;
      for (Index u = 0; u < f.size(); ++u)
        value = std::min(value, f[u] + audit::distance_of(x, at(u)));
      sampled = std::max(sampled, d / value);
    }
  }
  EXPECT_LE(sampled, measured(report, "gap_interior_upper"));
  EXPECT_LE(measured(report, "gap_interior_upper"), 1.06 * measured(report, "gap_interior_lower"));
  EXPECT_GE(measured(report, "gap_interior_lower"), 0.9 * sampled);
  EXPECT_LE(measured(report, "gap_face_upper"), 1.06 * measured(report, "gap_face_lower"));
}

// The faces of a hull of random points are single triangles, and few places of one matter.
TEST(WellSpaced, BracketsOnTrianglesOfAHullHoldWhatSamplingFinds) {
  const TetMesh mesh = test::random_tet_mesh(300, 7);
  const auto report = spacing_of(mesh);
  const auto at = [&](Index v) { return audit::coordinates_of(mesh.points[v]); };
  std::vector<double> f(mesh.points.size(), INFINITY);
  for (Index v = 0; v < f.size(); ++v)
    for (Index w = 0; w < f.size(); ++w)
      if (v != w) f[v] = std::min(f[v], audit::distance_of(at(v), at(w)));
  Random random(3);
  const auto place_on = [&](const std::array<Index, 3>& face) {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto a = at(face[0]);
    return audit::step(audit::step(a, u, audit::difference(at(face[1]), a)), v,
                       audit::difference(at(face[2]), a));
  };
  double sampled = 0;
  for (const TetMesh::Facet& facet : mesh.facets) {
    for (int i = 0; i < 200; ++i) {
      const auto c = place_on(facet.points), x = place_on(facet.points);
      double value = INFINITY, clear = INFINITY;
      for (const Index v : facet.points) clear = std::min(clear, audit::distance_of(c, at(v)));
      if (audit::distance_of(c, x) > clear) continue;
      for (Index v = 0; v < f.size(); ++v)
        value = std::min(value, f[v] + audit::distance_of(x, at(v)));
      sampled = std::max(sampled, audit::distance_of(c, x) / value);
    }
  }
  EXPECT_LE(sampled, measured(report, "gap_face_upper"));
  const auto& gap = witness(report, "gap_face");
  const Vec<3> c{gap.centre[0], gap.centre[1], gap.centre[2]}, x{gap.at[0], gap.at[1], gap.at[2]};
  const auto area = [](const Vec<3>& p, const Vec<3>& q, const Vec<3>& r) {
    return audit::norm(audit::cross_product(audit::difference(q, p), audit::difference(r, p)));
  };
  const auto has_gap = [&](const TetMesh::Facet& facet) {
    const auto p = at(facet.points[0]), q = at(facet.points[1]), r = at(facet.points[2]);
    const double clear =
        std::min({audit::distance_of(c, p), audit::distance_of(c, q), audit::distance_of(c, r)});
    const double most = area(p, q, r) * (1 + 1e-9);
    return area(c, p, q) + area(c, q, r) + area(c, r, p) <= most &&
           area(x, p, q) + area(x, q, r) + area(x, r, p) <= most &&
           audit::distance_of(c, x) <= clear;
  };
  EXPECT_EQ(std::count_if(mesh.facets.begin(), mesh.facets.end(), has_gap), 1);
  double value = INFINITY;
  for (Index v = 0; v < f.size(); ++v) value = std::min(value, f[v] + audit::distance_of(x, at(v)));
  EXPECT_NEAR(audit::distance_of(c, x) / value, measured(report, "gap_face_lower"), 1e-6);
  EXPECT_LE(measured(report, "gap_face_upper"), 1.051 * measured(report, "gap_face_lower"));
}

// ---- Mutations

using Spaced = test::SpacedMesh<TriangleMesh>;

std::vector<Index> inner_nodes(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> outer(mesh.points.size(), 0);
  for (const Segment& s : mesh.segments) outer[s.a] = outer[s.b] = 1;
  std::vector<Index> inner;
  for (Index v = 0; v < outer.size(); ++v)
    if (outer[v] == 0) inner.push_back(v);
  return inner;
}

// Moves the node of a pair that is as close as beta allows closer by 1e-12.
bool break_beta(Spaced& spaced, Random&) {
  const auto report = test::audit_claims(spaced);
  const auto& pair = witness(report, "beta");
  const Point2 p{pair.centre[0], pair.centre[1]}, q{pair.at[0], pair.at[1]};
  for (Point2& x : spaced.mesh.points)
    if (x == p) x = {x.x + (q.x - p.x) * 1e-12, x.y + (q.y - p.y) * 1e-12};
  return true;
}

// Takes the points out of larger and larger balls around an inner node until the gap there exceeds
// what is claimed, as seen from the nearest point left. They move onto a node of the boundary, with
// a value that says nothing.
bool empty_a_ball(Spaced& spaced, Random& random) {
  const auto inner = inner_nodes(spaced.mesh);
  if (inner.empty()) return false;
  const Sampler domain{spaced.mesh, {}};
  const auto points = spaced.mesh.points;
  const Point2 c = points[inner[random.below(inner.size())]];
  std::vector<std::pair<double, Index>> order;
  for (Index v = 0; v < points.size(); ++v)
    order.push_back({std::hypot(points[v].x - c.x, points[v].y - c.y), v});
  std::sort(order.begin(), order.end());
  const Index refuge = spaced.mesh.segments[0].a;
  for (const auto& [distance, v] : order) {
    if (distance / spaced.spacing[v] > spaced.gap * 1.1 && domain.sees(c, points[v])) break;
    if (std::find(inner.begin(), inner.end(), v) == inner.end()) return false;
    spaced.mesh.points[v] = points[refuge];
    spaced.spacing[v] = 1e9;
  }
  return true;
}

bool raise_a_value(Spaced& spaced, Random& random) {
  const auto v = random.below(spaced.spacing.size());
  double least = INFINITY;
  for (Index w = 0; w < spaced.spacing.size(); ++w) {
    const Point2 p = spaced.mesh.points[v], q = spaced.mesh.points[w];
    if (!(p == q)) least = std::min(least, spaced.spacing[w] + std::hypot(p.x - q.x, p.y - q.y));
    if (w != v && p == q) return false;
  }
  spaced.spacing[v] = least * (1 + 1e-12);
  return true;
}

// An inner node goes to within a hundredth of an edge of the boundary, inside the triangle there.
bool push_to_the_boundary(Spaced& spaced, Random& random) {
  const auto inner = inner_nodes(spaced.mesh);
  if (inner.empty()) return false;
  const Index v = inner[random.below(inner.size())];
  const Segment& s = spaced.mesh.segments[random.below(spaced.mesh.segments.size())];
  const auto& triangles = spaced.mesh.triangles;
  const auto t = std::find_if(triangles.begin(), triangles.end(), [&](const auto& corners) {
    return std::count(corners.begin(), corners.end(), s.a) +
               std::count(corners.begin(), corners.end(), s.b) ==
           2;
  });
  const Index apex = (*t)[0] + (*t)[1] + (*t)[2] - s.a - s.b;
  const auto& p = spaced.mesh.points;
  const Point2 middle{(p[s.a].x + p[s.b].x) / 2, (p[s.a].y + p[s.b].y) / 2};
  const Point2 inwards{p[apex].x - middle.x, p[apex].y - middle.y};
  const double edge = std::hypot(p[s.a].x - p[s.b].x, p[s.a].y - p[s.b].y);
  const double h = 0.01 * edge / std::hypot(inwards.x, inwards.y);
  spaced.mesh.points[v] = {middle.x + h * inwards.x, middle.y + h * inwards.y};
  return 0.01 * edge < spaced.boundary_distance * spaced.spacing[v];
}

bool lose_a_value(Spaced& spaced, Random& random) {
  spaced.spacing[random.below(spaced.spacing.size())] = random.below(2) == 0 ? 0.0 : NAN;
  return true;
}

// The other diagonal of a convex quadrilateral: each circle then holds the corner opposite.
bool swallow_a_node(Spaced& spaced, Random& random) {
  auto& triangles = spaced.mesh.triangles;
  const auto& p = spaced.mesh.points;
  const auto half_edges =
      audit::pair_half_edges(triangles, spaced.mesh.segments, static_cast<Index>(p.size()));
  for (int tries = 0; tries < 100; ++tries) {
    const auto h = static_cast<Index>(random.below(half_edges.twin.size()));
    const Index twin = half_edges.twin[h];
    if (twin == kNoIndex || half_edges.constrained[h] != 0) continue;
    const Index a = audit::origin(triangles, h), b = audit::target(triangles, h);
    const Index c = audit::apex(triangles, h), d = audit::apex(triangles, twin);
    if (incircle(p[a], p[b], p[c], p[d]) >= 0) continue;
    if (orient2d(p[c], p[d], p[b]) <= 0 || orient2d(p[d], p[c], p[a]) <= 0) continue;
    triangles[h / 3] = {d, c, a}, triangles[twin / 3] = {c, d, b};
    return true;
  }
  return false;
}

TEST(SpacingMutation, EveryPlantedFaultIsFoundByExactlyTheChecksThatShould) {
  test::MutationTest<Spaced> table(test::audit_claims<TriangleMesh>, {"spheres_empty"});
  for (const auto& [name, mesh] : test::clean_meshes())
    if (mesh.points.size() < 200) table.add_clean(name, test::claim(mesh), 5);
  table.run(test::spacing_faults<TriangleMesh>({break_beta, empty_a_ball, raise_a_value,
                                                push_to_the_boundary, swallow_a_node, lose_a_value},
                                               {"spheres_empty"}),
            10);
}

}  // namespace
}  // namespace wellspaced
