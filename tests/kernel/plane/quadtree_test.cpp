#include "wellspaced/kernel/plane/quadtree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/point_families.hpp"
#include "tests/support/slow_quadtree.hpp"

namespace wellspaced {
namespace {

using test::SlowBox;

constexpr QuadtreeBalance kBalances[] = {QuadtreeBalance::kEdge, QuadtreeBalance::kCorner};

bool holds(const SlowBox& box, MortonCode cell) {
  return morton::column(cell) >= box.x && morton::column(cell) < box.x + box.side &&
         morton::row(cell) >= box.y && morton::row(cell) < box.y + box.side;
}

std::vector<MortonCode> cells_of(const Square& square, std::span<const Point2> points) {
  std::vector<MortonCode> cells;
  for (const Point2 p : points) cells.push_back(square.cell_of(p));
  return cells;
}

std::set<SlowBox> as_set(const Quadtree& tree) {
  const auto boxes = test::slow_boxes(tree);
  return {boxes.begin(), boxes.end()};
}

// Crowded towards a corner: the distance from it is exponentially distributed.
std::vector<Point2> log_radial_points(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double r = std::ldexp(1.0, -static_cast<int>(random.below(20)));
    const double x = r * random.uniform();
    points.push_back({x, r * random.uniform()});
  }
  return points;
}

TEST(Quadtree, OfNoPointsIsOneLeaf) {
  const Quadtree tree = quadtree_of_points({}, {}, 1, QuadtreeBalance::kEdge);
  ASSERT_EQ(tree.leaves(), 1u);
  EXPECT_EQ(tree.depth(0), 0);
  EXPECT_EQ(tree.side(0), 2);
  EXPECT_EQ(tree.centre(0), Point2{});
}

TEST(Quadtree, OfTwoPointsIsAsDeepAsTheirFirstCommonBox) {
  const std::vector<Point2> points{{0.1, 0.1}, {0.3, 0.1}};
  const Quadtree tree = quadtree_of_points({{0.5, 0.5}, 0.5}, points, 1, QuadtreeBalance::kEdge);
  EXPECT_EQ(tree.leaves(), 7u);
  EXPECT_EQ(tree.box(tree.locate(points[0])).high, (Point2{0.25, 0.25}));
  EXPECT_EQ(tree.box(tree.locate(points[1])).low, (Point2{0.25, 0}));
}

TEST(Quadtree, OfPointsIsTheCoarsestBalancedOne) {
  auto families = test::point_families(40, 5);
  families.push_back({"log_radial", log_radial_points(40, 6)});
  for (const auto& family : families)
    for (const QuadtreeBalance balance : kBalances)
      for (const std::size_t max_points : {1, 3}) {
        const Square square = Square::around(family.points);
        auto cells = cells_of(square, family.points);
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        const auto is_crowded = [&](const SlowBox& box) {
          const auto inside = [&](MortonCode cell) { return holds(box, cell); };
          return std::count_if(cells.begin(), cells.end(), inside) >
                 static_cast<std::ptrdiff_t>(max_points);
        };
        const Quadtree tree = quadtree_of_points(square, family.points, max_points, balance);
        if (tree.leaves() > 400) continue;  // beyond the patience of the slow one
        EXPECT_TRUE(as_set(tree) == test::slow_quadtree(is_crowded, balance)) << family.name;
      }
}

TEST(Quadtree, OfSizesIsTheCoarsestBalancedOne) {
  const auto points = test::uniform_points(40, 7);
  Random random(8);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < points.size(); ++i) sizes.push_back(random.uniform(0.02, 2));
  const Square square = Square::around(points);
  const auto cells = cells_of(square, points);
  for (const QuadtreeBalance balance : kBalances) {
    const auto is_too_large = [&](const SlowBox& box) {
      const double side = static_cast<double>(box.side) * 0x1p-30 * square.half_side;
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (holds(box, cells[i]) && side > sizes[i]) return true;
      return false;
    };
    const Quadtree tree = quadtree_of_sizes(square, points, sizes, balance);
    EXPECT_TRUE(as_set(tree) == test::slow_quadtree(is_too_large, balance));
  }
}

