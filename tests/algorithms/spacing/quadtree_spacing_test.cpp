#include "wellspaced/algorithms/spacing/quadtree_spacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/support/point_families.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRoundoff = 1e-12;
constexpr double kSqrt2 = std::numbers::sqrt2;

// Points crowded around a place inside, so that leaves of many sizes meet.
Quadtree graded_tree(std::uint64_t seed, std::size_t n = 60) {
  Random random(seed);
  const Point2 crowd{random.uniform(), random.uniform()};
  std::vector<Point2> points{{0, 0}, {1, 1}};
  while (points.size() < n) {
    const double r = std::ldexp(1.0, -static_cast<int>(random.below(12)));
    const double x = crowd.x + r * (random.uniform() - 0.5);
    const double y = crowd.y + r * (random.uniform() - 0.5);
    points.push_back({std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)});
  }
  return quadtree_of_points(Square::around(points), points, 1, QuadtreeBalance::kEdge);
}

double half_side(const Quadtree& tree, Index leaf) { return tree.side(leaf) / 2; }

double slow_cone_value(const Quadtree& tree, Point2 x) {
  double value = kInfinity;
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf)
    value = std::min(value, half_side(tree, leaf) + distance(x, tree.centre(leaf)));
  return value;
}

double slow_envelope_value(const Quadtree& tree, Point2 x) {
  double value = kInfinity;
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
    value = std::min(value, half_side(tree, leaf) + distance_to_box(tree.box(leaf), x));
  }
  return value;
}

// Places in a leaf: its corners, centre and some at random.
std::vector<Point2> places_in(const Quadtree& tree, Index leaf, Random& random) {
  const Box2 box = tree.box(leaf);
  std::vector<Point2> places{
      box.low, box.high, {box.low.x, box.high.y}, {box.high.x, box.low.y}, tree.centre(leaf)};
  for (int i = 0; i < 5; ++i)
    places.push_back(
        {random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)});
  return places;
}

template <class Visit>
void for_each_place(const Quadtree& tree, Visit visit) {
  const QuadtreeTopology topology(tree);
  Random random(5);
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf)
    for (const Point2 x : places_in(tree, leaf, random))
      visit(LeafSpacing(tree, topology, leaf), x);
}

TEST(QuadtreeSpacing, IsDecidedByTheLeavesAroundAsLemma583Says) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Quadtree tree = graded_tree(seed);
    for_each_place(tree, [&](const LeafSpacing& leaf, Point2 x) {
      EXPECT_NEAR(leaf.cone_value(x), slow_cone_value(tree, x), kRoundoff);
      EXPECT_NEAR(leaf.envelope_value(x), slow_envelope_value(tree, x), kRoundoff);
    });
  }
}

TEST(QuadtreeSpacing, StaysWithinTheCorrectedBoundsOfLemma583AndAttainsThem) {
  double least = kInfinity, greatest = 0, least_envelope = kInfinity, greatest_envelope = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for_each_place(graded_tree(seed), [&](const LeafSpacing& leaf, Point2 x) {
      const double cone = leaf.cone_value(x) / leaf.box_value();
      const double envelope = leaf.envelope_value(x) / leaf.box_value();
      least = std::min(least, cone), greatest = std::max(greatest, cone);
      least_envelope = std::min(least_envelope, envelope);
      greatest_envelope = std::max(greatest_envelope, envelope);
    });
  EXPECT_NEAR(least, (1 + kSqrt2) / 4, kRoundoff);
  EXPECT_NEAR(greatest, 1 + kSqrt2, kRoundoff);
  EXPECT_NEAR(least_envelope, 0.25, kRoundoff);
  EXPECT_EQ(greatest_envelope, 1);
}

TEST(QuadtreeSpacing, IsLipschitz) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Quadtree tree = graded_tree(seed);
    const QuadtreeTopology topology(tree);
    Random random(seed);
    const auto spacing = [&](Point2 x) { return LeafSpacing(tree, topology, tree.locate(x)); };
    for (int i = 0; i < 2000; ++i) {
      const Point2 x{random.uniform(), random.uniform()};
      const double reach = std::ldexp(1.0, -static_cast<int>(random.below(12)));
      const Point2 y{std::clamp(x.x + reach * (random.uniform() - 0.5), 0.0, 1.0),
                     std::clamp(x.y + reach * (random.uniform() - 0.5), 0.0, 1.0)};
      const double apart = distance(x, y) + kRoundoff;
      EXPECT_LE(std::fabs(spacing(x).cone_value(x) - spacing(y).cone_value(y)), apart);
      EXPECT_LE(std::fabs(spacing(x).envelope_value(x) - spacing(y).envelope_value(y)), apart);
    }
  }
}

// f_{i+1}(x) = min over all places of 2 f_i + distance.
std::vector<double> coarsened_by_two(const std::vector<Point2>& places,
                                     const std::vector<double>& f) {
  std::vector<double> coarser(f.size(), kInfinity);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < f.size(); ++j)
      coarser[i] = std::min(coarser[i], 2 * f[j] + distance(places[i], places[j]));
  return coarser;
}

TEST(QuadtreeSpacing, OfCoarsenedTreesStaysSimilarToCoarseningFunctionsAsTheorem585Says) {
  constexpr double kA = 0.07;  // as corrected
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Quadtree tree = graded_tree(seed, 40);
    std::vector<Point2> places;
    std::vector<double> f;
    const QuadtreeTopology finest(tree);
    for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
      places.push_back(tree.centre(leaf));
      f.push_back(LeafSpacing(tree, finest, leaf).cone_value(places.back()));
    }
    while (tree.leaves() > 1) {
      tree = coarsened(tree, QuadtreeTopology(tree), QuadtreeBalance::kEdge);
      f = coarsened_by_two(places, f);
      const QuadtreeTopology topology(tree);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const LeafSpacing leaf(tree, topology, tree.locate(places[i]));
        EXPECT_GT(leaf.box_value(), kA * f[i]);
        EXPECT_GT(leaf.cone_value(places[i]), kA * f[i]);
        EXPECT_GT(leaf.envelope_value(places[i]), kA * f[i]);
      }
    }
  }
}

}  // namespace
}  // namespace wellspaced
