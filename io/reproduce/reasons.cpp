#include "wellspaced/io/reproduce/reasons.hpp"

namespace wellspaced {
namespace {

// The rows first to last of the columns whose names contain `column`; empty: all columns.
struct Reason {
  std::string_view table;
  std::size_t first, last;
  std::string_view column;
  std::string_view text;
};

constexpr Reason kReasons[] = {
    {"none", 0, 0, "", ""},
};

}  // namespace

std::string known_reason(std::string_view table, std::size_t row, std::string_view column) {
  for (const Reason& reason : kReasons)
    if (reason.table == table && reason.first <= row && row <= reason.last &&
        column.find(reason.column) != column.npos)
      return std::string(reason.text);
  return "not known";
}

}  // namespace wellspaced
