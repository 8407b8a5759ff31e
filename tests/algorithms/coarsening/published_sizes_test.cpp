// The sizes of whole sequences beside Tables 8.5, 8.6 and 8.8: means over thirty seeds.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/data_files.hpp"
#include "tests/support/tables.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"

namespace wellspaced {
namespace {

constexpr std::uint64_t kRuns = 30;
constexpr double kFewNodes = 50;  // rows of smaller levels are left out

// For each level the mean of its nodes over the runs; a run without the level counts as 0 there.
std::vector<double> mean_sizes(const TriangleMesh& mesh, CoarseningOptions options) {
  std::vector<double> means;
  for (options.seed = 1; options.seed <= kRuns; ++options.seed) {
    const Hierarchy hierarchy = coarsen(mesh, options).value();
    if (means.size() < hierarchy.levels.size()) means.resize(hierarchy.levels.size());
    for (std::size_t k = 0; k < hierarchy.levels.size(); ++k)
      means[k] += static_cast<double>(hierarchy.levels[k].mesh.points.size()) / kRuns;
  }
  return means;
}

void expect_sizes(const std::string& file, const std::string& name, const std::string& table_name) {
  const auto mesh = test::data_mesh("thesis/" + file);
  const auto special = test::listed_special_points(name);
  const test::Table table = test::read_table(table_name);
  if (!mesh || special.empty() || table.empty()) GTEST_SKIP() << "no data or tables";
  CoarseningOptions options;
  options.fixed = special;
  const std::vector<double> means = mean_sizes(*mesh, options);
  const auto& published = table.at("nodes");
  std::size_t compared = 0;
  for (std::size_t k = 1; k < published.size() && *published[k] >= kFewNodes; ++k, ++compared) {
    ASSERT_LT(k, means.size());
    EXPECT_NEAR(means[k], *published[k], 0.015 * *published[k]) << name << ", level " << k;
  }
  EXPECT_GE(compared, 3u);
}

TEST(PublishedSizes, CrackCoarsensAsInTable85) {
  expect_sizes("crack_float32", "crack", "table_8_5_crack_function.csv");
}

TEST(PublishedSizes, Airfoil1CoarsensAsInTable86) {
  expect_sizes("airfoil1", "airfoil1", "table_8_6_airfoil1_function.csv");
}

TEST(PublishedSizes, Airfoil3CoarsensAsInTable88) {
  expect_sizes("airfoil3_original", "airfoil3", "table_8_8_airfoil3_function.csv");
}

}  // namespace
}  // namespace wellspaced
