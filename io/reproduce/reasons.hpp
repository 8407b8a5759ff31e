// Why figures of ours differ from published ones, as far as that is known.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace wellspaced {

/// The reason for a difference in row `row` (from 0) and the column of that name, group first, of
/// the table of that name. Returns: "not known" where it is not.
std::string known_reason(std::string_view table, std::size_t row, std::string_view column);

}  // namespace wellspaced
