#include "wellspaced/algorithms/audit/circumcentre.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced::audit {
namespace {

using Integer = __int128;

// The centre for whole coordinates of at most 20 bits, by integers and one division; none for flat
// simplices.
bool true_offset(const std::array<Vec<2>, 3>& p, std::array<long double, 2>& offset) {
  const auto at = [&](int k, int i) { return static_cast<Integer>(p[k][i] - p[0][i]); };
  const Integer bb = at(1, 0) * at(1, 0) + at(1, 1) * at(1, 1);
  const Integer cc = at(2, 0) * at(2, 0) + at(2, 1) * at(2, 1);
  const Integer twice = 2 * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  if (twice == 0) return false;
  const auto quotient = [&](Integer n) {
    return static_cast<long double>(n) / static_cast<long double>(twice);
  };
  offset = {quotient(at(2, 1) * bb - at(1, 1) * cc), quotient(at(1, 0) * cc - at(2, 0) * bb)};
  return true;
}

bool true_offset(const std::array<Vec<3>, 4>& p, std::array<long double, 3>& offset) {
  std::array<std::array<Integer, 3>, 3> e;
  std::array<Integer, 3> square{};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) {
      e[k][i] = static_cast<Integer>(p[k + 1][i] - p[0][i]);
      square[k] += e[k][i] * e[k][i];
    }
  const auto cross = [&](int k, int l, int i) {
    const int j = (i + 1) % 3, m = (i + 2) % 3;
    return e[k][j] * e[l][m] - e[k][m] * e[l][j];
  };
  Integer twice = 0;
  for (int i = 0; i < 3; ++i) twice += 2 * e[0][i] * cross(1, 2, i);
  if (twice == 0) return false;
  for (int i = 0; i < 3; ++i)
    offset[i] = static_cast<long double>(square[0] * cross(1, 2, i) + square[1] * cross(2, 0, i) +
                                         square[2] * cross(0, 1, i)) /
                static_cast<long double>(twice);
  return true;
}

// Whole coordinates; `thin`: the last corner lies beside the middle of the others, moved by at most
// 1 in each coordinate.
template <std::size_t D>
std::array<Vec<D>, D + 1> random_simplex(Random& random, bool thin) {
  std::array<Vec<D>, D + 1> p;
  for (auto& corner : p)
    for (double& x : corner) x = std::floor(random.uniform(0, 0x1p20));
  if (!thin) return p;
  for (std::size_t i = 0; i < D; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < D; ++k) sum += p[k][i];
    p[D][i] = std::floor(sum / D + random.uniform(-1, 2));
  }
  return p;
}

template <std::size_t D>
void expect_truth_within_bounds(bool thin) {
  Random random(thin ? 2 : 1);
  int judged = 0;
  for (int n = 0; n < 5000; ++n) {
    const auto p = random_simplex<D>(random, thin);
    std::array<long double, D> offset;
    if (!true_offset(p, offset)) continue;
    const RoundedCentre<D> centre = circumcentre<D>(p);
    if (!std::isfinite(centre.error)) continue;
    long double away_sq = 0;
    for (std::size_t i = 0; i < D; ++i) {
      const long double away = centre.place[i] - (p[0][i] + offset[i]);
      away_sq += away * away;
    }
    ASSERT_LE(std::sqrt(away_sq), centre.error) << "simplex " << n;
    ++judged;
  }
  EXPECT_GT(judged, 4500);
}

TEST(Circumcentre, LiesWithinTheBoundOfTrianglesAndTets) {
  expect_truth_within_bounds<2>(false);
  expect_truth_within_bounds<3>(false);
}

TEST(Circumcentre, LiesWithinTheBoundOfThinTrianglesAndSlivers) {
  expect_truth_within_bounds<2>(true);
  expect_truth_within_bounds<3>(true);
}

TEST(Circumcentre, IsKnownToAMillionthOfAnEdgeWhereTheCornersAreFarFromFlat) {
  const RoundedCentre<2> plane = circumcentre<2>({{{0, 0}, {4, 0}, {0, 2}}});
  EXPECT_EQ(plane.place, (Vec<2>{2, 1}));
  EXPECT_LT(plane.error, 4e-6);
  const RoundedCentre<3> space = circumcentre<3>({{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 6}}});
  EXPECT_EQ(space.place, (Vec<3>{2, 1, 3}));
  EXPECT_LT(space.error, 4e-6);
}

TEST(Circumcentre, OfFlatCornersIsNotKnown) {
  EXPECT_EQ(circumcentre<2>({{{0, 0}, {1, 1}, {2, 2}}}).error, kInfinity);
  EXPECT_EQ(circumcentre<3>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}).error, kInfinity);
}

}  // namespace
}  // namespace wellspaced::audit
