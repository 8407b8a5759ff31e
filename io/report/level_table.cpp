#include "wellspaced/io/report/level_table.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

using Statistics = LevelStatistics;
using Text = std::optional<std::string>;

// Columns of one group stand next to each other, under its name.
struct Column {
  std::string group, name;
  std::function<Text(const Statistics&)> cell;
};

Text degrees(const std::optional<double>& angle) { return angle ? Text(decimal(*angle)) : Text(); }

// A count of small angles, if any angles of its kind were measured.
Text count(const std::optional<double>& smallest, std::size_t small_angles) {
  return smallest ? Text(std::to_string(small_angles)) : Text();
}

using Measure = std::optional<MeanAndMax> Statistics::*;

Column mean_of(std::string group, Measure measure) {
  return {std::move(group), "mean", [=](const Statistics& level) {
            return level.*measure ? Text(decimal((level.*measure)->mean)) : Text();
          }};
}

Column max_of(std::string group, Measure measure) {
  return {std::move(group), "max", [=](const Statistics& level) {
            return level.*measure ? Text(std::to_string((level.*measure)->max)) : Text();
          }};
}

std::vector<Column> all_columns() {
  return {
      {"", "nodes", [](const Statistics& s) { return std::to_string(s.nodes); }},
      {"", "triangles", [](const Statistics& s) { return std::to_string(s.triangles); }},
      {"smallest angle", "interior",
       [](const Statistics& s) { return degrees(s.angles.interior_min_deg); }},
      {"smallest angle", "boundary",
       [](const Statistics& s) { return degrees(s.angles.boundary_min_deg); }},
      {"angles <= 10", "interior",
       [](const Statistics& s) {
         return count(s.angles.interior_min_deg, s.angles.interior_le_10);
       }},
      {"angles <= 10", "boundary",
       [](const Statistics& s) {
         return count(s.angles.boundary_min_deg, s.angles.boundary_le_10);
       }},
      mean_of("intersection", &Statistics::intersection),
      max_of("intersection", &Statistics::intersection),
      mean_of("path depth", &Statistics::path_depth),
      max_of("path depth", &Statistics::path_depth),
      mean_of("node search", &Statistics::search),
      max_of("node search", &Statistics::search),
      mean_of("edge search", &Statistics::edge_search),
      max_of("edge search", &Statistics::edge_search),
  };
}

bool is_measured(const Column& column, const LevelTable& table) {
  return std::ranges::any_of(table.levels,
                             [&](const Statistics& s) { return column.cell(s).has_value(); });
}

// The name of a column and its cells, equally wide.
std::vector<std::string> cells_of(const Column& column, const LevelTable& table) {
  std::vector<std::string> cells = {column.name};
  for (const Statistics& level : table.levels) cells.push_back(column.cell(level).value_or("-"));
  std::size_t width = 8;
  for (const std::string& cell : cells) width = std::max(width, cell.size());
  for (std::string& cell : cells) cell = right_aligned(cell, width);
  return cells;
}

// Title, groups, names, then one line a level.
std::vector<std::string> lines_of(const LevelTable& table) {
  std::vector<std::string> lines = {"level"};
  for (std::size_t k = 0; k < table.levels.size(); ++k)
    lines.push_back(right_aligned(std::to_string(k), lines[0].size()));
  std::string groups, group;
  for (const Column& column : all_columns()) {
    if (!is_measured(column, table)) continue;
    const std::vector<std::string> cells = cells_of(column, table);
    if (std::exchange(group, column.group) != group) {
      groups.resize(std::max(groups.size(), lines[0].size()) + 2, ' ');
      groups += group;
    }
    for (std::size_t i = 0; i < lines.size(); ++i) append(lines[i], {"  ", cells[i]});
  }
  lines.insert(lines.begin(), {table.title, groups});
  return lines;
}

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::string level_tables(std::span<const LevelTable> tables) {
  constexpr std::size_t kGap = 4;
  std::vector<std::string> joined;
  std::size_t start = 0;
  for (const LevelTable& table : tables) {
    const std::vector<std::string> lines = lines_of(table);
    joined.resize(std::max(joined.size(), lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      joined[i].resize(start, ' ');
      joined[i] += lines[i];
    }
    for (const std::string& line : joined) start = std::max(start, line.size() + kGap);
  }
  std::string text;
  for (std::string& line : joined) append(text, {without_trailing_blanks(std::move(line)), '\n'});
  return text;
}

}  // namespace wellspaced
