// Reading JSON into a tree, strictly and within bounds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A JSON value. Which members count depends on its kind.
struct JsonValue {
  enum class Kind { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  double number = 0;
  std::string text;
  struct Member;
  std::vector<JsonValue> items;  ///< of an array
  std::vector<Member> members;   ///< of an object, in order

  /// The member of that name, null if there is none or this is no object.
  const JsonValue* find(std::string_view name) const;
};

struct JsonValue::Member {
  std::string name;
  JsonValue value;
};

/// Parses one JSON text (RFC 8259), at most 64 levels deep. Numbers must be finite doubles; of
/// members with the same name, find() gives the first. `name` is for messages.
/// Errors: kUnreadable, naming the line. Cost: linear.
[[gnu::cold]] Result<JsonValue> parse_json(std::string_view text, const std::string& name);

}  // namespace wellspaced
