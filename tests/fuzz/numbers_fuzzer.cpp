// parse_number against strtod, parse_integer, and numbers through shortest() and back.
#include <bit>
#include <cmath>

#include "tests/fuzz/texts.hpp"
#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/io/text/numbers.hpp"

using namespace wellspaced;

namespace {

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// What strtod reads from all of `text`; false if that is not all of it.
bool reference(const std::string& text, double& value) {
  if (text.empty() || std::string_view(" \t\n\v\f\r").find(text[0]) != std::string_view::npos)
    return false;
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size();
}

void compare(const std::string& text) {
  double expected = 0;
  const bool legal = reference(text, expected);
  const ParsedNumber number = parse_number(text);
  const bool fortran = text.find_first_of("dD") != std::string::npos;
  if (!legal) {
    fuzz::require(number.status == NumberStatus::kMalformed || fortran, "strtod refuses it too");
  } else if (std::isnan(expected)) {
    fuzz::require(number.status == NumberStatus::kMalformed || std::isnan(number.value), "nan");
  } else if (std::isinf(expected) && text.find_first_of("iI") == std::string::npos) {
    fuzz::require(number.status == NumberStatus::kTooLarge, "overflow is an error");
  } else {
    fuzz::require(number.status == NumberStatus::kOk, "what strtod reads is a number");
    fuzz::require(bits(number.value) == bits(expected), "the same double as strtod's");
    fuzz::require(std::isinf(expected) ||
                      bits(parse_number(shortest(number.value)).value) == bits(number.value),
                  "shortest() reads back");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  if (text.find('\0') == std::string::npos) compare(text);
  parse_integer(text);
  json_string(text);
  return 0;
}
