#include "wellspaced/algorithms/audit/theorems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/audit_meshes.hpp"
#include "tests/support/audit_tet_meshes.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"

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

const audit::Theorem& theorem(const audit::Report& report, const std::string& name) {
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
    EXPECT_TRUE(theorem(report, "2.4.1").applies() ||
                !report.check("constrained_delaunay")->pass());
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
  const auto& t = theorem(judged(mesh, SpacingKind::kNearestNeighbour), "2.5.1(1)");
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

// A cubic grid: rho = sqrt 3 / 2 and C = sqrt 3 at most, and a gap of sqrt 3 / 2.
TEST(Theorems, BoundTheInteriorGapsOfACubicGrid) {
  const TetMesh mesh = test::cubes(2, 2, 2, [](Index, Index, Index) { return true; });
  audit::Report report = judged(mesh, SpacingKind::kNearestNeighbour);
  const auto& t = theorem(report, "3.6.2");
  EXPECT_TRUE(t.applies()) << t.missing_hypothesis;
  EXPECT_TRUE(t.holds);
  EXPECT_LE(t.left, 2);
  EXPECT_NEAR(t.right, 130 * 0.75 * 3, 1e-6);
  for (auto& measure : report.measures)
    if (measure.name == "gap_interior_upper") measure.value = 300;
  report.theorems.clear();
  audit::compare_with_theorems(mesh, SpacingKind::kNearestNeighbour, report);
  EXPECT_FALSE(theorem(report, "3.6.2").holds);
}

// A cubic grid is a packing of its box by any small constant: with beta = 12 the bound is 11.05.
TEST(Theorems, OfPackingApplyWhereTheMeshIsOne) {
  const TetMesh mesh = test::cubes(2, 2, 2, [](Index, Index, Index) { return true; });
  std::vector<double> f(mesh.points.size(), 2);
  audit::SpacingAuditOptions options;
  options.spacing = f;
  options.beta = 12;
  const auto& t = theorem(judged(mesh, SpacingKind::kLocalFeatureSize, options), "4.3.7");
  EXPECT_TRUE(t.applies());
  EXPECT_NEAR(t.right, 24 / (5 - 2 * std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(t.left, std::sqrt(0.75), 1e-9);
  options.beta = 3;
  EXPECT_FALSE(theorem(judged(mesh, SpacingKind::kLocalFeatureSize, options), "4.3.7").applies());
}

}  // namespace
}  // namespace wellspaced
