// The published figures, beside the real data.
#pragma once

#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/data.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

inline std::string table_file(const std::string& name) { return data_path("../tables/" + name); }

/// The special points of a mesh in tables/special_points.csv, whose last column lists them.
inline std::vector<Index> listed_special_points(const std::string& mesh) {
  std::ifstream file(table_file("special_points.csv"));
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(mesh + ",", 0) != 0) continue;
    std::istringstream list(line.substr(line.rfind(',') + 1));
    return {std::istream_iterator<Index>(list), std::istream_iterator<Index>()};
  }
  return {};
}

/// The columns of a table by their headings; an empty cell is no value. Empty: no such file.
using Table = std::map<std::string, std::vector<std::optional<double>>>;

inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line + ",");
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  return cells;
}

inline Table read_table(const std::string& name) {
  Table table;
  std::ifstream file(table_file(name));
  std::string line;
  if (!std::getline(file, line)) return table;
  const std::vector<std::string> headings = cells_of(line);
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    for (std::size_t i = 0; i < headings.size(); ++i) {
      const bool empty = i >= cells.size() || cells[i].empty();
      table[headings[i]].push_back(empty ? std::nullopt : std::optional(std::stod(cells[i])));
    }
  }
  return table;
}

}  // namespace wellspaced::test
