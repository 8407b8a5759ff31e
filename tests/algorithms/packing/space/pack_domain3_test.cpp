#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/solids.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

PackedTets packed(const Pls& domain, const PackingOptions3& options = {}) {
  auto result = pack_domain3(domain, options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  return result.ok() ? std::move(result).value() : PackedTets{};
}

Error error_of(const Pls& domain, const PackingOptions3& options = {}) {
  const auto result = pack_domain3(domain, options);
  EXPECT_FALSE(result.ok());
  return result.ok() ? Error{} : result.error();
}

audit::Report audited(const PackedTets& packed, const Pls& domain) {
  const audit::PolyhedralDomain solid = audit::domain_of(domain);
  audit::TetAuditOptions options;
  options.domain = &solid;
  return audit::audit_tet_mesh(packed.mesh, options);
}

std::vector<std::pair<const char*, Pls>> domains() {
  return {{"cube", test::unit_cube()},
          {"triangulated cube", test::triangulated_cube()},
          {"l prism", test::l_prism()},
          {"triangulated tube", test::triangulated_tube()},
          {"two boxes", test::two_boxes()},
          {"furnished box", test::furnished_box()},
          {"turned cube", test::turned(test::unit_cube())},
          {"turned l prism", test::turned(test::l_prism())},
          {"turned two boxes", test::turned(test::two_boxes())}};
}

constexpr const char* kPromised[] = {"domain_points_are_nodes", "domain_segments_are_edges",
                                     "domain_facets_are_faces", "boundary_on_domain",
                                     "constrained_delaunay",    "delaunay",
                                     "boundary_gabriel",        "circumcentres_inside",
                                     "boundary_has_facets",     "no_unused_node"};

// Theorems 4.3.5 to 4.3.7, by the auditor.
void expect_promises(const PackedTets& packed, const Pls& domain, double beta) {
  const audit::Report report = audited(packed, domain);
  EXPECT_TRUE(report.pass());
  for (const char* name : kPromised) {
    const audit::Check* check = report.check(name);
    ASSERT_NE(check, nullptr) << name;
    EXPECT_EQ(check->violations, 0u) << name;
  }
  if (const auto bound = radius_edge_bound(beta)) {
    EXPECT_LE(report.measure("radius_edge")->value, *bound);
  }
}

// Theorem 4.3.4: the balls of all nodes are disjoint, and no node is inside the smallest sphere
// through the ends of a mesh segment or the corners of a mesh facet. Every pair is looked at.
void expect_independence(const PackedTets& packed) {
  const std::vector<Point3>& p = packed.mesh.points;
  for (std::size_t v = 0; v < p.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      ASSERT_GE(length(p[v] - p[w]) * (1 + 1e-12), packed.radius[v] + packed.radius[w]);
  const auto expect_empty = [&](Point3 centre, Point3 on) {
    const double radius = length(on - centre) * (1 - 1e-9);
    for (const Point3 q : p) ASSERT_GE(length(q - centre), radius);
  };
  for (const Segment& s : packed.mesh.segments) expect_empty(0.5 * (p[s.a] + p[s.b]), p[s.a]);
  for (const auto& [corners, marker] : packed.mesh.facets) {
    const Point3 a = p[corners[0]], u = p[corners[1]] - a, v = p[corners[2]] - a, n = cross(u, v);
    const Point3 towards = dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u);
    expect_empty(a + (0.5 / dot(n, n)) * towards, a);
  }
}

// The integral of 1 / f^3 with f = beta * radius, from the values at the corners of each tet.
double spacing_integral(const PackedTets& packed, double beta) {
  double sum = 0;
  for (const auto& [a, b, c, d] : packed.mesh.tets) {
    const auto& p = packed.mesh.points;
    const double volume = dot(p[b] - p[a], cross(p[c] - p[a], p[d] - p[a])) / 6;
    for (const Index v : {a, b, c, d}) sum += volume / 4 / std::pow(beta * packed.radius[v], 3);
  }
  return sum;
}

TEST(PackDomain3, ConformsWithGoodTetsOnEveryDomain) {
  for (const auto& [name, domain] : domains()) {
    SCOPED_TRACE(name);
    const PackedTets mesh = packed(domain);
    EXPECT_TRUE(mesh.is_complete);
    expect_promises(mesh, domain, 10);
  }
}

TEST(PackDomain3, PacksPolytopesIndependently) {
  for (const auto& [name, domain] : domains()) {
    SCOPED_TRACE(name);
    expect_independence(packed(domain));
  }
}

// Theorem 4.4.1: as many nodes as the integral of (beta / f)^3, but for a constant.
TEST(PackDomain3, NeedsAsManyNodesAsTheLocalFeatureSizeSays) {
  for (const auto& [name, domain] : domains()) {
    SCOPED_TRACE(name);
    const PackedTets mesh = packed(domain);
    const double constant =
        static_cast<double>(mesh.mesh.points.size()) / (1000 * spacing_integral(mesh, 10));
    EXPECT_NEAR(nodes_by_integral(mesh), constant, 1e-9);
    RecordProperty(std::string("constant of ") + name, std::to_string(constant));
    EXPECT_GT(constant, 0.08);
    EXPECT_LT(constant, 0.2);
  }
}

// Whether a ball around a place of the unit cube or its bottom would touch no other, and the place
// is in no protective sphere, by looking at all of them.
class Room {
 public:
  explicit Room(const PackedTets& packed) : packed_(packed) {
    const auto& p = packed.mesh.points;
    for (const Segment& s : packed.mesh.segments) guard(0.5 * (p[s.a] + p[s.b]), p[s.a]);
    for (const auto& [corners, marker] : packed.mesh.facets) {
      const Point3 a = p[corners[0]], u = p[corners[1]] - a, v = p[corners[2]] - a, n = cross(u, v);
      guard(a + (0.5 / dot(n, n)) * (dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u)), a);
    }
  }

  bool is_beside_balls(Point3 x, double radius) const {
    for (std::size_t v = 0; v < packed_.radius.size(); ++v)
      if (length(x - packed_.mesh.points[v]) < radius + packed_.radius[v]) return false;
    return true;
  }
  bool is_unprotected(Point3 x, std::size_t guards) const {
    for (std::size_t k = 0; k < guards; ++k)
      if (length(x - centres_[k]) < radii_[k]) return false;
    return true;
  }
  bool in_cube(Point3 x) const {
    return is_beside_balls(x, size_of(x)) && is_unprotected(x, radii_.size());
  }
  bool on_bottom(Point3 x) const {
    const double radius = size_of(x);
    return std::min({x.x, 1 - x.x, x.y, 1 - x.y}) >= 2 * radius && is_beside_balls(x, radius) &&
           is_unprotected(x, packed_.mesh.segments.size());
  }

 private:
  void guard(Point3 centre, Point3 on) {
    centres_.push_back(centre);
    radii_.push_back(length(on - centre));
  }
  static double size_of(Point3 p) {
    return std::min({std::max(p.x, 1 - p.x), std::max(p.y, 1 - p.y), std::max(p.z, 1 - p.z)}) / 10;
  }
  const PackedTets& packed_;
  std::vector<Point3> centres_;
  std::vector<double> radii_;
};

