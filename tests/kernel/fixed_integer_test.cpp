#include "wellspaced/kernel/fixed_integer.hpp"

#include <gtest/gtest.h>

#include "tests/support/slow_integer.hpp"
#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::testing {
namespace {

SlowInteger slow(Int128 x) {
  const auto low = static_cast<std::int64_t>(x) & ((std::int64_t{1} << 62) - 1);
  return (SlowInteger(static_cast<std::int64_t>(x >> 62)) << 62) + SlowInteger(low);
}
SlowInteger slow(std::int64_t x) { return x; }

template <int N, int Bits>
SlowInteger slow(const Digits<N, Bits>& a) {
  SlowInteger sum;
  for (int i = N; i-- > 0;) sum = (sum << Bits) + SlowInteger(a.digit[i]);
  return sum;
}

template <int N, int Bits>
SlowInteger slow(const Columns<N, Bits>& a) {
  SlowInteger sum;
  for (int i = N; i-- > 0;) sum = (sum << Bits) + slow(a.column[i]);
  return sum;
}

// Often 0, 1 or at the limit, of either sign.
Int128 edgy(Random& random, Int128 limit) {
  const Int128 choices[] = {0, 1, limit, limit - 1, limit / 2};
  const std::uint64_t pick = random.below(8);
  const Int128 any = ((Int128{static_cast<std::int64_t>(random.bits() >> 1)} << 64) |
                      Int128{static_cast<std::int64_t>(random.bits() >> 1)}) %
                     (limit + 1);
  const Int128 magnitude = pick < 5 ? choices[pick] : any;
  return random.below(2) != 0 ? magnitude : -magnitude;
}

Digits<2, 60> random_digits(Random& random) {
  return exact::two_digits(edgy(random, Int128{1} << 120));
}

TEST(Digits, AddSubtractAndMultiplyAsIntegersDo) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto a = random_digits(random), b = random_digits(random);
    const auto c = random_digits(random), d = random_digits(random);
    ASSERT_EQ(slow(a * b + c * d), slow(a) * slow(b) + slow(c) * slow(d));
    ASSERT_EQ(slow(a * b - c * d), slow(a) * slow(b) - slow(c) * slow(d));
    ASSERT_EQ(slow((a * b - c * d) * a), (slow(a) * slow(b) - slow(c) * slow(d)) * slow(a));
  }
}

TEST(Digits, AreCanonicalAfterTheCarries) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto columns = random_digits(random) * random_digits(random);
    const auto carried = digits(columns);
    ASSERT_EQ(slow(carried), slow(columns));
    for (int k = 0; k < 3; ++k) {
      ASSERT_GE(carried.digit[k], 0);
      ASSERT_LT(carried.digit[k], std::int64_t{1} << 60);
    }
  }
}

TEST(Columns, KnowTheirSignBeforeTheCarries) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    Columns<3, 60> a{};
    for (Int128& column : a.column) column = edgy(random, Int128{1} << (random.below(2) * 63));
    ASSERT_EQ(sign_of(a), slow(a).sign());
  }
}

// Each determinant on differences of the greatest width that its kind of number is made for, by
// expansion of the lifted matrix.
template <class Determinant, class T, std::size_t N>
int expected_sign(const std::array<T, N>& v, bool lifted) {
  SlowMatrix matrix;
  for (std::size_t i = 0; i < N; i += Determinant::kDimension) {
    std::vector<SlowInteger> row;
    SlowInteger lift;
    for (std::size_t k = 0; k < Determinant::kDimension; ++k) {
      row.push_back(slow(v[i + k]));
      lift = lift + row.back() * row.back();
    }
    if (lifted) row.push_back(lift);
    matrix.push_back(row);
  }
  return slow_determinant(matrix).sign();
}

template <class Determinant, std::size_t N>
void expect_exact_at_the_limits_of_the_widths(bool lifted) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    std::array<std::int64_t, N> narrow, one;
    std::array<Int128, N> two;
    for (std::size_t k = 0; k < N; ++k) {
      narrow[k] = static_cast<std::int64_t>(edgy(random, Int128{1} << Determinant::kNarrowBits));
      one[k] = static_cast<std::int64_t>(edgy(random, Int128{1} << 61));
      two[k] = edgy(random, Int128{1} << 120);
    }
    ASSERT_EQ(Determinant::sign(narrow), expected_sign<Determinant>(narrow, lifted));
    ASSERT_EQ(Determinant::sign(exact::map(exact::one_digit, one)),
              expected_sign<Determinant>(one, lifted));
    ASSERT_EQ(Determinant::sign(exact::map(exact::two_digits, two)),
              expected_sign<Determinant>(two, lifted));
  }
}

TEST(Determinants, AreExactAtTheLimitsOfTheirWidths) {
  expect_exact_at_the_limits_of_the_widths<exact::Orient2d, 4>(false);
  expect_exact_at_the_limits_of_the_widths<exact::Incircle, 6>(true);
  expect_exact_at_the_limits_of_the_widths<exact::Orient3d, 9>(false);
  expect_exact_at_the_limits_of_the_widths<exact::Insphere, 12>(true);
}

}  // namespace
}  // namespace wellspaced::testing
