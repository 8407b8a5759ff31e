// Sorting items by 64-bit keys without comparisons.
#pragma once

#include <cstdint>
#include <vector>

#include "wellspaced/kernel/bit_cast.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

struct KeyedItem {
  std::uint64_t key = 0;
  Index item = 0;
};

/// Sorts by key, equal keys in their given order. Digits that all keys share cost nothing.
/// Cost: linear; as much memory again.
void radix_sort(std::vector<KeyedItem>& items);

/// A key that sorts as the number does. Requires: value >= 0 (-0 included), no NaN.
inline std::uint64_t sort_key(double value) { return bit_cast<std::uint64_t>(value + 0.0); }

}  // namespace wellspaced
