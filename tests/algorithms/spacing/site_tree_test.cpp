#include "wellspaced/algorithms/spacing/site_tree.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/point_families.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

Index slow_nearest(const std::vector<Point2>& places, const std::vector<double>& weights, Point2 x,
                   bool odd_only = false) {
  Index best = kNoIndex;
  for (Index i = 0; i < places.size(); ++i) {
    if (std::isinf(weights[i]) || (odd_only && i % 2 == 0)) continue;
    const bool nearer =
        best == kNoIndex ||
        weighted_distance_order({places[i], weights[i]}, {places[best], weights[best]}, x) < 0;
    if (nearer) best = i;
  }
  return best;
}

// Whole weights, so that ties are frequent; some are infinite.
std::vector<double> some_weights(std::size_t n, double unit, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> weights;
  for (std::size_t i = 0; i < n; ++i) {
    const double weight = unit * static_cast<double>(random.below(5));
    weights.push_back(random.below(6) == 0 ? std::numeric_limits<double>::infinity() : weight);
  }
  return weights;
}

TEST(SiteTree, FindsTheNearestSiteOnEveryFamilyOfPoints) {
  for (const auto& [name, points] : test::point_families(70, 3)) {
    const double unit = name == "tiny" ? 0x1p-1074 : name == "huge" ? 0x1p1018 : 0.25;
    const std::vector<double> weights = some_weights(points.size(), unit, 4);
    const SiteTree tree(points, weights);
    for (const Point2 x : points) {
      ASSERT_EQ(tree.nearest(x), slow_nearest(points, weights, x)) << name;
      const auto odd = [](Index i) { return i % 2 == 1; };
      ASSERT_EQ(tree.nearest(x, std::numeric_limits<double>::max(), odd),
                slow_nearest(points, weights, x, true))
          << name;
    }
  }
}

TEST(SiteTree, FindsNothingBeyondTheBound) {
  const std::vector<Point2> places = {{0, 0}, {4, 0}};
  const SiteTree tree(places, std::vector<double>{1, 0});
  const auto any = [](Index) { return true; };
  EXPECT_EQ(tree.nearest({1, 0}, 1.9, any), kNoIndex);
  EXPECT_EQ(tree.nearest({1, 0}, 2, any), 0u);
}

TEST(SiteTree, HasNoNearestSiteWithoutSites) {
  EXPECT_EQ(SiteTree({}).nearest({0, 0}), kNoIndex);
  const std::vector<Point2> one = {{0, 0}};
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(SiteTree(one, std::vector<double>{infinity}).nearest({0, 0}), kNoIndex);
}

TEST(SiteTree, FollowsWeightsThatAreLowered) {
  const std::vector<Point2> places = test::uniform_points(200, 7);
  std::vector<double> weights(places.size(), std::numeric_limits<double>::infinity());
  SiteTree tree(places, weights);
  Random random(8);
  for (int step = 0; step < 200; ++step) {
    const auto i = static_cast<Index>(random.below(places.size()));
    const double weight = std::isinf(weights[i]) ? 1 : weights[i] * random.uniform();
    tree.lower_weight(i, weights[i] = weight);
    const Point2 x{random.uniform(), random.uniform()};
    ASSERT_EQ(tree.nearest(x), slow_nearest(places, weights, x));
  }
}

}  // namespace
}  // namespace wellspaced
