#include "wellspaced/kernel/radix_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

void expect_stable_sorted(std::vector<KeyedItem> items) {
  std::vector<KeyedItem> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const auto& a, const auto& b) { return a.key < b.key; });
  radix_sort(items);
  ASSERT_EQ(items.size(), expected.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    ASSERT_EQ(items[i].key, expected[i].key);
    ASSERT_EQ(items[i].item, expected[i].item);
  }
}

TEST(RadixSort, SortsStablyAtEverySizeAndKeyWidth) {
  Random random(1);
  for (const std::size_t size : {0, 1, 2, 255, 256, 257, 5000})
    for (const int shift : {0, 20, 40, 60}) {
      std::vector<KeyedItem> items(size);
      for (std::size_t i = 0; i < size; ++i)
        items[i] = {random.bits() >> shift, static_cast<Index>(i)};
      expect_stable_sorted(items);
    }
}

TEST(RadixSort, SortsByTheHighestDigitAlone) {
  std::vector<KeyedItem> items(1000);
  for (Index i = 0; i < 1000; ++i) items[i] = {std::uint64_t{999 - i} << 54, i};
  expect_stable_sorted(items);
}

TEST(SortKey, OrdersNumbersFromZeroToInfinity) {
  const std::vector<double> ascending = {0.0, 0x1p-1074,   0x1p-1022, 0.5,
                                         1.0, 1 + 0x1p-52, 1e300,     1 / 0.0};
  for (std::size_t i = 0; i + 1 < ascending.size(); ++i)
    EXPECT_LT(sort_key(ascending[i]), sort_key(ascending[i + 1]));
  EXPECT_EQ(sort_key(-0.0), sort_key(0.0));
}

}  // namespace
}  // namespace wellspaced
