// A table or figure of the thesis, reproduced: our figures beside the published ones, and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wellspaced {

/// A figure of ours and the published one, where there are any; low and high: over our runs.
struct ExhibitCell {
  std::optional<double> ours, published, low, high;
};

/// Which figure of a cell: &ExhibitCell::ours or &ExhibitCell::published.
using CellFigure = std::optional<double> ExhibitCell::*;

/// When a figure of ours counts as different from the published one.
enum class CellRule {
  kWithinRuns,  ///< if the published one is outside our runs, by more than a unit of its last digit
  kTwoDegrees,  ///< angles: by more than 2 degrees
  kNever        ///< shown, not compared
};

/// digits: after the point. relative: whether differences are shown in percent.
struct ExhibitColumn {
  std::string group, name;
  int digits = 2;
  CellRule rule = CellRule::kWithinRuns;
  bool relative = false;
};

struct ExhibitRow {
  std::string label;
  std::vector<ExhibitCell> cells;  ///< one a column
};

/// comparable: whether ours was measured on what the thesis measured; if not, `note` says on what.
/// repeats: whether its figures stand in other tables already, which tell how they differ.
struct ExhibitTable {
  std::string name;  ///< of its files
  std::string title = {};
  std::string row_heading = "level";
  std::vector<ExhibitColumn> columns = {};
  std::vector<ExhibitRow> rows = {};
  bool comparable = true;
  bool repeats = false;
  std::string note = {};
};

/// repeats: whether another exhibit shows it; then it is for the files alone.
struct ExhibitPicture {
  std::string name;  ///< of its file
  std::string caption;
  std::string svg;
  bool repeats = false;
};

struct Exhibit {
  std::string name;   ///< as on the command line: "table-8.5"
  std::string title;  ///< as the thesis calls it: "Table 8.5: Coarsening CRACK"
  std::vector<std::string> notes = {};
  std::vector<ExhibitTable> tables = {};
  std::vector<ExhibitPicture> pictures = {};
};

/// Whether the cell is different from the published figure by the column's rule: also where one of
/// the two is missing. False where nothing is published in the row.
bool is_beyond(const ExhibitTable& table, std::size_t row, std::size_t column);

/// The published figure subtracted from ours, in percent of it where the column is relative.
std::optional<double> difference(const ExhibitColumn& column, const ExhibitCell& cell);

/// A figure that differs, and why, as far as that is known.
struct Deviation {
  std::string exhibit, table, row, column;
  double ours = 0, published = 0;  ///< NaN where there is none
  int digits = 2;
  std::string reason;
};

/// All figures that differ, in the order of the tables, without those that repeat.
[[gnu::cold]] std::vector<Deviation> deviations(const Exhibit& exhibit);

/// The cell in the text of all tables; "-" where there is none.
[[gnu::cold]] std::string figure_text(const std::optional<double>& value, int digits);
[[gnu::cold]] std::string difference_text(const ExhibitColumn& column, const ExhibitCell& cell);

}  // namespace wellspaced
