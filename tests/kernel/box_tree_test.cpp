#include "wellspaced/kernel/box_tree.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

Box2 random_box(Random& random, double size) {
  const Point2 low{random.uniform(), random.uniform()};
  return {low, {low.x + size * random.uniform(), low.y + size * random.uniform()}};
}

std::set<std::size_t> found(const BoxTree& tree, const Box2& query) {
  std::set<std::size_t> result;
  tree.for_each_meeting(
      query, [&](std::size_t i) { EXPECT_TRUE(result.insert(i).second) << "told twice"; });
  return result;
}

TEST(BoxTree, FindsWhatAScanFinds) {
  Random random(1);
  for (const std::size_t count : {0, 1, 4, 5, 8, 9, 100, 777})
    for (const double size : {0.0, 0.05, 0.5}) {
      std::vector<Box2> boxes;
      for (std::size_t i = 0; i < count; ++i) boxes.push_back(random_box(random, size));
      const BoxTree tree(boxes);
      for (int k = 0; k < 50; ++k) {
        const Box2 query = random_box(random, 0.2);
        std::set<std::size_t> expected;
        for (std::size_t i = 0; i < count; ++i)
          if (boxes[i].meets(query)) expected.insert(i);
        EXPECT_EQ(found(tree, query), expected);
      }
    }
}

TEST(BoxTree, FindsAllOfManyEqualBoxes) {
  const BoxTree tree(std::vector<Box2>(50, Box2{{1, 1}, {2, 2}}));
  EXPECT_EQ(found(tree, {{2, 2}, {3, 3}}).size(), 50u) << "boxes are closed";
  EXPECT_TRUE(found(tree, {{2.5, 2.5}, {3, 3}}).empty());
}

TEST(Box2, SurroundsItsPoints) {
  const Box2 box = Box2::around(std::array{Point2{1, 5}, Point2{-2, 3}, Point2{0, 7}});
  EXPECT_EQ(box.low, (Point2{-2, 3}));
  EXPECT_EQ(box.high, (Point2{1, 7}));
}

}  // namespace
}  // namespace wellspaced
