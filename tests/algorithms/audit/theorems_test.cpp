#include "wellspaced/algorithms/audit/theorems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/audit_tet_meshes.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using audit::SpacingKind;

audit::Report judged(const TriangleMesh& mesh, SpacingKind kind,
                     const audit::SpacingAuditOptions& options = {}) {
  audit::Report report = audit::audit_mesh(mesh);
  audit::audit_spacing(mesh, options, report);
  audit::compare_with_theorems(mesh, kind, report);
  return report;
}

audit::Report judged(const TetMesh& mesh, SpacingKind kind,
                     const audit::SpacingAuditOptions& options = {}) {
  audit::Report report = audit::audit_tet_mesh(mesh);
  audit::audit_spacing(mesh, options, report);
  audit::compare_with_theorems(mesh, kind, report);
  return report;
}

audit::Theorem theorem(const audit::Report& report, const std::string& name) {
  return *std::find_if(report.theorems.begin(), report.theorems.end(),
                       [&](const auto& t) { return t.name == name; });
}

void expect_all_hold(const audit::Report& report, const std::string& mesh) {
  EXPECT_FALSE(report.theorems.empty());
  for (const auto& t : report.theorems)
    EXPECT_TRUE(t.holds || !t.applies())
        << mesh << ": " << t.name << " " << t.left << " <= " << t.right;
}

TEST(Theorems, OfThePlaneHoldOnEveryCleanMesh) {
  for (const auto& [name, mesh] : test::clean_meshes()) {
    if (mesh.points.size() > 2000) continue;
    const auto report = judged(mesh, SpacingKind::kNearestNeighbour);
    expect_all_hold(report, name);
    EXPECT_TRUE(theorem(report, "2.4.2").applies()) << name;
    EXPECT_EQ(theorem(report, "2.4.1").applies(), report.check("spheres_empty")->pass()) << name;
    EXPECT_TRUE(theorem(report, "2.5.1(1)").applies()) << name;
  }
}

TEST(Theorems, OfSpaceHoldOnEveryCleanMesh) {
  for (const auto& [name, mesh] : test::clean_tet_meshes()) {
    const auto report = judged(mesh, SpacingKind::kNearestNeighbour);
    expect_all_hold(report, name);
    EXPECT_TRUE(theorem(report, "3.4.5").applies()) << name;
    EXPECT_FALSE(theorem(report, "4.3.7").applies()) << name;
  }
}

// Two triangles of the hexagonal lattice. As printed, the bound reads 4 / (L (2 + beta)) = sqrt 3.
TEST(Theorems, OnTheHexagonalLatticeThePrintedConstantOf251IsRefutedAndTheCorrectedOneHolds) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}, {1.5, std::sqrt(0.75)}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  test::add_boundary_segments(mesh);
  const auto t = theorem(judged(mesh, SpacingKind::kNearestNeighbour), "2.5.1(1)");
  EXPECT_NEAR(t.left, 1 / std::sqrt(0.75), 1e-9);
  EXPECT_TRUE(t.holds);
  EXPECT_LT(t.right / 4, t.left);
}

TEST(Theorems, NameTheHypothesisThatFails) {
  const TriangleMesh mesh = test::random_mesh(60, 1);
  std::vector<double> f(mesh.points.size(), 0.01);
  f[7] = 100;
  audit::SpacingAuditOptions options;
  options.spacing = f;
  const auto report = judged(mesh, SpacingKind::kGiven, options);
  EXPECT_EQ(theorem(report, "2.4.2").missing_hypothesis, "the spacing function is NN");
  EXPECT_EQ(theorem(report, "2.5.1(1)").missing_hypothesis, "f is 1-Lipschitz");
  expect_all_hold(report, "random");
}

TEST(Theorems, ThatApplyAndFailAreSaidToFail) {
  const TriangleMesh mesh = test::annulus(12);
  audit::Report report = audit::audit_mesh(mesh);
  audit::audit_spacing(mesh, {}, report);
  for (auto& measure : report.measures) {
    if (measure.name == "beta") measure.value = 2.5;
    if (measure.name == "boundary_distance") measure.value = 0.1;
    if (measure.name == "gap_interior_upper") measure.value = 0.2;
    if (measure.name == "gap") measure.value = 1e300;
  }
  audit::compare_with_theorems(mesh, SpacingKind::kNearestNeighbour, report);
  for (const char* name : {"2.4.1", "2.4.2", "2.4.6", "2.5.1(1)"}) {
    EXPECT_TRUE(theorem(report, name).applies()) << name;
    EXPECT_FALSE(theorem(report, name).holds) << name;
  }
}

