// Where a text comes from, as its readers need to know.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// What a text is called in messages, and who is told how much of it is read.
struct TextSource {
  std::string name;
  const Progress* progress = nullptr;  ///< null: nobody; outlives the reading

  TextSource(std::string n) : name(std::move(n)) {}
  TextSource(const char* n) : name(n) {}
  TextSource(std::string n, const Progress& p) : name(std::move(n)), progress(&p) {}

  /// Whether to read on: `done` of `total` bytes or items are read.
  bool keep_going(std::uint64_t done, std::uint64_t total) const {
    return progress == nullptr || report(*progress, "read", done, total);
  }
  /// What a reader returns where it is not.
  Error cancelled() const { return {ErrorCode::kCancelled, {name, ": reading was cancelled"}}; }
};

}  // namespace wellspaced
