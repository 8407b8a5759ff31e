#include "wellspaced/kernel/plane/quadtree_topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/point_families.hpp"
#include "tests/support/slow_quadtree.hpp"

namespace wellspaced {
namespace {

constexpr QuadtreeBalance kBalances[] = {QuadtreeBalance::kEdge, QuadtreeBalance::kCorner};

struct Case {
  std::string name;
  Quadtree tree;
  QuadtreeBalance balance;
};

// Trees of random points, of points on a lattice, and crowded towards a diagonal and a corner.
std::vector<Case> trees() {
  std::vector<Case> cases;
  auto families = test::point_families(40, 11);
  families.resize(5);
  families.push_back({"one", {{0.5, 0.5}}});
  families.push_back({"corner", {{0, 0}, {1, 1}, {1e-3, 0}, {1e-3, 1e-3}, {0, 2e-3}}});
  for (const auto& family : families)
    for (const QuadtreeBalance balance : kBalances)
      cases.push_back({family.name,
                       quadtree_of_points(Square::around(family.points), family.points, 1, balance),
                       balance});
  return cases;
}

std::vector<Index> sorted_neighbors(const QuadtreeTopology& topology, Index leaf) {
  std::vector<Index> found;
  topology.for_each_neighbor(leaf, [&](Index other) { found.push_back(other); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> sorted_extended_neighbors(const QuadtreeTopology& topology, Index leaf) {
  std::vector<Index> found;
  topology.for_each_extended_neighbor(leaf, [&](Index other) { found.push_back(other); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(QuadtreeTopology, KnowsTheNeighborsOfEveryLeafEachOnce) {
  for (const auto& [name, tree, balance] : trees()) {
    const QuadtreeTopology topology(tree);
    const auto boxes = test::slow_boxes(tree);
    for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
      std::vector<Index> neighbors, extended;
      for (Index other = 0; other < tree.leaves(); ++other) {
        if (test::are_neighbors(boxes[leaf], boxes[other])) neighbors.push_back(other);
        if (test::are_extended_neighbors(boxes[leaf], boxes[other])) extended.push_back(other);
      }
      EXPECT_EQ(sorted_neighbors(topology, leaf), neighbors) << name << ' ' << leaf;
      EXPECT_EQ(sorted_extended_neighbors(topology, leaf), extended) << name << ' ' << leaf;
    }
  }
}

TEST(QuadtreeTopology, CoarsensAsFigureFiveFourteenDoesStepByStep) {
  for (auto& [name, tree, balance] : trees()) {
    for (int step = 0; tree.leaves() > 1 && step < 40; ++step) {
      const auto expected = test::slow_coarsened(tree, balance);
      const Index before = tree.leaves();
      tree = coarsened(tree, QuadtreeTopology(tree), balance);
      const auto boxes = test::slow_boxes(tree);
      EXPECT_EQ(std::set(boxes.begin(), boxes.end()), expected) << name << ' ' << step;
      EXPECT_TRUE(test::is_balanced(tree, balance)) << name << ' ' << step;
      EXPECT_LT(tree.leaves(), before);
    }
    EXPECT_EQ(tree.leaves(), 1u) << name;
  }
}

TEST(QuadtreeTopology, TestsAllFourSiblingsAsTheErratumSays) {
  // The south-west quarter is split, and its north-east quarter again. Then nothing but the
  // smallest boxes may go: the box that they leave keeps the others from it.
  const Quadtree tree(Square{},
                      {0, morton::cells_in(2), 2 * morton::cells_in(2), 3 * morton::cells_in(2),
                       3 * morton::cells_in(2) + morton::cells_in(3),
                       3 * morton::cells_in(2) + 2 * morton::cells_in(3),
                       3 * morton::cells_in(2) + 3 * morton::cells_in(3), morton::cells_in(1),
                       2 * morton::cells_in(1), 3 * morton::cells_in(1)});
  const Quadtree coarser = coarsened(tree, QuadtreeTopology(tree), QuadtreeBalance::kEdge);
  EXPECT_EQ(coarser.leaves(), 7u);
  EXPECT_EQ(coarsened(coarser, QuadtreeTopology(coarser), QuadtreeBalance::kEdge).leaves(), 4u);
}

}  // namespace
}  // namespace wellspaced
