// The million-node grids of section 8.5 beside Tables 8.3 and 8.4: node counts and smallest angles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/tables.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"

namespace wellspaced {
namespace {

// A table of chapter 8, by default of as many runs as the thesis made of GRID(1). Sizes may differ
// by 2.5%, the smallest angle over all runs be 2.5 degrees smaller.
struct Subject {
  std::string file;
  double aspect = 1;
  CoarseningMethod method = CoarseningMethod::kFunction;
  std::size_t levels = 6, runs = 6;
};

// One level over all runs, as the tables print it.
struct Row {
  double mean_nodes = 0, smallest_angle = 180;
};

// Every run has a grid of its own.
std::vector<Row> grid_rows(const Subject& subject) {
  std::vector<Row> rows(subject.levels + 1);
  CoarseningOptions options;
  options.method = subject.method;
  options.factor = 2;
  options.protect = 0.2;  // by both methods: the README of algorithms/coarsening says why
  options.max_levels = subject.levels;
  for (options.seed = 1; options.seed <= subject.runs; ++options.seed) {
    GridOptions grid{.aspect = subject.aspect, .diagonals = GridDiagonals::kMixed, .mixed = 0.13};
    grid.seed = options.seed;
    const Hierarchy hierarchy = coarsen(generate_grid(grid).value(), options).value();
    for (std::size_t k = 0; k < rows.size() && k < hierarchy.levels.size(); ++k) {
      const TriangleMesh& mesh = hierarchy.levels[k].mesh;
      const AngleStatistics angles = angle_statistics(mesh);
      rows[k].mean_nodes +=
          static_cast<double>(mesh.points.size()) / static_cast<double>(subject.runs);
      rows[k].smallest_angle =
          std::min({rows[k].smallest_angle, angles.interior_min_deg.value_or(180),
                    angles.boundary_min_deg.value_or(180)});
    }
  }
  return rows;
}

void expect_rows(const Subject& subject) {
  const test::Table table = test::read_table(subject.file);
  if (table.empty()) GTEST_SKIP() << "no " << test::table_file(subject.file);
  const std::vector<Row> rows = grid_rows(subject);
  std::printf("%s\nlevel     nodes published    diff  smallest published\n", subject.file.c_str());
  for (std::size_t k = 1; k <= subject.levels; ++k) {
    SCOPED_TRACE("level " + std::to_string(k));
    const double nodes = table.at("nodes")[k].value();
    const double angle = std::min(table.at("interior_smallest")[k].value_or(180),
                                  table.at("boundary_smallest")[k].value_or(180));
    std::printf("%5zu %9.1f %9.0f %+6.2f%% %9.2f %9.2f\n", k, rows[k].mean_nodes, nodes,
                100 * (rows[k].mean_nodes / nodes - 1), rows[k].smallest_angle, angle);
    EXPECT_NEAR(rows[k].mean_nodes, nodes, 0.025 * nodes);
    EXPECT_GE(rows[k].smallest_angle, angle - 2.5);
  }
}

TEST(PublishedGrids, Grid1ByFunctionIsAsInTable83) {
  expect_rows({.file = "table_8_3_grid1_function.csv"});
}

// Twice as many runs as the thesis made: level 6 spreads by 2.5% from run to run.
TEST(PublishedGrids, Grid1ByMisIsAsInTable83) {
  expect_rows({.file = "table_8_3_grid1_mis.csv", .method = CoarseningMethod::kMis, .runs = 12});
}

TEST(PublishedGrids, Grid10ByFunctionIsAsInTable84) {
  expect_rows({.file = "table_8_4_grid10_function.csv", .aspect = 10, .levels = 8, .runs = 5});
}

// Levels 5 and 6 spread by 3% and 11% from run to run.
TEST(PublishedGrids, Grid10ByMisIsAsInTable84) {
  expect_rows({.file = "table_8_4_grid10_mis.csv",
               .aspect = 10,
               .method = CoarseningMethod::kMis,
               .levels = 4,
               .runs = 5});
}

}  // namespace
}  // namespace wellspaced
