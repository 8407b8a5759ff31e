// Numbers as text: exact in both directions, whatever the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace wellspaced {

enum class NumberStatus {
  kOk,
  kMalformed,  ///< not a number
  kTooLarge    ///< beyond the largest finite double
};

struct ParsedNumber {
  double value = 0;
  NumberStatus status = NumberStatus::kMalformed;
};

/// Reads one number: decimal, C hexadecimal ("0x1.8p-3"), or with Fortran's D exponent; a leading
/// sign, + included, is legal.
/// Returns: the nearest double, ties to even. What is too small becomes the nearest subnormal or a
/// zero of its sign. "nan" and "inf" are read as such: whether they are legal the caller decides.
/// Errors: kMalformed unless the whole of `token` is a number; kTooLarge on overflow.
/// Cost: linear in the length of the token.
ParsedNumber parse_number(std::string_view token);

/// Reads one integer; "7", "+7" and "7.0" are the same one.
/// Returns: nothing if `token` is no integer, or one beyond 2^53 that is not written plainly.
std::optional<std::int64_t> parse_integer(std::string_view token);

}  // namespace wellspaced
