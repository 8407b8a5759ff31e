#include "wellspaced/algorithms/audit/transfer_audit.hpp"

#include <algorithm>
#include <cmath>

namespace wellspaced::audit {
namespace {

bool has_shape(const SparseMatrix& p, std::span<const Index> parent) {
  return p.columns == parent.size() && !p.first.empty() && p.first.front() == 0 &&
         std::ranges::is_sorted(p.first) && p.first.back() == p.column.size() &&
         p.value.size() == p.column.size() &&
         std::ranges::all_of(parent, [&](Index v) { return v < p.rows(); });
}

bool has_columns(std::span<const Index> row, Index columns) {
  return std::ranges::adjacent_find(row, std::greater_equal<>()) == row.end() &&
         (row.empty() || row.back() < columns);
}

bool is_weight(double value) { return value >= 0 && std::isfinite(value); }

bool adds_up_to_one(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return std::fabs(sum - 1) <= 0x1p-52;
}

bool is_unit(std::span<const Index> row, std::span<const double> values, Index column) {
  return row.size() == 1 && row[0] == column && values[0] == 1;
}

template <class Holds>
void check_rows(Report& report, std::string_view name, const SparseMatrix& p, Holds holds) {
  Check& check = report.add_required_check(name, Item::kNode);
  for (Index i = 0; i < p.rows(); ++i)
    if (!holds(p.row(i), p.row_values(i))) check.violate({i});
}

}  // namespace

Report audit_transfer(const SparseMatrix& p, std::span<const Index> parent) {
  using Columns = std::span<const Index>;
  using Values = std::span<const double>;
  Report report;
  Check& shape = report.add_required_check("transfer_shape", Item::kNone);
  if (!has_shape(p, parent)) {
    shape.violate({});
    return report;
  }
  check_rows(report, "transfer_columns", p,
             [&](Columns row, Values) { return has_columns(row, p.columns); });
  check_rows(report, "transfer_weights", p,
             [](Columns, Values values) { return std::ranges::all_of(values, is_weight); });
  check_rows(report, "transfer_row_sums", p,
             [](Columns, Values values) { return adds_up_to_one(values); });
  Check& rank = report.add_required_check("transfer_rank", Item::kNode);
  for (Index c = 0; c < parent.size(); ++c)
    if (!is_unit(p.row(parent[c]), p.row_values(parent[c]), c)) rank.violate({parent[c]});

  std::size_t longest = 0;
  for (Index i = 0; i < p.rows(); ++i) longest = std::max(longest, p.row(i).size());
  report.add_measure("transfer_entries", static_cast<double>(p.entries()));
  report.add_measure("transfer_row_max", static_cast<double>(longest));
  return report;
}

}  // namespace wellspaced::audit
