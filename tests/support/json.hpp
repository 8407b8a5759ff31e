// Looking into what the program wrote as JSON.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "wellspaced/io/json/json_reader.hpp"

namespace wellspaced::test {

/// A value in a JSON tree, or nothing. It dies with the tree.
class JsonView {
 public:
  JsonView() = default;
  explicit JsonView(const JsonValue* value) : value_(value) {}

  JsonView operator[](std::string_view name) const {
    return JsonView(value_ == nullptr ? nullptr : value_->find(name));
  }
  bool exists() const { return value_ != nullptr; }
  bool is_null() const { return is(JsonValue::Kind::kNull); }
  bool is_true() const { return is(JsonValue::Kind::kTrue); }
  /// NaN unless it is a number.
  double number() const { return is(JsonValue::Kind::kNumber) ? value_->number : std::nan(""); }
  std::string text() const { return exists() ? value_->text : ""; }

 private:
  bool is(JsonValue::Kind kind) const { return exists() && value_->kind == kind; }

  const JsonValue* value_ = nullptr;
};

}  // namespace wellspaced::test
