// The node sets of AIRFOIL 1 against those of another implementation of CHOICES.md.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/data_files.hpp"
#include "tests/support/tables.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"

namespace wellspaced {
namespace {

void expect_golden_levels(CoarseningMethod method, const std::string& name) {
  const auto mesh = test::data_mesh("thesis/airfoil1");
  const auto special = test::listed_special_points("airfoil1");
  if (!mesh || special.empty()) GTEST_SKIP() << "no " << test::data_path("thesis/airfoil1");
  CoarseningOptions options;
  options.method = method;
  options.fixed = special;
  const auto hierarchy = coarsen(*mesh, options);
  ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
  std::size_t level = 1;
  for (;; ++level) {
    const auto golden = test::index_file(test::table_file(
        "golden/airfoil1_" + name + "_seed1_level" + std::to_string(level) + ".txt"));
    if (golden.empty()) break;
    ASSERT_LT(level, hierarchy->levels.size());
    EXPECT_EQ(hierarchy->levels[level].origin, golden) << "level " << level;
  }
  EXPECT_GT(level, 4u) << "golden files are missing";
  EXPECT_EQ(hierarchy->levels.size(), level);
}

TEST(GoldenNodeSets, OfFunctionBasedCoarseningAreMet) {
  expect_golden_levels(CoarseningMethod::kFunction, "function");
}

TEST(GoldenNodeSets, OfMisBasedCoarseningAreMet) {
  expect_golden_levels(CoarseningMethod::kMis, "mis");
}

}  // namespace
}  // namespace wellspaced
