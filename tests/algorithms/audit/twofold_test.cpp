#include "wellspaced/algorithms/audit/twofold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced::audit {
namespace {

using Integer = __int128;

double random_integer(Random& random, int bits) {
  const double size = std::floor(random.uniform(0, std::ldexp(1, bits)));
  return random.bits() & 1 ? size : -size;
}

Integer exactly(Twofold x) { return static_cast<Integer>(x.high) + static_cast<Integer>(x.low); }

// Whole numbers of a few bits are Twofolds without an error.
Twofold twofold(double high, double low) { return sum_exactly(std::ldexp(high, 50), low); }

TEST(Twofold, SumsOfTwoDoublesAreExact) {
  Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const double a = random_integer(random, 53), b = std::ldexp(random_integer(random, 53), 40);
    EXPECT_EQ(exactly(sum_exactly(a, b)), static_cast<Integer>(a) + static_cast<Integer>(b));
    EXPECT_EQ(exactly(difference_of<Twofold>(a, b)),
              static_cast<Integer>(a) - static_cast<Integer>(b));
  }
}

TEST(Twofold, ProductsOfTwoDoublesAreExact) {
  Random random(2);
  for (int i = 0; i < 10'000; ++i) {
    const double a = random_integer(random, 53), b = random_integer(random, 53);
    EXPECT_EQ(exactly(Twofold{a} * Twofold{b}), static_cast<Integer>(a) * static_cast<Integer>(b));
  }
}

TEST(Twofold, SumsAndProductsErrByTwoToTheMinus100OfWhatGoesIn) {
  Random random(3);
  for (int i = 0; i < 10'000; ++i) {
    const Twofold a = twofold(random_integer(random, 50), random_integer(random, 49));
    const Twofold b = twofold(random_integer(random, 10), random_integer(random, 10));
    const Integer sum = exactly(a) + exactly(b), difference = exactly(a) - exactly(b);
    EXPECT_LE(std::fabs(static_cast<double>(exactly(a + b) - sum)),
              0x1p-98 * (std::fabs(a.high) + std::fabs(b.high)));
    EXPECT_LE(std::fabs(static_cast<double>(exactly(a - b) - difference)),
              0x1p-98 * (std::fabs(a.high) + std::fabs(b.high)));
    const Twofold c{std::ldexp(random_integer(random, 20), -10)};
    const Integer product = exactly(a) * static_cast<Integer>(std::ldexp(c.high, 10));
    const Twofold scaled = (a * c) * Twofold{0x1p10};
    EXPECT_LE(std::fabs(static_cast<double>(exactly(scaled) - product)),
              0x1p-98 * std::fabs(static_cast<double>(product)));
  }
}

}  // namespace
}  // namespace wellspaced::audit
