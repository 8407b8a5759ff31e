#include "wellspaced/algorithms/coarsening/node_order.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

TEST(RandomKeys, AreThoseOfChoices13) {
  const std::vector<Index> origin = {70, 3, 8};
  const auto keys = random_keys(origin, 3, 42);
  ASSERT_EQ(keys.size(), 3u);
  for (std::size_t v = 0; v < 3; ++v)
    EXPECT_EQ(keys[v],
              splitmix64(splitmix64(42) ^ splitmix64((std::uint64_t{3} << 32) + origin[v])));
}

TEST(RandomKeys, AreAllDifferentAndOthersForAnotherLevelOrSeed) {
  std::vector<Index> origin(10000);
  std::iota(origin.begin(), origin.end(), Index{0});
  std::set<std::uint64_t> all;
  for (const std::uint32_t level : {1, 2})
    for (const std::uint64_t seed : {1, 2}) {
      const auto keys = random_keys(origin, level, seed);
      all.insert(keys.begin(), keys.end());
    }
  EXPECT_EQ(all.size(), 40000u);
}

}  // namespace
}  // namespace wellspaced
