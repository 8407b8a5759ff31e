#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/point_families.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/algorithms/spacing/threshold_spacing.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

struct Sample {
  std::vector<Point2> points;
  std::vector<double> g;
};

// Points whose density grows towards a corner, with NN.
Sample graded_sample(int n, std::uint64_t seed) {
  Sample sample{test::uniform_points(n, seed), {}};
  for (Point2& p : sample.points) p = {p.x * p.x * p.x, p.y * p.y * p.y};
  sample.g = nearest_neighbor_spacing(sample.points);
  return sample;
}

TEST(EuclideanCoarseningFunction, IsTheLowestOfAllCones) {
  const Sample s = graded_sample(200, 1);
  const EuclideanCoarseningFunction f(s.points, s.g, 5);
  Random random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const Point2 x{random.uniform(-1, 2), random.uniform(-1, 2)};
    double expected = HUGE_VAL;
    for (std::size_t q = 0; q < s.points.size(); ++q)
      expected = std::min(expected, 5 * s.g[q] + distance(s.points[q], x));
    EXPECT_DOUBLE_EQ(f(x), expected);
  }
  const auto at_points = euclidean_coarsened_spacing(s.points, s.g, 5);
  for (std::size_t v = 0; v < s.points.size(); ++v) EXPECT_EQ(at_points[v], f(s.points[v]));
}

// Half the points on a circle, all of one g, the others crowded about its centre: a search looks at
// all cones from each of these.
TEST(EuclideanCoarseningFunction, IsExactWhereAllConesAreNearlyAsLow) {
  constexpr Index n = 12000;
  for (const double crowd : {1e-3, 1e-10}) {
    Random random(4);
    Sample s;
    for (Index i = 0; i < n; ++i) {
      const Point2 on_circle = circle_point(static_cast<double>(i) / n);
      const Point2 inside{crowd * random.uniform(-1, 1), crowd * random.uniform(-1, 1)};
      s.points.push_back(i % 2 == 0 ? on_circle : inside);
      s.g.push_back(i % 2 == 0 ? 0.001 : 10);
    }
    const auto f = euclidean_coarsened_spacing(s.points, s.g, 1);
    for (Index v = 0; v < n; v += 97) {
      double exact = HUGE_VAL;
      for (Index q = 0; q < n; ++q)
        exact = std::min(exact, s.g[q] + distance(s.points[q], s.points[v]));
      EXPECT_GE(f[v], exact * (1 - 1e-15));
      EXPECT_LE(f[v], exact * (1 + 1e-15));
    }
  }
}

// Lemma 5.4.1, for f and t.
TEST(EuclideanCoarseningFunction, IsOneLipschitz) {
  const Sample s = graded_sample(150, 3);
  const EuclideanCoarseningFunction f(s.points, s.g, 4);
  const auto at_points = f.at_points(), t = threshold_spacing(s.g, 4);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      const double d = distance(s.points[v], s.points[w]) * (1 + 1e-12);
      EXPECT_LE(std::fabs(at_points[v] - at_points[w]), d);
      EXPECT_LE(std::fabs(t[v] - t[w]), d);
    }
  }
}

// Lemma 5.4.2.
TEST(EuclideanCoarseningFunction, IsMonotoneInTheFactorAndGrowsAtMostInProportion) {
  const Sample s = graded_sample(300, 4);
  const auto by_2 = euclidean_coarsened_spacing(s.points, s.g, 2);
  const auto by_6 = euclidean_coarsened_spacing(s.points, s.g, 6);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    EXPECT_LE(by_2[v], by_6[v]);
    EXPECT_LE(by_6[v], 3 * by_2[v] * (1 + 1e-14));
  }
}

// Lemma 5.4.3: no 1-Lipschitz function below C g on the points is above f anywhere.
TEST(EuclideanCoarseningFunction, IsTheGreatestLipschitzFunctionBelowTheScaledSpacing) {
  const Sample s = graded_sample(200, 5);
  const EuclideanCoarseningFunction f(s.points, s.g, 3);
  Random random(6);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<double> lower = s.g;
    for (double& value : lower) value *= random.uniform();
    const EuclideanCoarseningFunction h(s.points, lower, 3);  // 1-Lipschitz, at most 3 g
    for (int i = 0; i < 100; ++i) {
      const Point2 x{random.uniform(-1, 2), random.uniform(-1, 2)};
      EXPECT_LE(h(x), f(x));
    }
  }
}

// Lemma 5.4.4.
TEST(EuclideanCoarseningFunction, IsTheSameStepByStepAndAtOnce) {
  const Sample s = graded_sample(300, 7);
  std::vector<double> step_by_step = s.g;
  for (int i = 1; i <= 6; ++i) {
    step_by_step = euclidean_coarsened_spacing(s.points, step_by_step, 2);
    const auto at_once = euclidean_coarsened_spacing(s.points, s.g, 1 << i);
    for (std::size_t v = 0; v < s.points.size(); ++v)
      EXPECT_NEAR(step_by_step[v], at_once[v], 1e-13 * at_once[v]);
  }
}

// The first half of Lemma 5.4.5: t <= f.
TEST(ThresholdSpacing, IsNowhereAboveTheCoarseningFunction) {
  const Sample s = graded_sample(400, 8);
  for (const double factor : {1.5, 3., 24., 1000.}) {
    const auto t = threshold_spacing(s.g, factor);
    const auto f = euclidean_coarsened_spacing(s.points, s.g, factor);
    for (std::size_t v = 0; v < s.points.size(); ++v) EXPECT_LE(t[v], f[v] * (1 + 1e-15));
  }
}

TEST(ThresholdSpacing, RaisesWhatIsBelowTheThresholdAlone) {
  EXPECT_EQ(threshold_spacing(std::vector<double>{1, 2, 5}, 3), (std::vector<double>{3, 3, 5}));
  EXPECT_TRUE(threshold_spacing({}, 3).empty());
}

TEST(SpacingFunction, OfTheUserIsMadeLipschitzByTheCoarseningFunction) {
  const std::vector<Point2> points = test::uniform_points(300, 9);
  const SpacingFunction step = [](Point2 p) { return p.x < 0.5 ? 0.01 : 10; };
  const auto f = euclidean_coarsened_spacing(points, sampled(step, points), 2);
  for (std::size_t v = 0; v < points.size(); ++v) {
    EXPECT_LE(f[v], 2 * step(points[v]));
    for (std::size_t w = 0; w < v; ++w)
      EXPECT_LE(std::fabs(f[v] - f[w]), distance(points[v], points[w]) * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace wellspaced
