#include "wellspaced/io/report/table_text.hpp"

#include <algorithm>
#include <charconv>

#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {

std::string decimal(double value, int digits) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

std::string right_aligned(std::string_view text, std::size_t width) {
  return concat({std::string(width - std::min(width, text.size()), ' '), text});
}

}  // namespace wellspaced
