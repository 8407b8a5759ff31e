#include "wellspaced/algorithms/generate/low_discrepancy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "wellspaced/algorithms/generate/point_sets.hpp"

namespace wellspaced {
namespace {

// The definition, box by box: open and closed ones at all coordinates.
double slow_discrepancy(const std::vector<Point2>& points) {
  std::vector<double> xs = {1}, ys = {1};
  for (const Point2& p : points) xs.push_back(p.x), ys.push_back(p.y);
  const auto count = static_cast<double>(points.size());
  double largest = 0;
  for (const double u : xs)
    for (const double v : ys) {
      const auto open = std::ranges::count_if(points, [&](Point2 p) { return p.x < u && p.y < v; });
      const auto closed =
          std::ranges::count_if(points, [&](Point2 p) { return p.x <= u && p.y <= v; });
      largest = std::max({largest, std::fabs(static_cast<double>(open) / count - u * v),
                          std::fabs(static_cast<double>(closed) / count - u * v)});
    }
  return largest;
}

TEST(LowDiscrepancy, MirrorsDigits) {
  EXPECT_EQ(radical_inverse(0, 2), 0);
  EXPECT_EQ(radical_inverse(6, 2), 0.375);   // 110 becomes 0.011
  EXPECT_EQ(radical_inverse(5, 3), 7. / 9);  // 12 becomes 0.21
  EXPECT_EQ(radical_inverse(9, 10), 0.9);
}

TEST(LowDiscrepancy, SequencesAreThoseOfTheDefinitions) {
  const std::vector<Point2> hammersley = {{0, 0}, {0.5, 0.25}, {0.25, 0.5}, {0.75, 0.75}};
  EXPECT_EQ(hammersley_points(4), hammersley);
  const std::vector<Point2> halton = {{0, 0}, {0.5, 1. / 3}, {0.25, 2. / 3}, {0.75, 1. / 9}};
  EXPECT_EQ(halton_points(4), halton);
  EXPECT_TRUE(hammersley_points(0).empty());
}

TEST(StarDiscrepancy, IsThatOfTheDefinition) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const std::size_t count : {1u, 2u, 7u, 23u}) {
      const auto points = random_points(count, seed);
      EXPECT_NEAR(star_discrepancy(points), slow_discrepancy(points), 1e-15);
    }
}

TEST(StarDiscrepancy, CountsTiesAndCoincidentPoints) {
  for (const std::vector<Point2>& points :
       {std::vector<Point2>{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.25}},
        {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
        {{1, 1}},
        {{0, 0}},
        {{0.25, 0.75}, {0.75, 0.75}, {0.25, 0.25}, {0.75, 0.25}}})
    EXPECT_NEAR(star_discrepancy(points), slow_discrepancy(points), 1e-15);
  EXPECT_EQ(star_discrepancy(std::vector<Point2>{{0, 0}}), 1);
  EXPECT_EQ(star_discrepancy({}), 1);
}

// The rates of section 1.1.2: (log N)^(d-1) / N against the square root of N.
TEST(StarDiscrepancy, OfHammersleyPointsIsFarBelowThatOfRandomOnes) {
  const std::size_t count = 1000;
  const double hammersley = star_discrepancy(hammersley_points(count));
  EXPECT_LT(hammersley, star_discrepancy(halton_points(count)));
  EXPECT_LT(star_discrepancy(halton_points(count)), star_discrepancy(random_points(count, 1)) / 3);
  EXPECT_GT(hammersley, 1. / count);
}

}  // namespace
}  // namespace wellspaced
