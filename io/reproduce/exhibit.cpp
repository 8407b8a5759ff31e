#include "wellspaced/io/reproduce/exhibit.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/io/reproduce/reasons.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr double kAngleTolerance = 2;

// A unit of the last digit that is printed.
double unit_of(const ExhibitColumn& column) {
  double unit = 1;
  for (int i = 0; i < column.digits; ++i) unit /= 10;
  return unit;
}

bool is_outside(const ExhibitColumn& column, const ExhibitCell& cell) {
  const double published = *cell.published, unit = unit_of(column);
  const double low = cell.low.value_or(*cell.ours), high = cell.high.value_or(*cell.ours);
  return published < low - unit || published > high + unit;
}

// Where a whole row is missing on one side, its first cell alone says so.
bool is_alone(const ExhibitRow& row, std::size_t column) {
  const auto has_ours = [](const ExhibitCell& cell) { return cell.ours.has_value(); };
  const auto has_published = [](const ExhibitCell& cell) { return cell.published.has_value(); };
  const bool whole_row =
      std::ranges::none_of(row.cells, has_ours) || std::ranges::none_of(row.cells, has_published);
  return !whole_row || column == 0;
}

Deviation deviation_at(const Exhibit& exhibit, const ExhibitTable& table, std::size_t row,
                       std::size_t column) {
  const ExhibitColumn& head = table.columns[column];
  const ExhibitCell& cell = table.rows[row].cells[column];
  Deviation deviation;
  deviation.exhibit = exhibit.name;
  deviation.table = table.name;
  deviation.row = concat({table.row_heading, ' ', table.rows[row].label});
  deviation.column = column_title(head);
  deviation.ours = cell.ours.value_or(std::nan(""));
  deviation.published = cell.published.value_or(std::nan(""));
  deviation.digits = head.digits;
  deviation.reason = known_reason(table, row, column);
  return deviation;
}

}  // namespace

bool is_beyond(const ExhibitTable& table, std::size_t row, std::size_t column) {
  const ExhibitCell& cell = table.rows[row].cells[column];
  const ExhibitColumn& head = table.columns[column];
  if (!table.comparable || head.rule == CellRule::kNever) return false;
  if (!cell.ours && !cell.published) return false;
  if (!cell.ours || !cell.published) return is_alone(table.rows[row], column);
  if (head.rule == CellRule::kTwoDegrees)
    return std::fabs(*cell.ours - *cell.published) > kAngleTolerance;
  return is_outside(head, cell);
}

std::optional<double> difference(const ExhibitColumn& column, const ExhibitCell& cell) {
  if (!cell.ours || !cell.published) return std::nullopt;
  const double absolute = *cell.ours - *cell.published;
  if (!column.relative) return absolute;
  if (*cell.published == 0) return std::nullopt;
  return 100 * absolute / *cell.published;
}

std::vector<Deviation> deviations(const Exhibit& exhibit) {
  std::vector<Deviation> found;
  for (const ExhibitTable& table : exhibit.tables) {
    if (table.repeats) continue;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      for (std::size_t column = 0; column < table.columns.size(); ++column)
        if (is_beyond(table, row, column))
          found.push_back(deviation_at(exhibit, table, row, column));
  }
  return found;
}

std::string figure_text(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? decimal(*value, digits) : "-";
}

std::string difference_text(const ExhibitColumn& column, const ExhibitCell& cell) {
  const auto value = difference(column, cell);
  if (!value) return "-";
  const std::string sign = *value < 0 ? "" : "+";
  return column.relative ? concat({sign, decimal(*value, 1), '%'})
                         : concat({sign, decimal(*value, column.digits)});
}

}  // namespace wellspaced
