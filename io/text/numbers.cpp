#include "wellspaced/io/text/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace wellspaced {
namespace {

constexpr std::int64_t kHuge = std::int64_t{1} << 40;

bool is_hex(std::string_view digits) {
  return digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X');
}

// from_chars of libstdc++ 12 also takes a sign or a word ("inf") behind the prefix, and a second
// sign in the exponent.
bool is_well_formed_hex(std::string_view digits) {
  if (digits.find_first_not_of("0123456789abcdefABCDEF.pP+-") != std::string_view::npos)
    return false;
  if (digits.find_first_of("+-pP") == 0) return false;
  const std::size_t sign = digits.find_first_of("+-");
  return sign == digits.find_last_of("+-");
}

// The exponent behind the letter, cut to +-kHuge.
std::int64_t exponent_value(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code == std::errc::result_out_of_range) return text[0] == '-' ? -kHuge : kHuge;
  return std::clamp(value, -kHuge, kHuge);
}

// Whether a number that is no double is too small rather than too large: decided by the place of
// its first non-zero digit, which is hundreds of places from 1 in either case.
bool is_tiny(std::string_view digits, bool hex) {
  const std::size_t mantissa_end = std::min(digits.find_first_of(hex ? "pP" : "eE"), digits.size());
  const std::string_view mantissa = digits.substr(0, mantissa_end);
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa_end));
  const auto first = static_cast<std::int64_t>(mantissa.find_first_not_of("0."));
  const std::int64_t place = point - first;  // > 0: first digit is before the point
  const std::int64_t exponent =
      mantissa_end == digits.size() ? 0 : exponent_value(digits.substr(mantissa_end + 1));
  return place * (hex ? 4 : 1) + exponent < 0;
}

// Reads digits without a sign.
ParsedNumber parse_magnitude(std::string_view digits) {
  const bool hex = is_hex(digits);
  if (hex) digits.remove_prefix(2);
  if (hex && !is_well_formed_hex(digits)) return {};
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(
      digits.data(), end, value, hex ? std::chars_format::hex : std::chars_format::general);
  if (stop != end || code == std::errc::invalid_argument) return {};
  if (code == std::errc()) return {value, NumberStatus::kOk};
  if (is_tiny(digits, hex)) return {0, NumberStatus::kOk};
  return {0, NumberStatus::kTooLarge};
}

ParsedNumber parse_fortran(std::string_view digits) {
  const std::size_t letter = digits.find_first_of("dD");
  if (letter == std::string_view::npos || is_hex(digits)) return {};
  std::string copy(digits);
  copy[letter] = 'e';
  return parse_magnitude(copy);
}

}  // namespace

ParsedNumber parse_number(std::string_view token) {
  const bool negative = !token.empty() && token[0] == '-';
  if (negative || (!token.empty() && token[0] == '+')) token.remove_prefix(1);
  if (token.empty() || token[0] == '-') return {};
  ParsedNumber number = parse_magnitude(token);
  if (number.status == NumberStatus::kMalformed) number = parse_fortran(token);
  if (negative) number.value = -number.value;
  return number;
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  std::int64_t value = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, code] = std::from_chars(token.data(), end, value);
  if (stop == end && code == std::errc()) return value;
  const ParsedNumber number = parse_number(token);
  if (number.status != NumberStatus::kOk || !(std::abs(number.value) <= 0x1p53)) return {};
  if (number.value != std::trunc(number.value)) return {};
  return static_cast<std::int64_t>(number.value);
}

}  // namespace wellspaced
