#include "wellspaced/kernel/radix_sort.hpp"

#include <algorithm>
#include <array>

namespace wellspaced {
namespace {

constexpr int kRadixBits = 11;
constexpr int kDigits = 6;  // 66 bits >= 64
constexpr std::size_t kBuckets = std::size_t{1} << kRadixBits;
constexpr std::size_t kFewItems = 256;  // below this a comparison sort is faster

using Histogram = std::array<std::size_t, kBuckets>;

std::size_t digit(std::uint64_t key, int d) { return (key >> (d * kRadixBits)) & (kBuckets - 1); }

// Turns counts into the position at which each bucket starts.
void accumulate(Histogram& histogram) {
  std::size_t sum = 0;
  for (std::size_t& count : histogram) {
    const std::size_t start = sum;
    sum += count;
    count = start;
  }
}

void small_sort(std::vector<KeyedItem>& items) {
  std::stable_sort(items.begin(), items.end(),
                   [](const KeyedItem& a, const KeyedItem& b) { return a.key < b.key; });
}

}  // namespace

void radix_sort(std::vector<KeyedItem>& items) {
  if (items.size() < kFewItems) return small_sort(items);
  std::vector<Histogram> histograms(kDigits, Histogram{});
  for (const KeyedItem& item : items)
    for (int d = 0; d < kDigits; ++d) ++histograms[d][digit(item.key, d)];

  std::vector<KeyedItem> sorted(items.size());
  for (int d = 0; d < kDigits; ++d) {
    Histogram& position = histograms[d];
    if (position[digit(items.front().key, d)] == items.size()) continue;
    accumulate(position);
    for (const KeyedItem& item : items) sorted[position[digit(item.key, d)]++] = item;
    items.swap(sorted);
  }
}

}  // namespace wellspaced
