// What the fuzzers of readers share.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/io/text/text_writer.hpp"

namespace wellspaced::fuzz {

/// Stops the fuzzer where a property of a reader or writer fails.
inline void require(bool good, const char* property) {
  if (good) return;
  std::fprintf(stderr, "property violated: %s\n", property);
  std::abort();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// `text` cut at each byte 0xFF, which no text file holds.
inline std::vector<std::string_view> parts(std::string_view text) {
  std::vector<std::string_view> result;
  for (;;) {
    const std::size_t cut = text.find('\xFF');
    result.push_back(text.substr(0, cut));
    if (cut == std::string_view::npos) return result;
    text.remove_prefix(cut + 1);
  }
}

template <class Write, class... Rest>
std::string written(Write write, const Rest&... rest) {
  TextWriter out;
  write(out, rest...);
  return out.text();
}

}  // namespace wellspaced::fuzz
