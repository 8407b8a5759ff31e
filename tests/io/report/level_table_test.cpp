#include "wellspaced/io/report/level_table.hpp"

#include <gtest/gtest.h>

namespace wellspaced {
namespace {

LevelStatistics sizes(std::size_t nodes, std::size_t triangles) {
  LevelStatistics statistics;
  statistics.nodes = nodes;
  statistics.triangles = triangles;
  return statistics;
}

TEST(LevelTables, LeaveOutColumnsThatWereMeasuredNowhere) {
  const LevelTable table{"title", {sizes(12, 13), sizes(4, 2)}};
  EXPECT_EQ(level_tables(std::vector{table}),
            "title\n"
            "\n"
            "level     nodes  triangles\n"
            "    0        12         13\n"
            "    1         4          2\n");
}

TEST(LevelTables, ShowADashWhereALevelLacksAMeasure) {
  LevelTable table{"t", {sizes(12, 13), sizes(4, 2)}};
  table.levels[0].angles.boundary_min_deg = 12.3456;
  table.levels[0].angles.boundary_le_10 = 3;
  table.levels[0].path_depth = MeanAndMax{1.005, 7};
  EXPECT_EQ(level_tables(std::vector{table}),
            "t\n"
            "                            smallest angle  angles <= 10  path depth\n"
            "level     nodes  triangles  boundary  boundary      mean       max\n"
            "    0        12         13     12.35         3      1.00         7\n"
            "    1         4          2         -         -         -         -\n");
}

TEST(LevelTables, StandSideBySideWhateverTheirLengths) {
  const std::vector<LevelTable> tables = {{"first", {sizes(9, 8)}},
                                          {"second", {sizes(9, 8), sizes(4, 2)}}};
  EXPECT_EQ(level_tables(tables),
            "first                         second\n"
            "\n"
            "level     nodes  triangles    level     nodes  triangles\n"
            "    0         9          8        0         9          8\n"
            "                                  1         4          2\n");
}

TEST(LevelTables, OfNothingAreEmpty) { EXPECT_EQ(level_tables({}), ""); }

}  // namespace
}  // namespace wellspaced
