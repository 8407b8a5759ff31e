#include "wellspaced/kernel/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "tests/support/data.hpp"
#include "tests/support/predicate_cases.hpp"

namespace wellspaced::testing {
namespace {

// Says the coordinates in hexadecimal, so that a failing line can be repeated.
template <std::size_t N>
std::string text(const std::array<double, N>& x) {
  std::ostringstream out;
  for (const double value : x) out << std::hexfloat << value << ' ';
  return out.str();
}

// Asks every rung. Each that answers must agree with the slow reference.
template <class Case>
void expect_all_rungs_exact(const typename Case::Coordinates& x) {
  const int expected = slow_sign<Case>(x);
  ASSERT_EQ(Case::sign(x), expected) << Case::kName << ' ' << text(x);
  ASSERT_EQ(Case::big(x), expected) << Case::kName << ' ' << text(x);
  ASSERT_EQ(Case::fixed(x).value_or(expected), expected) << Case::kName << ' ' << text(x);
  const int filtered = Case::filter(x);
  ASSERT_TRUE(filtered == 0 || filtered == expected) << Case::kName << ' ' << text(x);
}

template <class Case>
class Predicate : public ::testing::Test {
 protected:
  using Coordinates = typename Case::Coordinates;

  static Coordinates with_points_exchanged(Coordinates x, std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < Case::kDimension; ++k) {
      std::swap(x[i * Case::kDimension + k], x[j * Case::kDimension + k]);
    }
    return x;
  }

