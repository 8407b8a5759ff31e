#include "wellspaced/kernel/weighted_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/point_families.hpp"
#include "tests/support/slow_integer.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using testing::SlowInteger;

// The whole part of the square root, by bisection.
SlowInteger whole_root(const SlowInteger& square) {
  SlowInteger low = 0;
  for (int bit = 400; bit >= 0; --bit) {
    const SlowInteger trial = low + (SlowInteger(1) << bit);
    if ((trial * trial - square).sign() <= 0) low = trial;
  }
  return low;
}

// 2^300 * (weight + distance), rounded down, for coordinates that are multiples of 2^-80.
SlowInteger slow_distance(const WeightedSite& site, Point2 x) {
  const SlowInteger dx =
      SlowInteger::from_double(site.place.x, -80) - SlowInteger::from_double(x.x, -80);
  const SlowInteger dy =
      SlowInteger::from_double(site.place.y, -80) - SlowInteger::from_double(x.y, -80);
  return (SlowInteger::from_double(site.weight, -80) << 220) +
         whole_root((dx * dx + dy * dy) << 440);
}

// Roots that differ at all differ by far more than 2^-280 for numbers of so few bits.
int slow_order(const WeightedSite& a, const WeightedSite& b, Point2 x) {
  const SlowInteger difference = slow_distance(a, x) - slow_distance(b, x);
  if ((difference + 4).sign() >= 0 && (difference - 4).sign() <= 0) return 0;
  return difference.sign();
}

TEST(WeightedDistanceOrder, AgreesWithRootsToThreeHundredBits) {
  Random random(1);
  int ties = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto small = [&] { return static_cast<double>(random.below(4)) / 4; };
    const WeightedSite a{{small(), small()}, small()}, b{{small(), small()}, small()};
    const Point2 x{small(), small()};
    const int expected = slow_order(a, b, x);
    EXPECT_EQ(weighted_distance_order(a, b, x), expected);
    EXPECT_EQ(weighted_distance_order(b, a, x), -expected);
    ties += expected == 0;
  }
  EXPECT_GT(ties, 5);
}

TEST(WeightedDistanceOrder, TellsWeightsApartThatRoundingHides) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Point2 x{random.uniform(), random.uniform()};
    const WeightedSite a{{random.uniform(), random.uniform()}, 0};
    WeightedSite b{{random.uniform(), random.uniform()}, 0};
    if (weighted_distance(b, x) > weighted_distance(a, x)) continue;
    b.weight = weighted_distance(a, x) - weighted_distance(b, x);  // equal but for rounding
    EXPECT_EQ(weighted_distance_order(a, b, x), slow_order(a, b, x));
  }
}

// 3-4-5 triangles: distances are whole, and ties are exact at every scale.
TEST(WeightedDistanceOrder, SeesExactTiesAndOneUnitInTheLastPlaceAtEveryScale) {
  for (const int exponent : {-1074, -1000, -300, 0, 300, 1000}) {
    const double unit = std::ldexp(1, exponent);
    const WeightedSite a{{3 * unit, 4 * unit}, 8 * unit}, b{{-5 * unit, 12 * unit}, 0};
    EXPECT_EQ(weighted_distance_order(a, b, {0, 0}), 0) << exponent;
    WeightedSite heavier = a;
    heavier.weight = std::nextafter(a.weight, HUGE_VAL);
    EXPECT_EQ(weighted_distance_order(heavier, b, {0, 0}), 1) << exponent;
    EXPECT_EQ(weighted_distance_order(b, heavier, {0, 0}), -1) << exponent;
  }
}

TEST(WeightedDistanceOrder, DecidesWhereTheDistanceOverflows) {
  const double huge = 0x1.8p1023;
  const WeightedSite a{{huge, huge}, 0}, b{{huge, -huge}, 0}, c{{huge, huge}, 1};
  EXPECT_EQ(weighted_distance_order(a, b, {-huge, 0}), 0);
  EXPECT_EQ(weighted_distance_order(a, c, {-huge, 0}), -1);
}

}  // namespace
}  // namespace wellspaced
