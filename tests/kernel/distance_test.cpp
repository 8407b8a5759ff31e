#include "wellspaced/kernel/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wellspaced {
namespace {

TEST(Distance, IsEuclideanAndSymmetric) {
  EXPECT_EQ(distance({0, 0}, {3, 4}), 5);
  EXPECT_EQ(distance({3, 4}, {0, 0}), 5);
  EXPECT_EQ(distance({7, 7}, {7, 7}), 0);
}

TEST(Distance, ScalesWithThePointsByAnyPowerOfTwo) {
  const double unit = distance({0.3, 0.7}, {-1.1, 0.2});
  for (int exponent = -1000; exponent <= 1020; exponent += 10) {
    const double scale = std::ldexp(1.0, exponent);
    EXPECT_EQ(distance({0.3 * scale, 0.7 * scale}, {-1.1 * scale, 0.2 * scale}), unit * scale)
        << exponent;
  }
}

TEST(Distance, ReachesFromOneEndOfTheDoublesToTheOther) {
  EXPECT_EQ(distance({0x1p1023, 0}, {-0x1p1023 / 2, 0}), 0x1.8p1023);
  EXPECT_EQ(distance({0x1p-1074, 0}, {0, 0}), 0x1p-1074);
  EXPECT_TRUE(std::isinf(distance({0x1.8p1023, 0}, {-0x1.8p1023, 0})));
}

}  // namespace
}  // namespace wellspaced
