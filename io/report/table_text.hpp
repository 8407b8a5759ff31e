// Cells of the tables for the terminal.
#pragma once

#include <algorithm>
#include <charconv>
#include <string>

#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {

/// A number with so many digits after the point.
inline std::string decimal(double value, int digits = 2) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

inline std::string right_aligned(const std::string& text, std::size_t width) {
  return concat({std::string(width - std::min(width, text.size()), ' '), text});
}

}  // namespace wellspaced
