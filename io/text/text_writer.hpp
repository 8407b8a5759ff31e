// A buffered writer of text and binary records: numbers shortest and exact, same bytes everywhere.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The shortest decimal that reads back as the same double: "0.1", "1e+22", "-0".
std::string shortest(double value);

/// Collects text in memory; where a stream stands behind it, passes it on in large pieces.
/// The first write error sticks (failed()), and all that is written after it is dropped. Where
/// `progress` says stop (phase "write"; done: bytes; total: 0), that is the error ECANCELED.
class TextWriter {
 public:
  TextWriter() = default;
  /// Requires: `stream`, unless it is null, stays open as long as the writer is used, which does
  /// not close it.
  explicit TextWriter(std::FILE* stream, Progress progress = {})
      : stream_(stream), progress_(std::move(progress)) {}

  TextWriter& operator<<(char c);
  TextWriter& operator<<(const char* text) { return *this << std::string_view(text); }
  TextWriter& operator<<(std::string_view text);
  TextWriter& operator<<(double value);
  template <std::integral T>
  requires(!std::same_as<T, char> && !std::same_as<T, bool>) TextWriter& operator<<(T value) {
    return append_integer(static_cast<std::int64_t>(value));
  }

  /// Passes what is collected on to the stream, if there is one. Returns !failed().
  bool flush();
  bool failed() const { return error_ != 0; }
  /// The errno of the first failure, or 0.
  int error() const { return error_; }
  /// What is collected and not passed on.
  const std::string& text() const { return buffer_; }

  /// Writes a line of comment, if there is any; `mark` begins comments in the format.
  void comment(std::string_view mark, std::string_view text);

 private:
  TextWriter& append_integer(std::int64_t value);
  void pass_on();

  static constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::FILE* stream_ = nullptr;
  Progress progress_;
  std::string buffer_;
  std::size_t pass_on_at_ = kPiece;
  std::uint64_t passed_ = 0;
  int error_ = 0;
};

}  // namespace wellspaced
