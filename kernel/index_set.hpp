// A small set of numbers.
#pragma once

#include <bit>
#include <cstddef>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A set of numbers other than kNoIndex, by open addressing: what was visited in a walk over a few
/// elements of a large mesh. It is never iterated over, so its order shows nowhere.
class IndexSet {
 public:
  /// Adds a number. Returns whether it is new.
  bool insert(Index number) {
    if (2 * ++size_ > slots_.size()) grow();
    Index& slot = slots_[place_of(number)];
    const bool is_new = slot == kNoIndex;
    slot = number;
    size_ -= !is_new;
    return is_new;
  }

  bool contains(Index number) const {
    return !slots_.empty() && slots_[place_of(number)] == number;
  }

 private:
  std::size_t place_of(Index number) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = number * 0x9E3779B1u & mask;
    while (slots_[i] != kNoIndex && slots_[i] != number) i = (i + 1) & mask;
    return i;
  }

  void grow() {
    std::vector<Index> old(std::bit_ceil(4 * size_ + 60), kNoIndex);
    old.swap(slots_);
    for (const Index number : old)
      if (number != kNoIndex) slots_[place_of(number)] = number;
  }

  std::vector<Index> slots_;
  std::size_t size_ = 0;
};

}  // namespace wellspaced
