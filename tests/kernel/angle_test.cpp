#include "wellspaced/kernel/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Angle, MultiplesOf45DegreesAreExact) {
  EXPECT_EQ(arccotangent_deg(kInfinity), 0);
  EXPECT_EQ(arccotangent_deg(1), 45);
  EXPECT_EQ(arccotangent_deg(0), 90);
  EXPECT_EQ(arccotangent_deg(-1), 135);
  EXPECT_EQ(arccotangent_deg(-kInfinity), 180);
}

TEST(Angle, ArccotangentInvertsTheCotangent) {
  Random random(1);
  for (int k = 0; k < 100000; ++k) {
    const long double degrees = random.uniform(0.001, 179.999);
    const long double radians = degrees / 180 * 3.141592653589793238462643383279502884L;
    const double cotangent = static_cast<double>(1 / std::tan(radians));
    EXPECT_NEAR(arccotangent_deg(cotangent), static_cast<double>(degrees), 1e-13);
  }
}

TEST(Angle, TheNamedCotangentIsThatOf10Degrees) {
  EXPECT_NEAR(arccotangent_deg(kCotangentOf10Degrees), 10, 1e-14);
}

TEST(Angle, CornersOfAnEquilateralTriangleHave60Degrees) {
  const Point2 a{0, 0}, b{1, 0}, c{0.5, std::sqrt(0.75)};
  EXPECT_NEAR(arccotangent_deg(corner_cotangent(a, b, c)), 60, 1e-13);
  EXPECT_NEAR(arccotangent_deg(corner_cotangent(b, a, c)), 60, 1e-13);
}

TEST(Angle, ASmallerAngleHasALargerCotangent) {
  double last = kInfinity;
  for (int k = 1; k < 1000; ++k) {
    const double radians = 0.00314 * k;
    const double next = corner_cotangent({0, 0}, {3, 0}, {std::cos(radians), std::sin(radians)});
    EXPECT_LT(next, last);
    last = next;
  }
}

TEST(Angle, FlatCornersHave0Or180DegreesAndCoincidentOnesNone) {
  EXPECT_EQ(arccotangent_deg(corner_cotangent({0, 0}, {1, 1}, {2, 2})), 0);
  EXPECT_EQ(arccotangent_deg(corner_cotangent({0, 0}, {1, 1}, {-2, -2})), 180);
  EXPECT_TRUE(std::isnan(arccotangent_deg(corner_cotangent({1, 1}, {1, 1}, {2, 2}))));
}

}  // namespace
}  // namespace wellspaced