// The number of places with room in the cube and on its bottom, of 20,000 each.
std::array<int, 2> places_with_room(const PackedTets& mesh) {
  const Room room(mesh);
  Random random(7);
  std::array<int, 2> found{};
  for (int k = 0; k < 20000; ++k) {
    const double x = random.uniform(), y = random.uniform();
    found[0] += room.in_cube({x, y, random.uniform()});
    found[1] += room.on_bottom({x, y, 0});
  }
  return found;
}

// Figure 4.3, B, without the relaxation.
TEST(PackDomain3, LeavesNoRoomAnywhereIfAskedTo) {
  PackingOptions3 options;
  const std::array<int, 2> with_room = places_with_room(packed(test::unit_cube(), options));
  EXPECT_GT(with_room[0], 0);
  EXPECT_GT(with_room[1], 10);
  options.maximality = Maximality::kFull;
  EXPECT_EQ(places_with_room(packed(test::unit_cube(), options)), (std::array{0, 0}));
}

TEST(PackDomain3, KeepsItsPromisesWhenPackedInFull) {
  PackingOptions3 options;
  options.maximality = Maximality::kFull;
  for (const Pls& domain : {test::unit_cube(), test::turned(test::unit_cube())}) {
    const PackedTets mesh = packed(domain, options);
    expect_promises(mesh, domain, 10);
    expect_independence(mesh);
  }
}

TEST(PackDomain3, BoundsTheRadiusEdgeRatioForEveryBeta) {
  for (const double beta : {12.0, 16.0, 25.0}) {
    SCOPED_TRACE(beta);
    PackingOptions3 options;
    options.beta = beta;
    expect_promises(packed(test::unit_cube(), options), test::unit_cube(), beta);
  }
}

TEST(PackDomain3, PutsBallsOfTheLocalFeatureSizeAroundNodes) {
  const PackedTets mesh = packed(test::unit_cube());
  for (std::size_t v = 0; v < mesh.mesh.points.size(); ++v) {
    const Point3 p = mesh.mesh.points[v];
    const double size =
        std::min({std::max(p.x, 1 - p.x), std::max(p.y, 1 - p.y), std::max(p.z, 1 - p.z)});
    ASSERT_NEAR(mesh.radius[v], size / 10, 1e-12);
  }
}