TEST(Quadtree, OverlayIsAsFineAsTheFinerEverywhere) {
  for (const QuadtreeBalance balance : kBalances) {
    const Square square{{0.5, 0.5}, 0.5};
    const Quadtree a = quadtree_of_points(square, log_radial_points(60, 7), 1, balance);
    const Quadtree b = quadtree_of_points(square, test::uniform_points(90, 8), 1, balance);
    const Quadtree both = overlay(a, b);
    EXPECT_TRUE(test::is_balanced(both, balance));
    for (Index leaf = 0; leaf < both.leaves(); ++leaf) {
      const MortonCode cell = both.start(leaf);
      EXPECT_EQ(both.depth(leaf), std::max(a.depth(a.locate(cell)), b.depth(b.locate(cell))));
    }
    EXPECT_EQ(as_set(overlay(b, a)), as_set(both));
    EXPECT_EQ(as_set(overlay(a, Quadtree(square))), as_set(a));
  }
}

TEST(Quadtree, CountsEqualPointsOnce) {
  std::vector<Point2> points(5, Point2{3, 4});
  const auto leaves = [&] {
    return quadtree_of_points(Square::around(points), points, 1, QuadtreeBalance::kEdge).leaves();
  };
  EXPECT_EQ(leaves(), 1u);
  points.push_back({4, 4});
  EXPECT_EQ(leaves(), 4u);
}

TEST(Quadtree, LeavesNeitherGapNorOverlap) {
  const auto points = log_radial_points(3000, 9);
  const Quadtree tree =
      quadtree_of_points(Square::around(points), points, 1, QuadtreeBalance::kEdge);
  EXPECT_EQ(tree.start(0), 0u);
  EXPECT_EQ(tree.start(tree.leaves()), morton::cells_in(0));
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
    EXPECT_EQ(tree.start(leaf) + morton::cells_in(tree.depth(leaf)), tree.start(leaf + 1));
    EXPECT_LE(morton::coarsest_depth(tree.start(leaf)), tree.depth(leaf));
    EXPECT_EQ(tree.locate(tree.centre(leaf)), leaf);
  }
}

TEST(Quadtree, LocatesPointsInTheirBoxesAndOutsideOnesNextToThem) {
  const auto points = log_radial_points(500, 10);
  const Quadtree tree =
      quadtree_of_points(Square::around(points), points, 1, QuadtreeBalance::kCorner);
  for (const Point2 p : points) {
    const Box2 around{{p.x - 1e-15, p.y - 1e-15}, {p.x + 1e-15, p.y + 1e-15}};
    EXPECT_TRUE(tree.box(tree.locate(p)).meets(around));
  }
  EXPECT_EQ(tree.locate({-1e300, -1e308}), 0u);
  EXPECT_EQ(tree.locate({1e308, 1e308}), tree.leaves() - 1);
}

TEST(Quadtree, OfASpacingFunctionApproximatesItAsTheoremFiveEightFourSays) {
  // The distance from a curve, kept off zero.
  const auto g = [](Point2 p) { return 0.004 + std::fabs(p.y - p.x * p.x) / 3; };
  const auto least_in = [&](const Box2& box) {
    const double low = box.low.x * box.low.x, high = box.high.x * box.high.x;
    const double gap = std::max({box.low.y - high, low - box.high.y, 0.0});
    return 0.004 + gap / 3;
  };
  for (const QuadtreeBalance balance : kBalances) {
    const auto tree = quadtree_of_spacing({{0.5, 0.5}, 0.5}, least_in, balance);
    ASSERT_TRUE(tree.ok());
    EXPECT_GT(tree->leaves(), 1000u);
    double worst = 0;
    for (Index leaf = 0; leaf < tree->leaves(); ++leaf) {
      const Box2 box = tree->box(leaf);
      EXPECT_LE(tree->side(leaf), least_in(box));
      for (const Point2 corner : {box.low, box.high, Point2{box.low.x, box.high.y}})
        worst = std::max(worst, g(corner) / tree->side(leaf));
    }
    EXPECT_LE(worst, 5 * std::numbers::sqrt2);
    EXPECT_GT(worst, 2);
  }
}

TEST(Quadtree, OfASpacingFunctionStopsAtTheAllowedNumberOfLeaves) {
  const auto tree = quadtree_of_spacing(
      {}, [](const Box2&) { return 0.0; }, QuadtreeBalance::kEdge, 1000);
  ASSERT_FALSE(tree.ok());
  EXPECT_EQ(tree.error().code, ErrorCode::kLimit);
}

}  // namespace
}  // namespace wellspaced
