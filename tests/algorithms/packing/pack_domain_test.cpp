#include "wellspaced/algorithms/packing/pack_domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/data_files.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/point_families.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/plane/circumcircle.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using test::polygons;
using test::rectangle;
using test::stepped_plate;
using test::unit_square;

PackedMesh packed(const Pslg& domain, const PackingOptions& options = {}) {
  auto result = pack_domain(domain, options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  return result.ok() ? std::move(*result) : PackedMesh{};
}

void expect_valid(const PackedMesh& result, const Pslg& domain) {
  const audit::Report report = audit::audit_mesh(result.mesh, {.domain = &domain});
  for (const auto& check : report.checks)
    if (check.required || check.name == "constrained_delaunay")
      EXPECT_EQ(check.violations, 0u) << check.name;
}

double smallest_angle(const TriangleMesh& mesh, const std::array<Index, 3>& t) {
  const Point2 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
  return arccotangent_deg(
      std::max({corner_cotangent(a, b, c), corner_cotangent(b, c, a), corner_cotangent(c, a, b)}));
}

double smallest_angle(const TriangleMesh& mesh) {
  double least = 180;
  for (const auto& t : mesh.triangles) least = std::min(least, smallest_angle(mesh, t));
  return least;
}

// Away from corners below 60 degrees: triangles without such a corner.
double smallest_angle_away(const PackedMesh& result) {
  std::set<Index> apices;
  for (const Corner& corner : result.sharp_corners) apices.insert(corner.apex);
  double least = 180;
  for (const auto& t : result.mesh.triangles)
    if (std::ranges::none_of(t, [&](Index v) { return apices.contains(result.domain_point[v]); }))
      least = std::min(least, smallest_angle(result.mesh, t));
  return least;
}

bool in_diametral_circle(const TriangleMesh& mesh, const Segment& s, Point2 p) {
  const Point2 a = mesh.points[s.a], b = mesh.points[s.b];
  return (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) < 0;
}

// Whether a ball of this radius fits around p: by looking at everything.
bool fits(const PackedMesh& result, Point2 p, double radius) {
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v)
    if (distance(p, result.mesh.points[v]) < radius + result.radius[v]) return false;
  return std::ranges::none_of(result.mesh.segments, [&](const Segment& s) {
    return in_diametral_circle(result.mesh, s, p);
  });
}

PackingOptions balls_only(double beta) {
  PackingOptions options;
  options.beta = beta;
  options.smallest_angle_deg = 0;
  return options;
}

// ---- The theory ----------------------------------------------------------------------------

// Definition 2.2.3 and Theorem 4.3.4: the dimensions are packed independently, all balls disjoint.
TEST(PackDomain, PacksDisjointBalls) {
  for (const double beta : {6.0, 9.0, 15.0}) {
    const PackedMesh result = packed(stepped_plate(), balls_only(beta));
    const auto& points = result.mesh.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_LE(result.radius[i] + result.radius[j], distance(points[i], points[j]));
  }
}

// Figure 4.3, B, and the remark on maximality: no circumcentre can be added.
TEST(PackDomain, IsDelaunayMaximalOutsideProtectiveCircles) {
  const PackedMesh result = packed(stepped_plate(), balls_only(8));
  for (const Segment& s : result.mesh.segments)
    for (const Point2 p : result.mesh.points) ASSERT_FALSE(in_diametral_circle(result.mesh, s, p));
  const auto lfs = LocalFeatureSize::build(stepped_plate());
  ASSERT_TRUE(lfs.ok());
  for (const auto& t : result.mesh.triangles) {
    const Point2 centre =
        circumcircle(result.mesh.points[t[0]], result.mesh.points[t[1]], result.mesh.points[t[2]])
            .centre;
    ASSERT_FALSE(fits(result, centre, lfs->at(centre) / 8));
  }
}

// Lemmas 4.3.8 and 4.3.10: in the plane no triangle is worse than this.
TEST(PackDomain, KeepsTheRadiusEdgeBoundOfTheThesis) {
  for (const double beta : {8.0, 12.0, 30.0}) {
    const double root = std::sqrt(2.0), bound = root * beta / (beta - 3 - 2 * root);
    for (const Pslg& domain : {unit_square(), stepped_plate()}) {
      const PackedMesh result = packed(domain, balls_only(beta));
      const double angle = arccotangent_deg(std::sqrt(4 * bound * bound - 1));
      EXPECT_GE(smallest_angle(result.mesh), angle) << beta;
      expect_valid(result, domain);
    }
  }
}

