// Numbers as bytes in a given order, whatever the machine's own.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "wellspaced/kernel/bit_cast.hpp"

namespace wellspaced {

/// Appends the `size` bytes of a number at `number`, which stand in the machine's order, in the
/// order `order`.
void append_in_order(std::string& bytes, const void* number, std::size_t size, std::endian order);

/// Appends the bytes of `value` in the order `order`.
template <class T>
void append_bytes(std::string& bytes, T value, std::endian order = std::endian::little) {
  append_in_order(bytes, &value, sizeof(T), order);
}

/// The value of the bytes from `offset` on. Requires: sizeof(T) bytes are there.
template <class T>
T read_bytes(std::string_view bytes, std::size_t offset, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data() + offset, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return bit_cast<T>(raw);
}

}  // namespace wellspaced
