#include "wellspaced/kernel/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace wellspaced {
namespace {

// The first numbers of the published generator from the state 1234567, which it steps by the
// golden ratio.
TEST(Splitmix64, IsThePublishedFunction) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;
  constexpr std::array<std::uint64_t, 5> kPublished = {6457827717110365317u, 3203168211198807973u,
                                                       9817491932198370423u, 4593380528125082431u,
                                                       16408922859458223821u};
  for (std::size_t i = 0; i < kPublished.size(); ++i)
    EXPECT_EQ(splitmix64(1234567 + i * kGolden), kPublished[i]) << i;
}

TEST(Random, IsTheSameForTheSameSeedAndAnotherForAnother) {
  Random a(5), b(5), c(6);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t bits = a.bits();
    EXPECT_EQ(bits, b.bits());
    EXPECT_NE(bits, c.bits());
  }
}

TEST(Random, IsUniformBelowOneInStepsOfTwoToTheMinus53) {
  Random random(1);
  std::array<int, 16> counts{};
  constexpr int kDraws = 160'000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform();
    ASSERT_TRUE(x >= 0 && x < 1 && std::trunc(x * 0x1p53) == x * 0x1p53);
    ++counts[static_cast<std::size_t>(16 * x)];
  }
  // Five deviations of the binomial distribution.
  for (const int count : counts) EXPECT_NEAR(count, kDraws / 16, 5 * 97);
}

TEST(Random, DrawsEveryNumberBelowABoundAndNoOther) {
  Random random(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70'000; ++i) {
    const std::uint64_t k = random.below(7);
    ASSERT_LT(k, 7u);
    ++counts[k];
  }
  for (const int count : counts) EXPECT_NEAR(count, 10'000, 5 * 93);
}

}  // namespace
}  // namespace wellspaced
