// Experiments and their tables: small ones pinned, those on the original meshes beside the thesis.
#include "wellspaced/io/reproduce/laboratory.hpp"

#include <gtest/gtest.h>

#include "tests/support/data.hpp"
#include "wellspaced/io/formats/hierarchy_files.hpp"
#include "wellspaced/io/reproduce/chapter.hpp"
#include "wellspaced/io/reproduce/chapter_page.hpp"
#include "wellspaced/io/reproduce/level_tables.hpp"

namespace wellspaced {
namespace {

std::vector<double> nodes_of(const ExhibitTable& table) {
  std::vector<double> nodes;
  for (const ExhibitRow& row : table.rows)
    if (row.cells[0].ours) nodes.push_back(*row.cells[0].ours);
  return nodes;
}

TEST(Laboratory, MakesAsManyRunsInProportionAsTheThesis) {
  for (const auto& [runs, expected] : {std::pair{30, 6}, {5, 1}, {1, 1}, {31, 7}, {300, 60}}) {
    const Laboratory laboratory({.runs = static_cast<std::size_t>(runs)});
    EXPECT_EQ(laboratory.run_count({.thesis_runs = 6}), static_cast<std::size_t>(expected)) << runs;
    EXPECT_EQ(laboratory.run_count({}), static_cast<std::size_t>(runs));
  }
}

// Pinned: the same everywhere, and changed only on purpose.
TEST(Laboratory, SmallGridsCoarsenAsEver) {
  Laboratory laboratory({.runs = 10, .scale = 0.05});
  const auto function =
      level_table(laboratory, "table-8.3", "grid1", CoarseningMethod::kFunction).value();
  EXPECT_EQ(nodes_of(function), (std::vector<double>{2500, 600, 126.5, 34.5, 11, 4}));
  const auto mis = level_table(laboratory, "table-8.4", "grid10", CoarseningMethod::kMis).value();
  EXPECT_EQ(nodes_of(mis), (std::vector<double>{2500, 572, 119, 18.5, 7, 4}));
}

TEST(Laboratory, AGridOfAnotherSizeIsNotCompared) {
  Laboratory laboratory({.runs = 30, .scale = 0.01});
  EXPECT_FALSE(level_table(laboratory, "table-8.3", "grid1", CoarseningMethod::kMis)->comparable);
}

TEST(Laboratory, FewRunsAreNotCompared) {
  WELLSPACED_REQUIRE_DATA("thesis/airfoil1.node");
  for (const std::size_t runs : {2, 3}) {
    Laboratory laboratory({.runs = runs, .data = test::data_path("thesis")});
    EXPECT_EQ(level_table(laboratory, "table-8.6", "airfoil1", CoarseningMethod::kMis)->comparable,
              runs == 3);
  }
}

TEST(Laboratory, GraphsWithoutCoordinatesHavePublishedFiguresAlone) {
  Laboratory laboratory({.runs = 1});
  const auto table =
      level_table(laboratory, "table-8.7", "airfoil2", CoarseningMethod::kFunction).value();
  EXPECT_TRUE(nodes_of(table).empty());
  EXPECT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[1].cells[0].published, 1727);
}

// The thesis' counts of small angles in Table 8.4 are sums over its five runs.
TEST(Laboratory, SumsOverTheRunsAreDivided) {
  Laboratory laboratory({.runs = 1, .scale = 0.002});
  const auto table =
      level_table(laboratory, "table-8.4", "grid10", CoarseningMethod::kFunction).value();
  EXPECT_EQ(table.rows[0].cells[5].published, 9940090. / 5);
}

TEST(Laboratory, SizesAgreeWithThePublishedOnesToTwoAndAHalfPercent) {
  WELLSPACED_REQUIRE_DATA("thesis/airfoil1.node");
  Laboratory laboratory({.runs = 6, .data = test::data_path("thesis")});
  std::vector<Exhibit> exhibits;
  for (const ExhibitKind& kind : exhibit_kinds())
    if (kind.name == "table-8.5" || kind.name == "table-8.6" || kind.name == "table-8.8")
      exhibits.push_back(make_exhibit(kind, laboratory).value());
  const Agreement agreement = agreement_of(exhibits);
  EXPECT_EQ(agreement.size_rows, 15u);
  EXPECT_LT(agreement.largest_size_percent, 2.5);
}

}  // namespace
}  // namespace wellspaced
