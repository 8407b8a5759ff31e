#include "wellspaced/io/json/json_reader.hpp"
#include "wellspaced/kernel/concat.hpp"

#include <algorithm>
#include <charconv>

namespace wellspaced {
namespace {

constexpr int kDeepest = 64;

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) return add(0xC0 | code >> 6), add(0x80 | (code & 0x3F));
  if (code < 0x10000)
    return add(0xE0 | code >> 12), add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
  add(0xF0 | code >> 18), add(0x80 | (code >> 12 & 0x3F));
  add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
}

// A recursive descent; each function returns false at the first complaint.
class JsonParser {
 public:
  explicit JsonParser(std::string_view text) : text_(text) {}

  bool parse(JsonValue& value) {
    skip_blanks();
    if (!parse_value(value, 0)) return false;
    skip_blanks();
    return at_ == text_.size();
  }

  std::size_t line() const {
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + at_, '\n'));
  }

 private:
  using Kind = JsonValue::Kind;

  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_blanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string::npos)
      ++at_;
  }

  bool take(char c) {
    skip_blanks();
    if (next() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }

  bool take_word(std::string_view word, Kind kind, JsonValue& value) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    value.kind = kind;
    return true;
  }

  bool parse_value(JsonValue& value, int depth) {
    if (depth > kDeepest) return false;
    skip_blanks();
    switch (next()) {
      case '{':
        return parse_object(value, depth);
      case '[':
        return parse_array(value, depth);
      case '"':
        value.kind = Kind::kString;
        return parse_string(value.text);
      case 't':
        return take_word("true", Kind::kTrue, value);
      case 'f':
        return take_word("false", Kind::kFalse, value);
      case 'n':
        return take_word("null", Kind::kNull, value);
      default:
        return parse_number(value);
    }
  }

  bool parse_object(JsonValue& value, int depth) {
    value.kind = Kind::kObject;
    take('{');
    if (take('}')) return true;
    do {
      auto& [name, member] = value.members.emplace_back();
      skip_blanks();
      if (!parse_string(name) || !take(':') || !parse_value(member, depth + 1)) return false;
    } while (take(','));
    return take('}');
  }

  bool parse_array(JsonValue& value, int depth) {
    value.kind = Kind::kArray;
    take('[');
    if (take(']')) return true;
    do {
      if (!parse_value(value.items.emplace_back(), depth + 1)) return false;
    } while (take(','));
    return take(']');
  }

  bool skip_digits() {
    const std::size_t start = at_;
    while (next() >= '0' && next() <= '9') ++at_;
    return at_ > start;
  }

  // Checks the grammar, which is narrower than that of from_chars.
  bool parse_number(JsonValue& value) {
    value.kind = Kind::kNumber;
    const std::size_t start = at_;
    if (next() == '-') ++at_;
    const bool leading_zero = next() == '0';
    const std::size_t digits = at_;
    if (!skip_digits() || (leading_zero && at_ > digits + 1)) return false;
    if (next() == '.' && (++at_, !skip_digits())) return false;
    if (next() == 'e' || next() == 'E') {
      ++at_;
      if (next() == '+' || next() == '-') ++at_;
      if (!skip_digits()) return false;
    }
    const auto result = std::from_chars(text_.data() + start, text_.data() + at_, value.number);
    return result.ec == std::errc();
  }

  bool parse_string(std::string& out) {
    if (next() != '"') return false;
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') return ++at_, true;
      if (static_cast<unsigned char>(c) < 0x20) return false;
      if (c != '\\') out += c;
      if (c == '\\' && !parse_escape(out)) return false;
    }
    return false;
  }

  // Ends on the last character of the escape.
  bool parse_escape(std::string& out) {
    constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
    ++at_;
    if (next() == 'u') return parse_code_point(out);
    const auto found = kLetters.find(next());
    if (at_ == text_.size() || found == std::string_view::npos) return false;
    out += kMeanings[found];
    return true;
  }

  bool parse_code_point(std::string& out) {
    std::uint32_t code = 0;
    if (!parse_hex(code)) return false;
    if (code >= 0xD800 && code < 0xDC00 && text_.substr(at_ + 1, 2) == "\\u") {
      std::uint32_t low = 0;
      at_ += 2;
      if (!parse_hex(low) || low < 0xDC00 || low > 0xDFFF) return false;
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    if (code >= 0xD800 && code < 0xE000) return false;
    append_utf8(out, code);
    return true;
  }

  // The four digits after the 'u' at which the parser stands; ends on the last.
  bool parse_hex(std::uint32_t& code) {
    const std::string_view digits = text_.substr(at_ + 1, 4);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    at_ += 4;
    return digits.size() == 4 && result.ptr == digits.data() + 4;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  for (const auto& [key, member] : members)
    if (key == name) return &member;
  return nullptr;
}

Result<JsonValue> parse_json(std::string_view text, const std::string& name) {
  JsonValue value;
  JsonParser parser(text);
  if (parser.parse(value)) return value;
  return Error{ErrorCode::kUnreadable, {name, ":", parser.line(), ": this is no JSON"}};
}

}  // namespace wellspaced
