// Writing JSON: one pass, deterministic, always well-formed UTF-8.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {

/// Builds one JSON text. Numbers are the shortest that read back the same; NaN and infinities,
/// which JSON lacks, become null; bytes that are no UTF-8 become U+FFFD.
///
///   JsonWriter json;
///   json.begin_object().field("nodes", 5).key("list").begin_array().value(1.5).end_array();
///   json.end_object();
///
/// Requires: begin and end are balanced, and each value in an object follows a key.
class JsonWriter {
 public:
  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }
  JsonWriter& key(std::string_view name);

  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(double number);
  JsonWriter& value(std::same_as<bool> auto truth) { return literal(truth ? "true" : "false"); }
  template <std::integral T>
  requires(!std::same_as<T, bool>) JsonWriter& value(T number) { return integer(number); }
  JsonWriter& null() { return literal("null"); }
  /// A value that is JSON already.
  JsonWriter& raw(std::string_view json) { return literal(json); }

  template <class T>
  JsonWriter& field(std::string_view name, const T& content) {
    return key(name).value(content);
  }

  /// The text so far.
  const std::string& text() const { return text_; }

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  JsonWriter& literal(std::string_view json);
  JsonWriter& integer(TextPiece number);
  void separate();

  std::string text_;
  bool first_ = true;  // nothing stands yet before the next value at this depth
};

/// `text` as a JSON string, quotes included.
std::string json_string(std::string_view text);

}  // namespace wellspaced
