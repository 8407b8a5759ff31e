#include "wellspaced/kernel/space/circumsphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/points3.hpp"

namespace wellspaced {
namespace {

TEST(Circumsphere, OfTheCornerOfACubeIsTheCubes) {
  const auto sphere = circumsphere({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2});
  ASSERT_TRUE(sphere.ok());
  EXPECT_EQ(sphere->centre, (Point3{1, 1, 1}));
  EXPECT_EQ(sphere->radius, std::sqrt(3.0));
}

TEST(Circumsphere, IsEquallyFarFromAllCornersAtEveryScale) {
  for (const int k : {-1020, -500, 0, 500, 1020}) {
    const double scale = std::ldexp(1.0, k);
    const auto p = test::scaled(test::uniform3(4, 7), scale);
    const auto sphere = circumsphere(p[0], p[1], p[2], p[3]);
    ASSERT_TRUE(sphere.ok());
    for (const Point3 q : p)
      EXPECT_NEAR(std::hypot((q.x - sphere->centre.x) / scale, (q.y - sphere->centre.y) / scale,
                             (q.z - sphere->centre.z) / scale),
                  sphere->radius / scale, 1e-13);
  }
}

TEST(Circumsphere, RefusesCoplanarPointsAndSpheresBeyondTheRange) {
  EXPECT_FALSE(circumsphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 4, 0}).ok());
  EXPECT_FALSE(circumsphere({0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {1e300, 2e300, 1e-300}).ok());
}

}  // namespace
}  // namespace wellspaced
