#include "wellspaced/algorithms/spacing/distance_queue.hpp"

#include <gtest/gtest.h>

#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

TEST(DistanceQueue, GivesTheNearestFirstAndTheLowerOfTwoEquallyFar) {
  Random random(1);
  std::vector<std::pair<double, Index>> expected;
  DistanceQueue queue;
  EXPECT_TRUE(queue.empty());
  for (Index i = 0; i < 5000; ++i) {  // more than the object itself holds
    const double distance_sq = static_cast<double>(random.below(100));
    queue.push({distance_sq, 0, i, i});
    expected.emplace_back(distance_sq, i);
  }
  sort(expected);
  for (const auto& [distance_sq, item] : expected) {
    ASSERT_FALSE(queue.empty());
    const Pending nearest = queue.pop();
    ASSERT_EQ(nearest.distance_sq, distance_sq);
    ASSERT_EQ(nearest.first, item);
  }
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace wellspaced