// Section 1.1: uniform well-spaced points have angles of 30 degrees and more.
TEST(PackDomain, HasAngles30AwayFromTheBoundaryWhereTheSizeIsConstant) {
  PackingOptions options = balls_only(2);
  options.size = [](Point2) { return 0.02; };
  const PackedMesh result = packed(unit_square(), options);
  EXPECT_GT(result.mesh.points.size(), 1500u);
  std::vector<char> on_boundary(result.mesh.points.size());
  for (const Segment& s : result.mesh.segments) on_boundary[s.a] = on_boundary[s.b] = 1;
  for (const auto& t : result.mesh.triangles)
    if (!on_boundary[t[0]] && !on_boundary[t[1]] && !on_boundary[t[2]])
      EXPECT_GE(smallest_angle(result.mesh, t), 30 - 1e-9);
  for (std::size_t i = 0; i < result.mesh.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE(distance(result.mesh.points[i], result.mesh.points[j]), 0.02);
}

TEST(PackDomain, IsFullAtFullMaximality) {
  const auto size = [](Point2 p) { return 0.02 + 0.3 * std::fabs(p.x - 0.3); };
  PackingOptions options = balls_only(2);
  options.size = size;
  options.maximality = Maximality::kFull;
  const PackedMesh full = packed(unit_square(), options);
  options.maximality = Maximality::kDelaunay;
  EXPECT_GT(full.mesh.points.size(), packed(unit_square(), options).mesh.points.size());
  for (const Point2 p : test::uniform_points(4000, 3)) {
    const double side = std::min({p.x, p.y, 1 - p.x, 1 - p.y});
    EXPECT_FALSE(fits(full, p, std::min(size(p) / 2, 0.5) + 1e-4)) << side;
  }
}

void expect_spaced(const PackedMesh& result, double beta) {
  const std::vector<double> f = packed_spacing(result, beta);
  const auto& points = result.mesh.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double d = distance(points[i], points[j]);
      ASSERT_LE(std::fabs(f[i] - f[j]), d * (1 + 1e-14)) << "1-Lipschitz";
      ASSERT_LE(f[i] + f[j], beta * d * (1 + 1e-14)) << "beta-spaced";
    }
}

TEST(PackDomain, HasASpacingFunctionThatSpacesItsNodes) {
  for (const double beta : {2.0, 6.0}) {
    PackingOptions options;
    options.beta = beta;
    expect_spaced(packed(stepped_plate(), options), beta);
  }
}

// ---- Domains -------------------------------------------------------------------------------

TEST(PackDomain, MeshesRealDomains) {
  for (const char* name : {"triangle_A", "mesh2d_lake", "mesh2d_airfoil", "cdt_guitar"}) {
    const auto domain = test::data_domain(std::string("pslg/") + name);
    if (!domain) GTEST_SKIP() << "no pslg/" << name;
    PackingOptions options;
    options.sharp_corners = SharpCorners::kMesh;
    if (!domain->holes.empty()) options.holes = HoleRule::kSeeds;
    const PackedMesh result = packed(*domain, options);
    expect_valid(result, *domain);
    expect_spaced(result, options.beta);
    EXPECT_TRUE(result.is_complete) << name;
    EXPECT_GE(smallest_angle_away(result), 25) << name;
    EXPECT_LE(result.without_guarantee.size(), 2 * result.sharp_corners.size()) << name;
    EXPECT_LT(result.mesh.points.size(), 4 * domain->points.size()) << name;
  }
}

TEST(PackDomain, MeshesGeneratedWingSections) {
  for (const Index nodes : {1000u, 5000u}) {
    const auto domain = generate_graded_boundary(GradedDomain::kAirfoil, {.nodes = nodes});
    ASSERT_TRUE(domain.ok());
    PackingOptions options;
    options.holes = HoleRule::kSeeds;
    const PackedMesh result = packed(*domain, options);
    expect_valid(result, *domain);
    EXPECT_TRUE(result.without_guarantee.empty());
    EXPECT_GE(smallest_angle(result.mesh), 25);
  }
}

TEST(PackDomain, MeshesSharpCornersAsWellAsItGoes) {
  for (const double degrees : {45.0, 29.0, 10.0, 2.0}) {
    const Point2 end = circle_point(degrees / 360);
    const Pslg domain = polygons({{{0, 0}, {1, 0}, {1, 1}, {0.5 * end.x, 0.5 * end.y}}});
    EXPECT_FALSE(pack_domain(domain).ok()) << degrees;
    PackingOptions options;
    options.sharp_corners = SharpCorners::kMesh;
    options.max_points = 20'000;
    const PackedMesh result = packed(domain, options);
    expect_valid(result, domain);
    EXPECT_TRUE(result.is_complete) << degrees;
    EXPECT_GE(smallest_angle_away(result), 25) << degrees;
  }
}

