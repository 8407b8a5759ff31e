// The compiled figures beside the files that they were taken from.
#include "wellspaced/io/reproduce/published.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/tables.hpp"

namespace wellspaced {
namespace {

constexpr const char* kLevelColumns[] = {"nodes",
                                         "interior_smallest",
                                         "interior_avg_smallest",
                                         "boundary_smallest",
                                         "boundary_avg_smallest",
                                         "interior_le_10",
                                         "boundary_le_10",
                                         "intersection_mean",
                                         "intersection_max"};

struct SequenceFile {
  std::string table, mesh;
};
const SequenceFile kSequenceFiles[] = {{"8_3", "grid1"},    {"8_4", "grid10"},
                                       {"8_5", "crack"},    {"8_6", "airfoil1"},
                                       {"8_7", "airfoil2"}, {"8_8", "airfoil3"}};

void expect_levels(const SequenceFile& file, const std::string& method) {
  const std::string name = "table_" + file.table + "_" + file.mesh + "_" + method + ".csv";
  const test::Table table = test::read_table(name);
  if (table.empty()) GTEST_SKIP() << "no " << test::table_file(name);
  const PublishedSequence* sequence = published_sequence(file.mesh, method);
  ASSERT_NE(sequence, nullptr) << name;
  ASSERT_EQ(sequence->levels.size(), table.at("nodes").size()) << name;
  for (std::size_t column = 0; column < std::size(kLevelColumns); ++column)
    for (std::size_t level = 0; level < sequence->levels.size(); ++level)
      EXPECT_EQ(sequence->levels[level][column],
                table.at(kLevelColumns[column])[level].value_or(kNotPrinted))
          << name << ' ' << kLevelColumns[column] << ' ' << level;
}

TEST(Published, SequencesAreThoseOfTheFiles) {
  for (const SequenceFile& file : kSequenceFiles)
    for (const std::string method : {"function", "mis"}) expect_levels(file, method);
}

TEST(Published, HasNoSequenceOfOtherMeshesAndMethods) {
  EXPECT_EQ(published_sequence("grid20", "mis"), nullptr);
  EXPECT_EQ(published_sequence("crack", "quadtree"), nullptr);
}

void expect_work(const std::string& name, std::span<const PublishedWork> rows) {
  const test::Table table = test::read_table(name);
  if (table.empty()) GTEST_SKIP() << "no " << test::table_file(name);
  ASSERT_EQ(table.at("row").size(), rows.size());
  std::size_t column = 0;
  for (const std::string mesh : {"crack", "airfoil1", "airfoil2", "airfoil3"})
    for (const std::string factor : {"_C4", "_C8"})
      for (const std::string figure : {"_max", "_avg"}) {
        for (std::size_t row = 0; row < rows.size(); ++row)
          EXPECT_EQ(rows[row][column], table.at(mesh + factor + figure)[row].value_or(kNotPrinted))
              << name << ' ' << mesh << factor << figure << ' ' << row;
        ++column;
      }
}

TEST(Published, WorkIsThatOfTheFiles) {
  expect_work("section_8_4_1_path_depth.csv", published_path_depth());
  expect_work("section_8_4_2_nodes_inspected_per_selection.csv", published_node_search());
  expect_work("section_8_4_3_nodes_inspected_per_edge.csv", published_edge_search());
}

TEST(Published, DegradationIsThatOfTheFile) {
  const test::Table table = test::read_table("section_6_1_mis_degradation.csv");
  if (table.empty()) GTEST_SKIP() << "no tables";
  const auto rows = published_degradation();
  ASSERT_EQ(rows.size(), table.at("level").size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], table.at("smallest_angle_deg")[i]);
    EXPECT_EQ(rows[i][1], table.at("nodes_needed")[i]);
  }
}

TEST(Published, SpecialPointsAreThoseOfTheFile) {
  if (test::listed_special_points("crack").empty()) GTEST_SKIP() << "no tables";
  for (const std::string mesh : {"crack", "airfoil1", "airfoil3"}) {
    const auto points = special_points_of(mesh);
    EXPECT_EQ(std::vector<Index>(points.begin(), points.end()), test::listed_special_points(mesh));
  }
}

}  // namespace
}  // namespace wellspaced
