#include "wellspaced/io/text/scanner.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "wellspaced/io/text/numbers.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr std::uint64_t kLinesAReport = 1 << 13;  // lines
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c, char another) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == another;
}

void skip_blanks(std::string_view& text, char another) {
  std::size_t i = 0;
  while (i < text.size() && is_blank(text[i], another)) ++i;
  text.remove_prefix(i);
}

std::string_view take_token(std::string_view& text, char another) {
  std::size_t i = 0;
  while (i < text.size() && !is_blank(text[i], another)) ++i;
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
  return concat({result, token.size() > kLongest ? "...'" : "'"});
}

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  return result;
}

Scanner::Scanner(std::string_view text, const TextSource& source, ScanRules rules)
    : source_(source), rules_(rules), size_(text.size()), rest_(text) {
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    rest_.remove_prefix(kByteOrderMark.size());
}

bool Scanner::next_line_or_empty() {
  line_ = {};
  if (!ok() || rest_.empty()) return false;
  if (++line_number_ % kLinesAReport == 0) report_place();
  line_ = take_line(rest_);
  const std::size_t comment =
      rules_.comment == 0 ? std::string_view::npos : line_.find(rules_.comment);
  has_comment_ = comment != std::string_view::npos;
  line_ = line_.substr(0, comment);
  return true;
}

// What comes next is read all the same: it is the last.
void Scanner::report_place() {
  if (!error_ && !source_.keep_going(size_ - rest_.size(), size_)) error_ = source_.cancelled();
}

bool Scanner::next_line() {
  while (next_line_or_empty())
    if (more_on_line()) return true;
  return false;
}

bool Scanner::require_line(std::string_view what) {
  if (next_line()) return true;
  fail(ErrorCode::kUnreadable, {"the file ends where ", what, " should follow"});
  return false;
}

bool Scanner::next_record(Index count, std::string_view what) {
  if (next_line()) return true;
  fail(ErrorCode::kUnreadable, {"the file ends before its ", count, " ", what, " do"});
  return false;
}

bool Scanner::more_on_line() {
  skip_blanks(line_, rules_.blank);
  return !line_.empty();
}

bool Scanner::more() { return more_on_line() || (rules_.across_lines && next_line()); }

std::size_t Scanner::count_fields() const {
  std::string_view rest = line_;
  std::size_t count = 0;
  for (skip_blanks(rest, rules_.blank); !rest.empty(); skip_blanks(rest, rules_.blank), ++count)
    take_token(rest, rules_.blank);
  return count;
}

std::string_view Scanner::field() {
  if (!more()) return {};
  return take_token(line_, rules_.blank);
}

std::string_view Scanner::required_field(std::string_view what) {
  const std::string_view token = field();
  if (token.empty()) fail(ErrorCode::kUnreadable, {"the ", what, " is missing"});
  return ok() ? token : std::string_view("0");
}

double Scanner::number(std::string_view what) {
  const std::string_view token = required_field(what);
  const double value = to_number(token, what);
  if (!std::isfinite(value)) fail_field(ErrorCode::kInvalidGeometry, what, token, "is not finite");
  return ok() ? value : 0;
}

double Scanner::any_number(std::string_view what) { return to_number(required_field(what), what); }

double Scanner::to_number(std::string_view token, std::string_view what) {
  const auto [value, status] = parse_number(token);
  if (status == NumberStatus::kMalformed)
    fail_field(ErrorCode::kUnreadable, what, token, "is not a number");
  if (status == NumberStatus::kTooLarge)
    fail_field(ErrorCode::kUnreadable, what, token, "is too large for a double");
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
    fail(ErrorCode::kUnreadable, {"the marker ", value, " is beyond 32 bits"});
  return ok() ? static_cast<int>(value) : 0;
}

std::string_view Scanner::word(std::string_view what) { return required_field(what); }

std::string_view Scanner::rest_of_line() {
  skip_blanks(line_, rules_.blank);
  std::string_view text = std::exchange(line_, {});
  while (!text.empty() && is_blank(text.back(), rules_.blank)) text.remove_suffix(1);
  return text;
}

std::string_view Scanner::bytes_after_line(std::uint64_t count, std::string_view what) {
  if (count > rest_.size()) {
    fail(ErrorCode::kUnreadable, {"the file ends within the ", what});
    return {};
  }
  report_place();
  line_ = {};
  const std::string_view bytes = rest_.substr(0, static_cast<std::size_t>(count));
  rest_.remove_prefix(bytes.size());
  return bytes;
}

Index Scanner::count(std::string_view what, std::uint64_t fields) {
  const std::int64_t value = integer(concat({"number of ", what}));
  if (value < 0) fail(ErrorCode::kUnreadable, {"the number of ", what, " is negative"});
  if (!ok() || !has_room_for(static_cast<std::uint64_t>(value), fields, what)) return 0;
  if (value >= kNoIndex) fail(ErrorCode::kLimit, {"more than 4294967294 ", what});
  return ok() ? static_cast<Index>(value) : 0;
}

Index Scanner::point(std::size_t points, Index base) {
  const std::int64_t number = integer("point number");
  const auto count = static_cast<std::int64_t>(points);
  if (number >= base && number - base < count) return static_cast<Index>(number - base);
  const std::string range =
      count == 0 ? "there are none"
                 : concat({"they are numbered from ", base, " to ", base + count - 1});
  fail(ErrorCode::kInvalidGeometry, {"point ", number, " is not among the points: ", range});
  return 0;
}

void Scanner::skip_fields(std::size_t count) {
  while (count-- > 0 && more()) field();
}

bool Scanner::has_room_for(std::uint64_t records, std::uint64_t fields, std::string_view what) {
  // A field takes a digit and a blank or newline; the last newline may be missing.
  const std::size_t here = rules_.across_lines ? line_.size() : 0;
  const std::uint64_t most_fields = (rest_.size() + here + 1) / 2;
  if (fields == 0 || records <= most_fields / fields) return ok();
  fail(ErrorCode::kUnreadable,
       {"the file is too short for the ", records, " ", what, " that this line announces"});
  return false;
}

void Scanner::fail(ErrorCode code, std::initializer_list<TextPiece> message) {
  if (error_) return;
  std::string line = file();
  if (line_number_ != 0) append(line, {":", line_number_});
  line += ": ";
  append(line, message);
  error_ = Error{code, line};
}

void Scanner::fail_field(ErrorCode code, std::string_view what, std::string_view token,
                         std::string_view complaint) {
  fail(code, {"the ", what, " ", in_quotes(token), " ", complaint});
}

}  // namespace wellspaced
