// Making a list a set.
#pragma once

#include <algorithm>
#include <vector>

namespace wellspaced {

/// Sorts `list` and drops what stands in it more than once. Cost: O(n log n).
template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace wellspaced
