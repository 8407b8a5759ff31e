// The levels of coarsening sequences as tables of text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "wellspaced/algorithms/coarsening/statistics.hpp"

namespace wellspaced {

struct LevelTable {
  std::string title;
  std::vector<LevelStatistics> levels;
};

/// The tables side by side, levels of the same number in the same line. Columns follow the tables
/// of chapter 8; what was measured at no level has no column, what is missing at one is "-".
[[gnu::cold]] std::string level_tables(std::span<const LevelTable> tables);

}  // namespace wellspaced
