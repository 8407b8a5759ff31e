#include "wellspaced/kernel/pairing_heap.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

TEST(PairingHeap, PopsBySmallestKeyAndEqualKeysByLowerItem) {
  PairingHeap heap(6);
  heap.push(4, 2.0);
  heap.push(1, 2.0);
  heap.push(3, 1.0);
  heap.push(0, 5.0);
  EXPECT_EQ(heap.pop(), 3u);
  EXPECT_EQ(heap.pop(), 1u);
  EXPECT_EQ(heap.pop(), 4u);
  EXPECT_EQ(heap.pop(), 0u);
  EXPECT_TRUE(heap.empty());
}

TEST(PairingHeap, TakesAnItemBackAfterItWasPopped) {
  PairingHeap heap(1);
  heap.push(0, 1.0);
  heap.pop();
  EXPECT_FALSE(heap.contains(0));
  heap.push(0, 3.0);
  EXPECT_TRUE(heap.contains(0));
  EXPECT_EQ(heap.key(0), 3.0);
}

// Few different keys, so that ties are common.
double random_key(Random& random) { return static_cast<double>(random.below(40)); }

TEST(PairingHeap, AgreesWithASortedSetOverRandomOperations) {
  constexpr Index kItems = 60;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    PairingHeap heap(kItems);
    std::set<std::pair<double, Index>> expected;
    for (int step = 0; step < 2000; ++step) {
      const auto item = static_cast<Index>(random.below(kItems));
      const double key = random_key(random);
      if (random.below(3) == 0 && !expected.empty()) {
        ASSERT_EQ(heap.top(), expected.begin()->second);
        ASSERT_EQ(heap.key(heap.top()), expected.begin()->first);
        expected.erase({heap.key(heap.top()), heap.pop()});
      } else if (!heap.contains(item)) {
        heap.push(item, key);
        expected.insert({key, item});
      } else if (key <= heap.key(item)) {
        expected.erase({heap.key(item), item});
        heap.decrease(item, key);
        expected.insert({key, item});
      }
      ASSERT_EQ(heap.empty(), expected.empty());
    }
  }
}

}  // namespace
}  // namespace wellspaced
