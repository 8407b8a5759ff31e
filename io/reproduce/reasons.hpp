// Why figures of ours differ from published ones, as far as that is known.
#pragma once

#include <cstddef>
#include <string>

#include "wellspaced/io/reproduce/exhibit.hpp"

namespace wellspaced {

/// The reason for the difference in row `row` and column `column` of the table: one that is known
/// of the place, or that the column tells itself (the smallest angle of all runs is an extreme).
/// Returns: "not known" where it is not.
[[gnu::cold]] std::string known_reason(const ExhibitTable& table, std::size_t row,
                                       std::size_t column);

/// How lists of differences call a column: its group first.
[[gnu::cold]] std::string column_title(const ExhibitColumn& column);

}  // namespace wellspaced
