#include "wellspaced/kernel/space/box3.hpp"

#include <gtest/gtest.h>

#include <array>

namespace wellspaced {
namespace {

TEST(Box3, AroundPointsReachesFromTheLeastToTheGreatestCoordinates) {
  const Box3 box = Box3::around(std::array{Point3{1, 5, -3}, Point3{4, 2, 0}, Point3{2, 2, -7}});
  EXPECT_EQ(box.low, (Point3{1, 2, -7}));
  EXPECT_EQ(box.high, (Point3{4, 5, 0}));
  EXPECT_EQ(box.size(), (Point3{3, 3, 7}));
}

TEST(Box3, AroundOnePointIsThatPoint) {
  const Point3 p{1, 2, 3};
  const Box3 box = Box3::around(std::array{p});
  EXPECT_EQ(box.low, p);
  EXPECT_EQ(box.high, p);
}

TEST(Box3, CoversAnotherByGrowingInEachDirectionAlone) {
  Box3 box{{0, 0, 0}, {1, 1, 1}};
  box.cover({{-2, 0.5, 0.5}, {0.5, 3, 0.5}});
  EXPECT_EQ(box.low, (Point3{-2, 0, 0}));
  EXPECT_EQ(box.high, (Point3{1, 3, 1}));
}

}  // namespace
}  // namespace wellspaced