// A cubic grid: rho = sqrt 3 / 2 and C = sqrt 3, and gaps of 1/2, sqrt 2 / 2 and sqrt 3 / 2.
TEST(Theorems, BoundTheGapsOfACubicGrid) {
  const TetMesh mesh = test::cubes(2, 2, 2, [](Index, Index, Index) { return true; });
  const double rho = std::sqrt(0.75), c = std::sqrt(3.0);
  const struct {
    const char *theorem, *gap;
    double left, right;
  } cases[] = {
      {"3.6.2(1)", "gap_segment_upper", 0.5, c * (1 + 4 * rho) / 2},
      {"3.6.2(2)", "gap_face_upper", std::sqrt(0.5), 4 * (1 + 6 * rho) * (1 + 6 * rho) + 0.5},
      {"3.6.2(3)", "gap_interior_upper", rho, 4.5 * (1 + 8 * rho) * (1 + 8 * rho) + 0.5}};
  audit::Report report = judged(mesh, SpacingKind::kNearestNeighbour);
  for (const auto& [name, gap, left, right] : cases) {
    const auto t = theorem(report, name);
    EXPECT_TRUE(t.applies()) << t.missing_hypothesis;
    EXPECT_TRUE(t.holds);
    EXPECT_NEAR(t.left, left, 0.05 * left);
    EXPECT_NEAR(t.right, right, 1e-9 * right);
    for (auto& measure : report.measures)
      if (measure.name == gap) measure.value = right * (1 + 1e-6);
  }
  report.theorems.clear();
  audit::compare_with_theorems(mesh, SpacingKind::kNearestNeighbour, report);
  for (const auto& broken : cases) EXPECT_FALSE(theorem(report, broken.theorem).holds);
}

// What the bound on gaps rests on: f(u) >= NN(p) / (1 + 2 k rho) at a place u of a simplex with k
// corners, p the one of largest weight.
TEST(Theorems, BoundOnGapsRestsOnTheSpacingAtEveryPlace) {
  const TetMesh mesh = test::random_tet_mesh(120, 3);
  const double rho = judged(mesh, SpacingKind::kNearestNeighbour).measure("radius_edge")->value;
  const auto at = [&](Index v) { return audit::coordinates_of(mesh.points[v]); };
  std::vector<double> nn(mesh.points.size(), INFINITY);
  for (Index v = 0; v < nn.size(); ++v)
    for (Index w = 0; w < nn.size(); ++w)
      if (v != w) nn[v] = std::min(nn[v], audit::distance_of(at(v), at(w)));
  Random random(1);
  for (const auto& tet : mesh.tets)
    for (std::size_t k = 2; k <= 4; ++k) {
      std::array<double, 4> weight{};
      double sum = 0;
      for (std::size_t i = 0; i < k; ++i) sum += weight[i] = random.uniform();
      audit::Vec<3> u{};
      for (std::size_t i = 0; i < k; ++i) u = audit::step(u, weight[i] / sum, at(tet[i]));
      double f = INFINITY;
      for (Index v = 0; v < nn.size(); ++v) f = std::min(f, nn[v] + audit::distance_of(u, at(v)));
      const auto heaviest = std::max_element(weight.begin(), weight.end()) - weight.begin();
      EXPECT_GE(f * (1 + 2 * k * rho) * (1 + 1e-9), nn[tet[heaviest]]);
    }
}

// Two bodies next to each other, node against node: each is near to its image, though no edge tells
// of it.
TEST(Theorems, HoldForBodiesThatAlmostTouch) {
  const TetMesh cubes = test::cubes(2, 2, 2, [](Index, Index, Index) { return true; });
  const auto report =
      judged(test::side_by_side(cubes, cubes, {2 + 0x1p-10, 0, 0}), SpacingKind::kNearestNeighbour);
  expect_all_hold(report, "two boxes");
  EXPECT_TRUE(theorem(report, "3.6.2(3)").applies());
  EXPECT_GT(report.measure("gap")->value, 800);
  EXPECT_GT(report.measure("density_graph_constant")->value, 1700);
}

// Node against edge: the circles reach across, and the nodes are far from all that they can see.
TEST(Theorems, DoNotTakeWhatLiesBehindTheOutsideForNear) {
  const TriangleMesh grid = generate_grid({.nx = 4, .ny = 4}).value();
  const auto report =
      judged(test::side_by_side(grid, grid, {3 + 0x1p-10, 0.5}), SpacingKind::kNearestNeighbour);
  expect_all_hold(report, "two grids");
  EXPECT_TRUE(theorem(report, "2.4.6").applies());
  EXPECT_FALSE(theorem(report, "2.4.1").applies());
  EXPECT_EQ(report.measure("boundary_distance")->value, 1);
}

// A cubic grid is a packing of its box by any small constant: with beta = 12 the bound is 11.05.
TEST(Theorems, OfPackingApplyWhereTheMeshIsOne) {
  const TetMesh mesh = test::cubes(2, 2, 2, [](Index, Index, Index) { return true; });
  std::vector<double> f(mesh.points.size(), 2);
  audit::SpacingAuditOptions options;
  options.spacing = f;
  options.beta = 12;
  const auto t = theorem(judged(mesh, SpacingKind::kLocalFeatureSize, options), "4.3.7");
  EXPECT_TRUE(t.applies());
  EXPECT_NEAR(t.right, 24 / (5 - 2 * std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(t.left, std::sqrt(0.75), 1e-9);
  options.beta = 3;
  EXPECT_FALSE(theorem(judged(mesh, SpacingKind::kLocalFeatureSize, options), "4.3.7").applies());
}

}  // namespace
}  // namespace wellspaced