// Definition 4.3.3, corrected: nodes on a face are twice their radius away from its edges.
TEST(PackDomain3, KeepsNodesOfFacesFarFromTheirEdges) {
  const PackedTets mesh = packed(test::unit_cube());
  int on_bottom = 0;
  for (std::size_t v = 0; v < mesh.mesh.points.size(); ++v) {
    const Point3 p = mesh.mesh.points[v];
    const double to_edge = std::min({p.x, 1 - p.x, p.y, 1 - p.y});
    if (p.z != 0 || to_edge == 0) continue;
    ++on_bottom;
    EXPECT_GE(to_edge, 2 * mesh.radius[v]);
  }
  EXPECT_GT(on_bottom, 10);
}

TEST(PackDomain3, TracesFacetsAndSegmentsToTheDomain) {
  const Pls domain = test::furnished_box();
  const PackedTets mesh = packed(domain);
  std::vector<double> area(7);
  ASSERT_EQ(mesh.facet_of.size(), mesh.mesh.facets.size());
  for (std::size_t k = 0; k < mesh.mesh.facets.size(); ++k) {
    const auto& [corners, marker] = mesh.mesh.facets[k];
    EXPECT_EQ(marker, domain.facets[mesh.facet_of[k]].marker);
    const Point3 a = mesh.mesh.points[corners[0]];
    area[mesh.facet_of[k]] +=
        length(cross(mesh.mesh.points[corners[1]] - a, mesh.mesh.points[corners[2]] - a)) / 2;
  }
  for (std::size_t f = 0; f < 7; ++f) EXPECT_NEAR(area[f], f < 6 ? 16 : 1, 1e-9);
  double sevens = 0, edges = 0;
  for (const Segment& s : mesh.mesh.segments)
    (s.marker == 7 ? sevens : edges) += length(mesh.mesh.points[s.a] - mesh.mesh.points[s.b]);
  EXPECT_NEAR(sevens, 1, 1e-12);
  EXPECT_NEAR(edges, 52, 1e-9);
  for (Index v = 0; v < domain.points.size(); ++v) {
    EXPECT_EQ(mesh.domain_point[v], v);
    EXPECT_EQ(mesh.mesh.points[v], domain.points[v]);
  }
}

TEST(PackDomain3, LeavesHolesOpenAndNumbersRegions) {
  Pls domain = test::two_boxes();
  domain.regions = {{{1, 1, 1.5}, 5, -1}, {{1, 1, 0.5}, 6, -1}};
  const PackedTets whole = packed(domain);
  std::array<double, 2> volume{};
  ASSERT_EQ(whole.region_of.size(), whole.mesh.tets.size());
  for (std::size_t t = 0; t < whole.mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = whole.mesh.tets[t];
    const auto& p = whole.mesh.points;
    ASSERT_LT(whole.region_of[t], 2u);
    volume[whole.region_of[t]] += dot(p[b] - p[a], cross(p[c] - p[a], p[d] - p[a])) / 6;
  }
  EXPECT_NEAR(volume[0], 1, 1e-9);
  EXPECT_NEAR(volume[1], 4, 1e-9);

  Pls hollow = test::box({0, 0, 0}, {4, 4, 4});
  test::add_box(hollow, {1, 1, 1}, {3, 3, 3});
  hollow.holes = {{2, 2, 2}};
  expect_promises(packed(hollow), hollow, 10);
}

TEST(PackDomain3, FollowsASizeFunction) {
  PackingOptions3 options;
  options.size = [](Point3 p) { return 0.05 + 0.15 * p.x; };
  const PackedTets mesh = packed(test::unit_cube(), options);
  expect_promises(mesh, test::unit_cube(), 10);
  for (std::size_t v = 0; v < mesh.mesh.points.size(); ++v)
    EXPECT_LE(mesh.radius[v], options.size(mesh.mesh.points[v]) / 2);
  EXPECT_GT(mesh.mesh.points.size(), 2 * packed(test::unit_cube()).mesh.points.size());
}

// The facets are merged to within their rounding, by the auditor as well.
TEST(PackDomain3, MeshesTriangulatedSurfacesThatAreRounded) {
  const Pls domain = test::turned(test::triangulated_tube());
  const audit::PolyhedralDomain solid = audit::domain_of(domain, 1e-6);
  ASSERT_EQ(solid.facets.size(), 10u);
  audit::TetAuditOptions options;
  options.domain = &solid;
  const audit::Report report = audit::audit_tet_mesh(packed(domain).mesh, options);
  EXPECT_TRUE(report.pass());
  EXPECT_NEAR(report.measure("volume")->value, 24, 1e-9);
}