  static Coordinates with_first_point_last(Coordinates x) {
    std::rotate(x.begin(), x.begin() + Case::kDimension, x.end());
    return x;
  }
};

using Cases = ::testing::Types<Orient2dCase, IncircleCase, Orient3dCase, InsphereCase>;
class CaseNames {
 public:
  template <class Case>
  static std::string GetName(int) {
    return Case::kName;
  }
};
TYPED_TEST_SUITE(Predicate, Cases, CaseNames);

TYPED_TEST(Predicate, IsExactOnTenThousandHardLines) {
  LineGenerator<TypeParam> generator(1);
  for (int i = 0; i < 10000; ++i) {
    const auto family = static_cast<Family>(i % kFamilies);
    expect_all_rungs_exact<TypeParam>(generator.line(family));
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(Predicate, ReversesItsSignWhenTwoPointsAreExchanged) {
  LineGenerator<TypeParam> generator(2);
  for (int i = 0; i < 4000; ++i) {
    const auto x = generator.line(static_cast<Family>(i % kFamilies));
    const std::size_t a = generator.random().below(TypeParam::kPoints);
    const std::size_t b =
        (a + 1 + generator.random().below(TypeParam::kPoints - 1)) % TypeParam::kPoints;
    ASSERT_EQ(TypeParam::sign(x), -TypeParam::sign(this->with_points_exchanged(x, a, b)))
        << text(x);
  }
}

TYPED_TEST(Predicate, KeepsOrReversesItsSignUnderACyclicShiftByTheParityOfTheShift) {
  LineGenerator<TypeParam> generator(3);
  const int parity = TypeParam::kPoints % 2 == 1 ? 1 : -1;
  for (int i = 0; i < 4000; ++i) {
    const auto x = generator.line(static_cast<Family>(i % kFamilies));
    ASSERT_EQ(TypeParam::sign(x), parity * TypeParam::sign(this->with_first_point_last(x)))
        << text(x);
  }
}

TYPED_TEST(Predicate, KeepsItsSignUnderAnExactTranslation) {
  LineGenerator<TypeParam> generator(4);
  for (int i = 0; i < 4000; ++i) {
    const auto x = generator.line(i % 2 == 0 ? Family::kUniform : Family::kGrid);
    auto moved = x;
    for (std::size_t j = 0; j < x.size(); ++j) {  // 26 bits more to the left of 26 kept below
      moved[j] = std::ldexp(std::nearbyint(std::ldexp(x[j], 20)), -20);
    }
    auto translated = moved;
    for (std::size_t j = 0; j < x.size(); ++j) {
      translated[j] += j % TypeParam::kDimension == 0 ? 0x1p30 : -0x1.8p29;
    }
    ASSERT_EQ(TypeParam::sign(moved), TypeParam::sign(translated)) << text(moved);
  }
}

TYPED_TEST(Predicate, KeepsItsSignUnderScalingByPowersOfTwo) {
  LineGenerator<TypeParam> generator(5);
  for (int i = 0; i < 400; ++i) {
    auto x = generator.line(i % 2 == 0 ? Family::kGrid : Family::kRounded);
    for (double& value : x) value = std::ldexp(std::nearbyint(std::ldexp(value, -20)), 0);
    const int expected = TypeParam::sign(x);
    for (int exponent = -1074; exponent <= 960; exponent += 113) {
      auto scaled = x;
      for (double& value : scaled) value = std::ldexp(value, exponent);
      ASSERT_EQ(TypeParam::sign(scaled), expected) << text(scaled);
    }
  }
}

TYPED_TEST(Predicate, IsExactAtTheLimitsOfTheDoubles) {
  const double limits[] = {0.0,
                           -0.0,
                           std::numeric_limits<double>::denorm_min(),
                           -std::numeric_limits<double>::denorm_min(),
                           std::numeric_limits<double>::min(),
                           std::numeric_limits<double>::max(),
                           -std::numeric_limits<double>::max(),
                           1.0,
                           0x1.fffffffffffffp-1};
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    typename TypeParam::Coordinates x;
    for (double& value : x) value = limits[random.below(std::size(limits))];
    expect_all_rungs_exact<TypeParam>(x);
    if (this->HasFatalFailure()) return;
  }
}

// Which rung must answer.

TYPED_TEST(Predicate, IsDecidedByTheFilterOnUniformPoints) {
  LineGenerator<TypeParam> generator(7);
  for (int i = 0; i < 10000; ++i) {
    ASSERT_NE(TypeParam::filter(generator.line(Family::kUniform)), 0);
  }
}

TYPED_TEST(Predicate, IsDecidedByFixedIntegersOnGrids) {
  LineGenerator<TypeParam> generator(8);
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(TypeParam::fixed(generator.line(Family::kGrid)));
}

TYPED_TEST(Predicate, LeavesToBigIntegersWhatSpansMoreBitsThanAnyFixedWidth) {
  typename TypeParam::Coordinates x{};
  x[0] = 1;
  x[1] = 0x1p-119;
  EXPECT_FALSE(TypeParam::fixed(x));
  x[1] = 0x1p-118;
  EXPECT_TRUE(TypeParam::fixed(x));
}

// Lines that broke other libraries: "sign tag coordinates" with C hexadecimal floats.
TYPED_TEST(Predicate, IsExactOnLinesThatBrokeOtherLibraries) {
  const std::string name =
      std::string("issues/predicates/") + TypeParam::kName + "_public_nanevski.txt";
  WELLSPACED_REQUIRE_DATA(name);
  std::ifstream file(test::data_path(name));
  int lines = 0;
  for (std::string line; std::getline(file, line); ++lines) {
    std::istringstream fields(line);
    int expected = 0;
    std::string field;
    fields >> expected >> field;
    typename TypeParam::Coordinates x;
    for (double& value : x) {
      ASSERT_TRUE(fields >> field) << line;
      value = std::strtod(field.c_str(), nullptr);
    }
    ASSERT_EQ(slow_sign<TypeParam>(x), expected) << line;
    expect_all_rungs_exact<TypeParam>(x);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GE(lines, 1);
}

// The conventions.

TEST(Orient2d, IsPositiveForALeftTurn) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
}

TEST(Incircle, IsPositiveInsideACounterClockwiseCircle) {
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), 1);
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {2, 2}), -1);
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {1, 1}), 0);
}

TEST(Orient3d, IsPositiveBelowACounterClockwiseTriangle) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}), 0);
}

// Differences that round down and up, and products that underflow to either side of what they are:
// left of the line the filter's two products would have one sign, the exact ones the other.
TEST(Orient2d, IsExactWhereUnderflowReversesTheOrderOfTheProducts) {
  // x y is just above (sign 1) or below 1.5, by less than the differences lose.
  const auto factors = [](Random& random, double sign) {
    for (;;) {
      const double x = random.uniform(1, 1.5), y = 1.5 / x;
      const double excess = std::fma(x, y, -1.5) * sign;
      if (excess > 0 && excess < 0x1p-55) return std::array{x, y};
    }
  };
  Random random(10);
  for (int i = 0; i < 20; ++i) {
    const auto [x, y] = factors(random, 1);
    const auto [v, w] = factors(random, -1);
    const double s = 0x1p-537, loss = 0x1p-54;
    expect_all_rungs_exact<Orient2dCase>({x * s, -v * s, -w * s, y * s, loss * s, loss * s});
  }
}

