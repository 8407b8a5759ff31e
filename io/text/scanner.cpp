#include "wellspaced/io/text/scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "wellspaced/io/text/numbers.hpp"

namespace wellspaced {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

void skip_blanks(std::string_view& text) {
  std::size_t i = 0;
  while (i < text.size() && is_blank(text[i])) ++i;
  text.remove_prefix(i);
}

std::string_view take_token(std::string_view& text) {
  std::size_t i = 0;
  while (i < text.size() && !is_blank(text[i])) ++i;
  const std::string_view token = text.substr(0, i);
  text.remove_prefix(i);
  return token;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

}  // namespace

std::string in_quotes(std::string_view token) {
  constexpr std::size_t kLongest = 24;
  constexpr char kDigits[] = "0123456789abcdef";
  std::string result = "'";
  for (const char c : token.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) {
      result += c;
    } else {
      result += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return result + (token.size() > kLongest ? "...'" : "'");
}

Scanner::Scanner(std::string_view text, std::string file) : file_(std::move(file)), rest_(text) {
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    rest_.remove_prefix(kByteOrderMark.size());
}

bool Scanner::next_line() {
  line_ = {};
  while (ok() && !rest_.empty()) {
    const std::string_view line = take_line(rest_);
    ++line_number_;
    line_ = line.substr(0, line.find('#'));
    if (more()) return true;
  }
  return false;
}

bool Scanner::require_line(std::string_view what) {
  if (next_line()) return true;
  fail(ErrorCode::kUnreadable, "the file ends where " + std::string(what) + " should follow");
  return false;
}

bool Scanner::more() {
  skip_blanks(line_);
  return !line_.empty();
}

std::size_t Scanner::count_fields() const {
  std::string_view rest = line_;
  std::size_t count = 0;
  for (skip_blanks(rest); !rest.empty(); skip_blanks(rest), ++count) take_token(rest);
  return count;
}

std::string_view Scanner::field() {
  skip_blanks(line_);
  return take_token(line_);
}

std::string_view Scanner::required_field(std::string_view what) {
  const std::string_view token = field();
  if (token.empty()) fail(ErrorCode::kUnreadable, "the " + std::string(what) + " is missing");
  return ok() ? token : std::string_view("0");
}

double Scanner::number(std::string_view what) {
  const std::string_view token = required_field(what);
  const auto [value, status] = parse_number(token);
  if (status == NumberStatus::kMalformed)
    fail_field(ErrorCode::kUnreadable, what, token, "is not a number");
  if (status == NumberStatus::kTooLarge)
    fail_field(ErrorCode::kUnreadable, what, token, "is too large for a double");
  if (!std::isfinite(value)) fail_field(ErrorCode::kInvalidGeometry, what, token, "is not finite");
  return ok() ? value : 0;
}

std::int64_t Scanner::integer(std::string_view what) {
  const std::string_view token = required_field(what);
  const auto value = parse_integer(token);
  if (!value) fail_field(ErrorCode::kUnreadable, what, token, "is not an integer");
  return ok() ? *value : 0;
}

std::int64_t Scanner::integer_or(std::int64_t otherwise, std::string_view what) {
  return more() ? integer(what) : otherwise;
}

int Scanner::marker() {
  const std::int64_t value = integer("marker");
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    fail(ErrorCode::kUnreadable, "the marker " + std::to_string(value) + " is beyond 32 bits");
  return ok() ? static_cast<int>(value) : 0;
}

void Scanner::skip_fields(std::size_t count) {
  while (count-- > 0 && more()) field();
}

bool Scanner::has_room_for(std::uint64_t records, std::uint64_t fields, std::string_view what) {
  // A field takes a digit and a blank or newline; the last newline may be missing.
  const std::uint64_t most_fields = (rest_.size() + 1) / 2;
  if (fields == 0 || records <= most_fields / fields) return ok();
  fail(ErrorCode::kUnreadable, "the file is too short for the " + std::to_string(records) + " " +
                                   std::string(what) + " that this line announces");
  return false;
}

void Scanner::fail(ErrorCode code, std::string_view message) {
  if (error_) return;
  const std::string where = line_number_ == 0 ? file_ : file_ + ":" + std::to_string(line_number_);
  error_ = Error{code, where + ": " + std::string(message), {}};
}

void Scanner::fail_field(ErrorCode code, std::string_view what, std::string_view token,
                         std::string_view complaint) {
  fail(code, "the " + std::string(what) + " " + in_quotes(token) + " " + std::string(complaint));
}

}  // namespace wellspaced
