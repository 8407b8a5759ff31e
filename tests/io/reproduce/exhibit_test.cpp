#include "wellspaced/io/reproduce/exhibit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/io/reproduce/exhibit_files.hpp"

namespace wellspaced {
namespace {

// A table of one row: an angle and a count.
ExhibitTable one_row(ExhibitCell angle, ExhibitCell count) {
  ExhibitTable table{.name = "t", .title = "T"};
  table.columns = {{"angles", "smallest", 2, CellRule::kTwoDegrees}, {"", "count", 0}};
  table.rows = {{"1", {angle, count}}};
  return table;
}

Exhibit exhibit_with(ExhibitTable table) {
  return {.name = "table-t", .title = "Table T", .tables = {std::move(table)}};
}

TEST(Exhibit, AnglesMayDifferByTwoDegrees) {
  EXPECT_FALSE(is_beyond(one_row({20, 22, 20, 20}, {}), 0, 0));
  EXPECT_TRUE(is_beyond(one_row({20, 22.01, 20, 30}, {}), 0, 0));
}

TEST(Exhibit, CountsMayDifferByTheSpreadOfTheRunsAndAUnit) {
  EXPECT_FALSE(is_beyond(one_row({}, {100, 111, 95, 110}), 0, 1));
  EXPECT_FALSE(is_beyond(one_row({}, {100, 94, 95, 110}), 0, 1));
  EXPECT_TRUE(is_beyond(one_row({}, {100, 112, 95, 110}), 0, 1));
  EXPECT_TRUE(is_beyond(one_row({}, {100, 93, 95, 110}), 0, 1));
}

TEST(Exhibit, AFigureThatOneSideLacksIsBeyond) {
  EXPECT_TRUE(is_beyond(one_row({20, {}, 20, 20}, {5, 5, 5, 5}), 0, 0));
  EXPECT_TRUE(is_beyond(one_row({{}, 20, {}, {}}, {5, 5, 5, 5}), 0, 0));
  EXPECT_FALSE(is_beyond(one_row({}, {5, 5, 5, 5}), 0, 0));
}

TEST(Exhibit, ARowThatOneSideLacksIsToldOnce) {
  const ExhibitTable table = one_row({20, {}, 20, 20}, {5, {}, 5, 5});
  EXPECT_TRUE(is_beyond(table, 0, 0));
  EXPECT_FALSE(is_beyond(table, 0, 1));
}

TEST(Exhibit, WhatWasMeasuredOnAnotherMeshIsNotCompared) {
  ExhibitTable table = one_row({20, 40, 20, 20}, {5, 500, 5, 5});
  EXPECT_EQ(deviations(exhibit_with(table)).size(), 2u);
  table.comparable = false;
  EXPECT_TRUE(deviations(exhibit_with(table)).empty());
}

TEST(Exhibit, ADeviationNamesItsPlace) {
  const auto found = deviations(exhibit_with(one_row({20, 40, 20, 20}, {5, 5, 5, 5})));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].exhibit, "table-t");
  EXPECT_EQ(found[0].row, "level 1");
  EXPECT_EQ(found[0].column, "angles, smallest");
  EXPECT_EQ(found[0].ours, 20);
  EXPECT_EQ(found[0].published, 40);
  EXPECT_FALSE(found[0].reason.empty());
}

TEST(Exhibit, DifferencesAreSignedAndMayBeRelative) {
  ExhibitColumn column{"", "nodes", 0};
  EXPECT_EQ(difference_text(column, {102, 100, {}, {}}), "+2");
  EXPECT_EQ(difference_text(column, {97, 100, {}, {}}), "-3");
  column.relative = true;
  EXPECT_EQ(difference_text(column, {103, 200, {}, {}}), "-48.5%");
  EXPECT_EQ(difference_text(column, {103, 0, {}, {}}), "-");
  EXPECT_EQ(difference_text(column, {103, {}, {}, {}}), "-");
}

TEST(ExhibitFiles, ACsvHasOursTheSpreadThePublishedAndTheDifference) {
  EXPECT_EQ(table_csv(one_row({20, 22, 19.5, 21}, {5, {}, 4, 6})),
            "level,angles smallest ours,angles smallest low,angles smallest high,angles smallest "
            "published,angles smallest difference,count ours,count low,count high,count "
            "published,count difference\n"
            "1,20,19.5,21,22,-2,5,4,6,,\n");
}

TEST(ExhibitFiles, TheTextHasThreeLinesARow) {
  const std::string text = exhibit_text(exhibit_with(one_row({20, 25, 20, 21}, {5, 5, 4, 6})));
  EXPECT_NE(text.find("      1        ours    20.00*      5\n"), text.npos) << text;
  EXPECT_NE(text.find("             thesis     25.00      5\n"), text.npos) << text;
  EXPECT_NE(text.find("         difference     -5.00     +0\n"), text.npos) << text;
  EXPECT_NE(text.find("t, level 1, angles, smallest: 20.00, in the thesis 25.00: "), text.npos);
}

}  // namespace
}  // namespace wellspaced