// Here the filter's determinant overflows to the wrong infinity while its bound stays finite.
TEST(Orient3d, IsExactWhereTheDeterminantOverflowsButNotItsBound) {
  constexpr double kMost = std::numeric_limits<double>::max();
  expect_all_rungs_exact<Orient3dCase>(
      {1, -kMost, 0x1p-1074, 1, -0x1p-1074, -0x1p-1074, 1, kMost, 0x1p-1074, 0, 1, 1});
}

TEST(Insphere, IsPositiveInsideTheSphereOfAPositiveTetrahedron) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, -1};
  ASSERT_EQ(orient3d(a, b, c, d), 1);
  EXPECT_EQ(insphere(a, b, c, d, {0.5, 0.5, -0.5}), 1);
  EXPECT_EQ(insphere(a, b, c, d, {2, 2, 2}), -1);
  EXPECT_EQ(insphere(a, b, c, d, {1, 1, -1}), 0);
}

// |a - p|^2 - |b - p|^2 in the tests' own integers, for the coordinates of a, b and p.
template <std::size_t N>
int slow_compare_distances(const std::array<double, N>& x) {
  constexpr std::size_t kDimension = N / 3;
  const int unit = lowest_exponent(x);
  SlowInteger sum;
  for (std::size_t i = 0; i < kDimension; ++i) {
    const SlowInteger p = SlowInteger::from_double(x[2 * kDimension + i], unit);
    const SlowInteger a = SlowInteger::from_double(x[i], unit) - p;
    const SlowInteger b = SlowInteger::from_double(x[kDimension + i], unit) - p;
    sum = sum + a * a - b * b;
  }
  return sum.sign();
}

template <class Point, std::size_t N>
void expect_exact_distances(const std::array<double, N>& x, Point p, Point a, Point b) {
  const int expected = slow_compare_distances(x);
  ASSERT_EQ(compare_distances(p, a, b), expected) << text(x);
  ASSERT_EQ(exact::big_sign<exact::CompareDistances<N / 3>>(x), expected) << text(x);
  const int filtered = predicate_filter::compare_distances(p, a, b);
  ASSERT_TRUE(filtered == 0 || filtered == expected) << text(x);
}

TEST(CompareDistances, IsExactOnTenThousandHardLinesInThePlane) {
  LineGenerator<Orient2dCase> generator(9);
  for (int i = 0; i < 10000; ++i) {
    const auto x = generator.line(static_cast<Family>(i % kFamilies));
    expect_exact_distances<Point2>(x, {x[4], x[5]}, {x[0], x[1]}, {x[2], x[3]});
  }
}

TEST(CompareDistances, IsExactOnTenThousandHardLinesInSpace) {
  LineGenerator<Orient3dCase> generator(9);
  for (int i = 0; i < 10000; ++i) {
    const auto line = generator.line(static_cast<Family>(i % kFamilies));
    std::array<double, 9> x;
    std::copy_n(line.begin(), 9, x.begin());
    expect_exact_distances<Point3>(x, {x[6], x[7], x[8]}, {x[0], x[1], x[2]}, {x[3], x[4], x[5]});
  }
}

TEST(CompareDistances, IsExactBelowRoundingAndBelowTheNormalRange) {
  EXPECT_EQ(compare_distances(Point3{0, 0, 0}, {3, 4, 0}, {0, 0, 5}), 0);
  EXPECT_EQ(compare_distances(Point3{0, 0, 0}, {3, 4, 0x1p-200}, {0, 0, 5}), 1);
  EXPECT_EQ(compare_distances(Point3{0, 0, 0}, {3, 4, 0}, {0x1p-200, 0, 5}), -1);
  EXPECT_EQ(compare_distances(Point3{0, 0, 0}, {5e-324, 0, 0}, {1e-323, 0, 0}), -1);
  EXPECT_EQ(compare_distances(Point3{1e308, 0, 0}, {-1e308, 0, 0}, {-1e308, 1, 0}), -1);
}

TEST(CompareDistances, OfCocircularPointsFromTheCentreIsZero) {
  EXPECT_EQ(compare_distances(Point2{0, 0}, {3, 4}, {-5, 0}), 0);
  EXPECT_EQ(compare_distances(Point2{0, 0}, {0x3p-1074, 0x4p-1074}, {-0x5p-1074, 0}), 0);
  EXPECT_EQ(compare_distances(Point2{0, 0}, {3, 4}, {-5, 0x1p-1074}), -1);
}

}  // namespace
}  // namespace wellspaced::testing
