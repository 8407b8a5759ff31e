#include "wellspaced/kernel/big_integer.hpp"

#include <gtest/gtest.h>

#include "tests/support/slow_integer.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::testing {
namespace {

template <int N>
SlowInteger slow(const BigInteger<N>& a) {
  SlowInteger sum;
  for (int i = a.size(); i-- > 0;) {
    sum = (sum << 32) + SlowInteger(static_cast<std::int64_t>(a.limb(i) >> 32));
    sum = (sum << 32) + SlowInteger(static_cast<std::int64_t>(a.limb(i) & 0xFFFFFFFFu));
  }
  return a.negative() ? -sum : sum;
}

// Sparse and dense, 0 to 511 bits, with runs of zeros and of ones.
BigInteger<8> random_integer(Random& random) {
  BigInteger<8> sum;
  for (std::uint64_t terms = random.below(6); terms > 0; --terms) {
    const std::uint64_t magnitude = random.bits() >> random.below(64);
    const auto shift = static_cast<int>(random.below(440));
    sum = sum + BigInteger<8>::shifted(random.below(2) != 0, magnitude, shift);
  }
  return sum;
}

TEST(BigInteger, AddsSubtractsAndMultipliesAsIntegersDo) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const auto a = random_integer(random), b = random_integer(random);
    ASSERT_EQ(slow(a + b), slow(a) + slow(b));
    ASSERT_EQ(slow(a - b), slow(a) - slow(b));
    ASSERT_EQ(slow(a * b), slow(a) * slow(b));
    ASSERT_EQ(sign_of(a - b), (slow(a) - slow(b)).sign());
  }
}

TEST(BigInteger, HasOneZero) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const auto a = random_integer(random);
    const auto zero = a - a;
    EXPECT_EQ(zero.size(), 0);
    EXPECT_EQ(zero.sign(), 0);
    EXPECT_FALSE(zero.negative());
    EXPECT_EQ((zero * a).sign(), 0);
  }
}

TEST(BigInteger, CountsItsBits) {
  EXPECT_EQ(BigInteger<4>().bit_length(), 0);
  for (int shift = 0; shift < 256; ++shift) {
    const auto power = BigInteger<4>::shifted(true, 1, shift);
    ASSERT_EQ(power.bit_length(), shift + 1);
    ASSERT_EQ((power - BigInteger<1>::shifted(true, 1, 0)).bit_length(), shift);
  }
}

TEST(BigInteger, IsTheSameInAnotherCapacity) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const auto a = random_integer(random);
    EXPECT_EQ(slow(BigInteger<20>(a)), slow(a));
  }
}

}  // namespace
}  // namespace wellspaced::testing
