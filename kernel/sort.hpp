// Sorting by merges: short to compile, and equals keep their order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace wellspaced {

/// Sorts `list`, a span or what one can be made of, by `less`, by default ascending. Equals keep
/// their order, so that the result is the same with every standard library. Requires: elements are
/// default-constructible and movable. Cost: O(n log n), O(n) if sorted already; memory for up to n
/// elements more where n > 16.
template <class List, class Less = std::less<>>
void sort(List&& list, Less less = {});

/// Sorts `list` and drops what stands in it more than once. Cost: as sort().
template <class T>
void sort_unique(std::vector<T>& list) {
  sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

namespace sorting {

template <class T, class Less>
void insert_in_order(std::span<T> list, Less& less) {
  for (std::size_t i = 1; i < list.size(); ++i) {
    T moved = std::move(list[i]);
    std::size_t place = i;
    for (; place > 0 && less(moved, list[place - 1]); --place)
      list[place] = std::move(list[place - 1]);
    list[place] = std::move(moved);
  }
}

/// Merges what stands in `list` before and from `middle` on, both sorted; `left` has room for the
/// first.
template <class T, class Less>
void merge_halves(std::span<T> list, std::size_t middle, T* left, Less& less) {
  T* right = list.data() + middle;
  T* const end = list.data() + list.size();
  if (!less(*right, right[-1])) return;
  T* const left_end = std::move(list.data(), right, left);
  T* out = list.data();
  while (left != left_end && right != end) {
    const bool from_right = less(*right, *left);
    *out++ = std::move(from_right ? *right : *left);
    right += from_right;
    left += !from_right;
  }
  std::move(left, left_end, out);
}

template <class T, class Less>
void sort_by_merging(std::span<T> list, Less& less) {
  constexpr std::size_t kRun = 16;
  const std::size_t size = list.size();
  for (std::size_t first = 0; first < size; first += kRun)
    insert_in_order(list.subspan(first, std::min(kRun, size - first)), less);
  if (size <= kRun) return;
  std::vector<T> left(std::bit_floor(size - 1));
  for (std::size_t run = kRun; run < size; run *= 2)
    for (std::size_t first = 0; first + run < size; first += 2 * run)
      merge_halves(list.subspan(first, std::min(2 * run, size - first)), run, left.data(), less);
}

}  // namespace sorting

template <class List, class Less>
void sort(List&& list, Less less) {
  sorting::sort_by_merging(std::span<std::remove_reference_t<decltype(*std::data(list))>>(list),
                           less);
}

}  // namespace wellspaced
