// A small JSON reader, so that tests can check what the program writes.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wellspaced::test {

struct Json {
  enum class Kind { kNull, kBool, kNumber, kString, kArray, kObject } kind = Kind::kNull;
  bool truth = false;
  double number = 0;
  std::string text;
  std::vector<Json> elements;
  std::map<std::string, Json> members;

  bool is_null() const { return kind == Kind::kNull; }
  bool has(const std::string& name) const { return members.count(name) != 0; }
  /// A member, null if there is none.
  const Json& operator[](const std::string& name) const {
    static const Json kNone;
    const auto found = members.find(name);
    return found == members.end() ? kNone : found->second;
  }
};

/// Reads strict JSON (of \u escapes only those below U+0080).
class JsonReader {
 public:
  /// Nothing unless the whole of `text` is one JSON value.
  static std::optional<Json> read(std::string_view text) {
    JsonReader reader(text);
    Json json = reader.value(0);
    reader.skip_blanks();
    if (reader.failed_ || !reader.rest_.empty()) return {};
    return json;
  }

 private:
  explicit JsonReader(std::string_view text) : rest_(text) {}

  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  }
  bool take(std::string_view word) {
    if (rest_.substr(0, word.size()) != word) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  bool take_mark(char mark) {
    skip_blanks();
    return take(std::string_view(&mark, 1));
  }
  void require(bool good) { failed_ = failed_ || !good; }

  Json value(int depth) {
    Json json;
    skip_blanks();
    if (depth > 100 || rest_.empty()) {
      failed_ = true;
    } else if (take("null")) {
    } else if (take("true")) {
      json.kind = Json::Kind::kBool, json.truth = true;
    } else if (take("false")) {
      json.kind = Json::Kind::kBool;
    } else if (rest_[0] == '"') {
      json.kind = Json::Kind::kString, json.text = string();
    } else if (take("[")) {
      json.kind = Json::Kind::kArray, read_elements(json, depth);
    } else if (take("{")) {
      json.kind = Json::Kind::kObject, read_members(json, depth);
    } else {
      json.kind = Json::Kind::kNumber, json.number = read_number();
    }
    return json;
  }

  void read_elements(Json& json, int depth) {
    if (take_mark(']')) return;
    do json.elements.push_back(value(depth + 1));
    while (!failed_ && take_mark(','));
    require(take_mark(']'));
  }

  void read_members(Json& json, int depth) {
    if (take_mark('}')) return;
    do {
      skip_blanks();
      const std::string name = string();
      require(take_mark(':'));
      require(json.members.emplace(name, value(depth + 1)).second);
    } while (!failed_ && take_mark(','));
    require(take_mark('}'));
  }

  double read_number() {
    const std::string number(rest_.substr(0, rest_.find_first_not_of("+-.0123456789eE")));
    require(!number.empty() && (number[0] == '-' || (number[0] >= '0' && number[0] <= '9')));
    rest_.remove_prefix(number.size());
    return std::strtod(number.c_str(), nullptr);
  }

  std::string string() {
    std::string text;
    require(take("\""));
    while (!failed_ && !take("\"")) {
      require(!rest_.empty());
      if (failed_) break;
      text += take("\\") ? escaped() : rest_[0];
      if (!rest_.empty()) rest_.remove_prefix(1);
    }
    return text;
  }

  // The character of the escape that `rest_` begins with; leaves its last byte there.
  char escaped() {
    const std::size_t known = std::string_view("\"\\/bfnrt").find(rest_.substr(0, 1));
    if (!rest_.empty() && known != std::string_view::npos) return "\"\\/\b\f\n\r\t"[known];
    require(rest_.size() >= 5 && rest_[0] == 'u');
    if (failed_) return '?';
    const std::string digits(rest_.substr(1, 4));
    rest_.remove_prefix(4);
    return static_cast<char>(std::strtol(digits.c_str(), nullptr, 16));
  }

  std::string_view rest_;
  bool failed_ = false;
};

}  // namespace wellspaced::test
