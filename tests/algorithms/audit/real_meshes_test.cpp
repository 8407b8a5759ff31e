// The exact facts of data/README.md, mesh by mesh.
#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"

namespace wellspaced {
namespace {

struct Facts {
  const char* name;
  double nodes, triangles;
  std::uint64_t circle_failures;
  double coincident_nodes;
};

class RealMesh : public testing::TestWithParam<Facts> {};

TEST_P(RealMesh, HasTheExactFactsOfItsReadme) {
  const Facts facts = GetParam();
  const auto mesh = test::data_mesh(facts.name);
  if (!mesh) GTEST_SKIP() << facts.name << " is not there";
  const audit::Report report = audit::audit_mesh(*mesh);
  for (const audit::Check& check : report.checks)
    EXPECT_TRUE(check.pass() || !check.required) << check.name << ": " << check.violations;
  EXPECT_EQ(report.measure("nodes")->value, facts.nodes);
  EXPECT_EQ(report.measure("triangles")->value, facts.triangles);
  EXPECT_EQ(report.check("constrained_delaunay")->violations, facts.circle_failures);
  EXPECT_EQ(report.check("delaunay")->violations, facts.circle_failures);
  EXPECT_EQ(report.measure("coincident_nodes")->value, facts.coincident_nodes);
  EXPECT_TRUE(report.check("boundary_has_segments")->pass());
}

INSTANTIATE_TEST_SUITE_P(Data, RealMesh,
                         testing::Values(Facts{"thesis/airfoil1", 4253, 8034, 0, 0},
                                         Facts{"thesis/airfoil3", 15606, 30269, 0, 0},
                                         Facts{"thesis/crack", 10183, 20141, 0, 0},
                                         Facts{"thesis/airfoil3_original", 15606, 30269, 6, 0},
                                         Facts{"thesis/crack_merged", 10183, 20141, 1749, 0},
                                         Facts{"thesis/crack_slit", 10240, 20141, 1727, 57},
                                         Facts{"graded/su2_naca0012_inv", 5233, 10216, 0, 0},
                                         Facts{"graded/adcirc_shinnecock", 3070, 5780, 8, 0},
                                         Facts{"graded/thetis_north_sea_demo", 13192, 23067, 178,
                                               0}));

// from_10_to_20: the last column of the table leaves out what the one before it counts.
struct Row {
  const char* name;
  double gradation, triangles_per_scale, smallest_angle, largest_angle, le_10, from_10_to_20;
};

class Table81 : public testing::TestWithParam<Row> {};

TEST_P(Table81, IsReproduced) {
  const Row row = GetParam();
  const auto mesh = test::data_mesh(row.name);
  if (!mesh) GTEST_SKIP() << row.name << " is not there";
  const audit::Report report = audit::audit_mesh(*mesh);
  const auto measured = [&](const char* name) { return report.measure(name)->value; };
  EXPECT_NEAR(measured("gradation"), row.gradation, 0.011);
  EXPECT_NEAR(measured("triangles_per_scale"), row.triangles_per_scale, 1);
  EXPECT_NEAR(measured("min_angle"), row.smallest_angle, 0.01);
  EXPECT_NEAR(measured("max_angle"), row.largest_angle, 0.01);
  EXPECT_EQ(measured("triangles_le_10"), row.le_10);
  EXPECT_EQ(measured("triangles_le_20") - measured("triangles_le_10"), row.from_10_to_20);
}

INSTANTIATE_TEST_SUITE_P(Data, Table81,
                         testing::Values(Row{"thesis/crack", 15.43, 1305, 37.00, 97.61, 0, 0},
                                         Row{"thesis/airfoil1", 9.55, 841, 8.18, 117.08, 1, 7},
                                         Row{"thesis/airfoil3", 14.89, 2032, 9.39, 138.48, 1, 24}));

}  // namespace
}  // namespace wellspaced
