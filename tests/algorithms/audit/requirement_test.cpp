#include "wellspaced/algorithms/audit/requirement.hpp"

#include <gtest/gtest.h>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/shape.hpp"

namespace wellspaced {
namespace {

using audit::parse_requirement;
using Relation = audit::Requirement::Relation;

TEST(Requirement, IsANameOrABound) {
  const auto name = parse_requirement(" delaunay ").value();
  EXPECT_EQ(name.name, "delaunay");
  EXPECT_EQ(name.relation, Relation::kPasses);
  const auto bound = parse_requirement("min_angle >= 15.5").value();
  EXPECT_EQ(bound.name, "min_angle");
  EXPECT_EQ(bound.relation, Relation::kAtLeast);
  EXPECT_EQ(bound.bound, 15.5);
  EXPECT_EQ(parse_requirement("x<1")->relation, Relation::kLess);
  EXPECT_EQ(parse_requirement("x>1")->relation, Relation::kMore);
  EXPECT_EQ(parse_requirement("x<=1e3")->relation, Relation::kAtMost);
  EXPECT_EQ(parse_requirement("x==-1")->relation, Relation::kEqual);
}

TEST(Requirement, IsRefusedWhereItCannotBeRead) {
  for (const char* text : {"", " ", "min angle>=3", "min_angle>=", "min_angle>=x", ">=3", "a=3",
                           "min_angle>=3 4", "Delaunay", "a>=1>=2"})
    EXPECT_FALSE(parse_requirement(text).ok()) << text;
}

TEST(Requirement, MakesACheckCount) {
  const TriangleMesh mesh = test::random_mesh(200, 1);
  auto report = audit::audit_mesh(mesh);
  ASSERT_TRUE(report.pass());
  ASSERT_FALSE(report.check("gabriel")->pass());
  EXPECT_TRUE(audit::require(parse_requirement("gabriel").value(), mesh, report).ok());
  EXPECT_FALSE(report.pass());
}

TEST(Requirement, ListsTheTrianglesThatBreakABound) {
  const TriangleMesh mesh = test::random_mesh(200, 1);
  auto report = audit::audit_mesh(mesh);
  ASSERT_TRUE(audit::require(parse_requirement("min_angle>=20").value(), mesh, report).ok());
  const auto* check = report.check("min_angle>=20");
  ASSERT_NE(check, nullptr);
  EXPECT_FALSE(report.pass());
  EXPECT_EQ(check->value, report.measure("min_angle")->value);
  std::vector<Index> expected;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto shape = audit::triangle_shape(mesh.points[a], mesh.points[b], mesh.points[c]);
    if (shape.min_angle < 20) expected.push_back(t);
  }
  EXPECT_EQ(check->ids, expected);
  EXPECT_EQ(check->violations, expected.size());
}

TEST(Requirement, ComparesViolationsOfAChecksName) {
  const TriangleMesh mesh = test::random_mesh(200, 1);
  auto report = audit::audit_mesh(mesh);
  ASSERT_TRUE(audit::require(parse_requirement("gabriel<=100000").value(), mesh, report).ok());
  EXPECT_TRUE(report.pass());
  ASSERT_TRUE(audit::require(parse_requirement("gabriel<=1").value(), mesh, report).ok());
  EXPECT_FALSE(report.pass());
}

TEST(Requirement, MustNameSomethingThatIsThere) {
  const TriangleMesh mesh = test::random_mesh(50, 1);
  auto report = audit::audit_mesh(mesh);
  const Status status = audit::require(parse_requirement("min_angel>=3").value(), mesh, report);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUsage);
  EXPECT_FALSE(audit::require(parse_requirement("frobnicate").value(), mesh, report).ok());
}

}  // namespace
}  // namespace wellspaced
