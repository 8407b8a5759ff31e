#include "wellspaced/kernel/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

constexpr long double kPi = 3.141592653589793238462643383279502884L;

TEST(CirclePoint, IsExactAtQuarterTurns) {
  EXPECT_EQ(circle_point(0), (Point2{1, 0}));
  EXPECT_EQ(circle_point(0.25), (Point2{0, 1}));
  EXPECT_EQ(circle_point(-0.5), (Point2{-1, 0}));
  EXPECT_EQ(circle_point(1e6 + 0.75), (Point2{0, -1}));
}

TEST(CirclePoint, IsWithinTwoUnitsInTheLastPlaceOfCosineAndSine) {
  Random random(1);
  for (int k = 0; k < 100000; ++k) {
    const double turns = random.uniform(-2, 2);
    const Point2 p = circle_point(turns);
    EXPECT_NEAR(p.x, static_cast<double>(std::cos(2 * kPi * turns)), 0x1p-51);
    EXPECT_NEAR(p.y, static_cast<double>(std::sin(2 * kPi * turns)), 0x1p-51);
  }
}

TEST(CirclePoint, HasTheSameBitsEverywhere) {
  EXPECT_EQ(circle_point(0.1), (Point2{0x1.9e3779b97f4a8p-1, 0x1.2cf2304755a5ep-1}));
  EXPECT_EQ(circle_point(0.61), (Point2{-0x1.8a80b635b6bebp-1, -0x1.465c6feb501bap-1}));
}

TEST(PowerOfTwo, IsExactForWholeExponents) {
  for (int k = -1022; k < 1024; ++k) EXPECT_EQ(power_of_two(k), std::ldexp(1.0, k));
}

TEST(PowerOfTwo, IsWithinTwoUnitsInTheLastPlace) {
  Random random(2);
  for (int k = 0; k < 100000; ++k) {
    const double exponent = random.uniform(-60, 60);
    EXPECT_NEAR(power_of_two(exponent) / static_cast<double>(std::exp2l(exponent)), 1, 0x1p-51);
  }
}

TEST(BinaryLogarithm, IsExactForPowersOfTwo) {
  for (int k = -1074; k < 1024; ++k) EXPECT_EQ(binary_logarithm(std::ldexp(1.0, k)), k);
}

TEST(BinaryLogarithm, IsWithinItsBound) {
  Random random(3);
  for (int k = 0; k < 100000; ++k) {
    const double x = power_of_two(random.uniform(-60, 60));
    const double expected = static_cast<double>(std::log2(static_cast<long double>(x)));
    EXPECT_NEAR(binary_logarithm(x), expected, 1e-15 * std::fmax(1, std::fabs(expected)));
  }
}

TEST(BinaryLogarithm, HasTheUsualLimits) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(binary_logarithm(0), -infinity);
  EXPECT_EQ(binary_logarithm(infinity), infinity);
  EXPECT_TRUE(std::isnan(binary_logarithm(-1)));
  EXPECT_TRUE(std::isnan(binary_logarithm(std::nan(""))));
}

}  // namespace
}  // namespace wellspaced
