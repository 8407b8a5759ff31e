// Cells of the tables for the terminal.
#pragma once

#include <string>
#include <string_view>

namespace wellspaced {

/// A number with so many digits after the point.
[[gnu::cold]] std::string decimal(double value, int digits = 2);

[[gnu::cold]] std::string right_aligned(std::string_view text, std::size_t width);

}  // namespace wellspaced