TEST(PackDomain3, IsTheSameMeshAtEveryScale) {
  const PackedTets usual = packed(test::l_prism());
  for (const int exponent : {-300, -20, 20, 300}) {
    Pls domain = test::l_prism();
    for (Point3& p : domain.points) p = std::ldexp(1, exponent) * p;
    const PackedTets scaled = packed(domain);
    ASSERT_EQ(scaled.mesh.tets, usual.mesh.tets);
    for (std::size_t v = 0; v < usual.mesh.points.size(); ++v)
      ASSERT_EQ(scaled.mesh.points[v], std::ldexp(1, exponent) * usual.mesh.points[v]);
  }
}

TEST(PackDomain3, StopsAtALimitWithAMeshThatConforms) {
  PackingOptions3 options;
  options.max_points = 300;
  const PackedTets some = packed(test::unit_cube(), options);
  EXPECT_FALSE(some.is_complete);
  EXPECT_EQ(some.mesh.points.size(), 300u);
  EXPECT_TRUE(audited(some, test::unit_cube()).pass());
  options.max_points = 50;
  EXPECT_EQ(error_of(test::unit_cube(), options).code, ErrorCode::kLimit);
  options = {};
  options.progress = [](std::string_view, std::uint64_t, std::uint64_t) { return false; };
  const auto cancelled = pack_domain3(test::unit_cube(), options);
  EXPECT_TRUE(!cancelled || cancelled->was_cancelled);
}

// ---- What is no domain -------------------------------------------------------------------------

TEST(PackDomain3, RefusesAnOpenSurface) {
  Pls domain = test::unit_cube();
  domain.facets.erase(domain.facets.begin() + 1);
  const Error error = error_of(domain);
  EXPECT_EQ(error.code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(error.message, "the facets enclose no solid: the surface is open");
  test::add_box(domain, {3, 0, 0}, {4, 1, 1});
  EXPECT_EQ(error_of(domain).ids, (std::vector<Index>{0, 1, 2, 3, 4}));
}

TEST(PackDomain3, RefusesWhatIntersectsOrMeetsAtSmallAngles) {
  Pls crossing = test::unit_cube();
  test::add_box(crossing, {0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
  EXPECT_NE(error_of(crossing).message.find("intersect"), std::string::npos);
  const Pls wedge = test::prism({{0, 0}, {2, 0}, {std::sqrt(3.0), 1}}, 1);
  EXPECT_NE(error_of(wedge).message.find("30.00 degrees"), std::string::npos);
  Pls twice = test::unit_cube();
  twice.facets.push_back(twice.facets[0]);
  EXPECT_EQ(error_of(twice).code, ErrorCode::kInvalidGeometry);
  const Pls flat = test::box({0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(error_of(flat).code, ErrorCode::kInvalidGeometry);
}

TEST(PackDomain3, RefusesDomainsWithoutFacetsAndOptionsOutOfRange) {
  EXPECT_EQ(error_of({}).code, ErrorCode::kInvalidGeometry);
  Pls points;
  points.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(error_of(points).code, ErrorCode::kInvalidGeometry);
  PackingOptions3 options;
  options.beta = 3;
  EXPECT_EQ(error_of(test::unit_cube(), options).code, ErrorCode::kUsage);
  options = {};
  options.size = [](Point3) { return -1.0; };
  EXPECT_EQ(error_of(test::unit_cube(), options).code, ErrorCode::kUsage);
  options.size = [](Point3 p) { return p.x > 0.1 && p.x < 0.9 ? NAN : 1.0; };
  EXPECT_EQ(error_of(test::unit_cube(), options).code, ErrorCode::kUsage);
  options.size = [](Point3 p) { return std::min({p.x, p.y, p.z}) > 0.1 ? -1.0 : 1.0; };
  EXPECT_EQ(error_of(test::unit_cube(), options).code, ErrorCode::kUsage);
  options.size = [](Point3 p) {
    return p.z == 0 && p.x > 0.1 && p.y > 0.1 && p.x + p.y < 1.8 ? 0.0 : 1.0;
  };
  EXPECT_EQ(error_of(test::unit_cube(), options).code, ErrorCode::kUsage);
}

TEST(PackDomain3, TurnsARadiusEdgeRatioIntoABeta) {
  EXPECT_FALSE(radius_edge_bound(9.8).has_value());
  EXPECT_NEAR(*radius_edge_bound(25), 3.2956, 1e-4);
  EXPECT_FALSE(beta_for_radius_edge(2).has_value());
  for (const double rho : {2.5, 4.0, 10.0})
    EXPECT_NEAR(*radius_edge_bound(*beta_for_radius_edge(rho)), rho, 1e-9);
}

}  // namespace
}  // namespace wellspaced