TEST(PackDomain, KeepsMarkersHolesAndRegions) {
  Pslg domain = polygons({rectangle({0, 0}, {4, 2}), rectangle({1, 0.5}, {1.5, 1})});
  domain.segments.push_back({0, 0, 0});
  domain.segments.back() = {8, 9, 7};
  domain.points.push_back({2, 0});
  domain.points.push_back({2, 2});
  domain.regions = {{{0.1, 0.1}, 5, -1}, {{3, 1}, 6, 0.001}};
  domain.point_markers = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  domain.holes = {{1.2, 0.7}};
  PackingOptions options;
  options.holes = HoleRule::kSeeds;
  const PackedMesh result = packed(domain, options);
  expect_valid(result, domain);
  std::set<int> markers;
  for (const Segment& s : result.mesh.segments) {
    markers.insert(s.marker);
    const Point2 a = result.mesh.points[s.a], b = result.mesh.points[s.b];
    EXPECT_EQ(s.marker == 7, a.x == 2 && b.x == 2);
  }
  EXPECT_EQ(markers, (std::set<int>{1, 2, 7}));
  ASSERT_EQ(result.attributes.size(), result.mesh.triangles.size());
  for (std::size_t t = 0; t < result.attributes.size(); ++t) {
    const auto& [i, j, k] = result.mesh.triangles[t];
    const Point2 a = result.mesh.points[i], b = result.mesh.points[j], c = result.mesh.points[k];
    const bool right = a.x + b.x + c.x > 6;
    EXPECT_EQ(result.attributes[t], right ? 6 : 5);
    if (right) EXPECT_LE((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0.002);
  }
  for (Index v = 0; v < 10; ++v) {
    EXPECT_EQ(result.mesh.points[v], domain.points[v]);
    EXPECT_EQ(result.domain_point[v], v);
    EXPECT_EQ(result.mesh.point_markers[v], domain.point_markers[v]);
  }
}

TEST(PackDomain, MeshesTheHullOfPointsWithoutSegments) {
  Pslg domain;
  domain.points = test::uniform_points(50, 8);
  PackingOptions options;
  options.holes = HoleRule::kNone;
  options.sharp_corners = SharpCorners::kMesh;
  const PackedMesh result = packed(domain, options);
  expect_valid(result, domain);
  EXPECT_GE(smallest_angle_away(result), 25);
}

TEST(PackDomain, ScalesWithTheDomain) {
  const PackedMesh result = packed(stepped_plate());
  for (const int exponent : {-900, -40, 900}) {
    Pslg domain = stepped_plate();
    domain.points = test::scaled(domain.points, exponent);
    const PackedMesh other = packed(domain);
    EXPECT_EQ(other.mesh.triangles, result.mesh.triangles) << exponent;
  }
}

TEST(PackDomain, IsTheSameEveryTime) {
  const PackedMesh one = packed(stepped_plate()), two = packed(stepped_plate());
  EXPECT_EQ(one.mesh.points, two.mesh.points);
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
}

// ---- Limits --------------------------------------------------------------------------------

TEST(PackDomain, StopsAtTheLimitWithAValidMesh) {
  const Pslg domain = stepped_plate();
  for (const std::size_t most : {0u, 20u, 100u, 400u, 1000u}) {
    PackingOptions options;
    options.beta = 20;
    options.max_points = most;
    const PackedMesh result = packed(domain, options);
    EXPECT_FALSE(result.is_complete);
    EXPECT_LE(result.mesh.points.size(), std::max(most, domain.points.size()));
    expect_valid(result, domain);
  }
}

TEST(PackDomain, StopsWhenToldWithAValidMesh) {
  PackingOptions options;
  options.beta = 40;
  int calls = 0;  // while balls are packed: before that nothing is valid yet
  options.progress = [&](std::string_view phase, std::uint64_t, std::uint64_t) {
    return phase != "pack" || ++calls < 4;
  };
  const PackedMesh result = packed(stepped_plate(), options);
  EXPECT_FALSE(result.is_complete);
  EXPECT_TRUE(result.was_cancelled);
  expect_valid(result, stepped_plate());
}

// ---- No domain -----------------------------------------------------------------------------

void expect_refused(const Pslg& domain, const std::string& words, std::vector<Index> ids) {
  const auto result = pack_domain(domain);
  ASSERT_FALSE(result.ok()) << words;
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_NE(result.error().message.find(words), std::string::npos) << result.error().message;
  EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
  EXPECT_EQ(result.error().ids, ids);
}

TEST(PackDomain, ReportsWhatIsNoDomainOnce) {
  expect_refused(polygons({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}), "cross", {0, 2});
  Pslg open = unit_square();
  open.segments.pop_back();
  expect_refused(open, "2 loose ends, the first at point 0", {0, 3});
  expect_refused(polygons({{{0, 0}, {1, 1}, {3, 3}}}), "no area", {});
  Pslg none;
  expect_refused(none, "no area", {});
  const Point2 end = circle_point(5.0 / 360);
  expect_refused(polygons({{{0, 0}, {3, 0}, {3, 1}, end}}), "5.00", {0});
}

// Fuzz: neighbouring doubles as a polygon; the error blamed the options.
TEST(PackDomain, RefusesFeaturesThatDoublesCannotTellApart) {
  constexpr double kStep = 0x1p-52;
  Pslg domain = polygons({{{1, 1 + kStep},
                           {1 - kStep / 2, 1},
                           {1 + 2 * kStep, 1 - kStep},
                           {1 - kStep / 2, 1 - kStep / 2},
                           {1 - kStep, 1 + kStep}}});
  PackingOptions options;
  options.sharp_corners = SharpCorners::kMesh;
  options.crossings = CrossingRule::kSplit;
  const auto result = pack_domain(domain, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry) << result.error().message;
  EXPECT_EQ(result.error().ids.size(), 2u);
}

// Fuzz: nodes were rounded onto each other on the way back from a larger scale.
TEST(PackDomain, MeshesSubnormalDomainsOrRefusesThem) {
  constexpr double kLeast = 0x1p-1074;
  PackingOptions options;
  options.beta = 6;
  for (const double unit : {kLeast, 2 * kLeast, 3 * kLeast, 0x1p-1050, 0x1p-1022}) {
    const Pslg domain = polygons({rectangle({0, 0}, {3 * unit, 2 * unit})});
    const auto result = pack_domain(domain, options);
    if (unit >= 0x1p-1050) ASSERT_TRUE(result.ok()) << unit;
    if (!result.ok()) {
      EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
      continue;
    }
    for (const auto& [a, b, c] : result->mesh.triangles)
      EXPECT_GT(orient2d(result->mesh.points[a], result->mesh.points[b], result->mesh.points[c]), 0)
          << unit;
  }
}

TEST(PackDomain, TakesNestedDuplicatesOnceAndSaysSo) {
  const Pslg twice = polygons({rectangle({0, 0}, {1, 1}), rectangle({0, 0}, {1, 1})});
  const PackedMesh result = packed(twice);
  expect_valid(result, twice);
  EXPECT_EQ(result.notes, (std::vector<std::string>{"4 points coincide with others",
                                                    "4 segments repeat others"}));
  EXPECT_EQ(result.mesh.triangles, packed(unit_square()).mesh.triangles);
}

TEST(PackDomain, SaysWhichPointsAndSegmentsLieOutside) {
  Pslg domain = unit_square();
  domain.points.insert(domain.points.end(), {{0.5, 0.5}, {3, 0}, {5, 1}, {3, 0}});
  const auto points_only = packed(domain);
  ASSERT_EQ(points_only.notes.size(), 2u);
  EXPECT_EQ(points_only.notes[1],
            "3 points outside the domain are left out, the first: point 5 (counted from 0)");
  domain.segments.push_back({5, 6});
  const auto with_segment = packed(domain);
  ASSERT_EQ(with_segment.notes.size(), 3u);
  EXPECT_EQ(with_segment.notes[2], "1 segment outside the domain is left out");
  EXPECT_TRUE(packed(unit_square()).notes.empty());
}

TEST(PackDomain, SaysThatItFillsTheHullWhereSegmentsDoNot) {
  PackingOptions options;
  options.holes = HoleRule::kNone;
  Pslg domain = unit_square();
  EXPECT_TRUE(packed(domain, options).notes.empty());
  domain.points.insert(domain.points.end(), {{2, 0}, {2, 1}});
  const auto filled = packed(domain, options);
  ASSERT_EQ(filled.notes.size(), 1u);
  EXPECT_EQ(filled.notes[0], "the mesh fills the convex hull; 3 edges of it on no segment");
  domain.segments.clear();
  EXPECT_TRUE(packed(domain, options).notes.empty());
}

TEST(PackDomain, RefusesOptionsOutOfRange) {
  PackingOptions options;
  options.beta = 1.5;
  EXPECT_EQ(pack_domain(unit_square(), options).error().code, ErrorCode::kUsage);
  options = {};
  options.smallest_angle_deg = 40;
  EXPECT_EQ(pack_domain(unit_square(), options).error().code, ErrorCode::kUsage);
  options = {};
  options.size = [](Point2) { return -1.0; };
  EXPECT_EQ(pack_domain(unit_square(), options).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace wellspaced
