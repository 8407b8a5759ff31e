#include "wellspaced/algorithms/coarsening/node_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

std::vector<Index> iota(Index count, Index first = 0) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

TEST(RandomOrder, AscendsByTheKeyOfChoices13) {
  const std::vector<Index> origin = iota(1000, 70);
  const auto order = random_order(iota(1000), origin, 3, 42);
  const auto key = [&](Index v) {
    return splitmix64(splitmix64(42) ^ splitmix64((std::uint64_t{3} << 32) + origin[v]));
  };
  EXPECT_TRUE(std::ranges::is_sorted(order, {}, key));
  EXPECT_TRUE(std::ranges::is_permutation(order, iota(1000)));
}

TEST(RandomOrder, DependsOnOriginLevelAndSeedAlone) {
  const std::vector<Index> origin = iota(100);
  const auto order = random_order(iota(100), origin, 1, 1);
  auto reversed = iota(100);
  std::ranges::reverse(reversed);
  EXPECT_EQ(random_order(reversed, origin, 1, 1), order);
  EXPECT_NE(random_order(iota(100), origin, 2, 1), order);
  EXPECT_NE(random_order(iota(100), origin, 1, 2), order);
  EXPECT_NE(random_order(iota(100), iota(100, 5), 1, 1), order);
}

TEST(RandomOrder, OfSomeNodesIsTheirOrderAmongAll) {
  const std::vector<Index> origin = iota(100);
  auto all = random_order(iota(100), origin, 1, 1);
  std::erase_if(all, [](Index v) { return v % 3 != 0; });
  auto some = iota(100);
  std::erase_if(some, [](Index v) { return v % 3 != 0; });
  EXPECT_EQ(random_order(some, origin, 1, 1), all);
}

}  // namespace
}  // namespace wellspaced
