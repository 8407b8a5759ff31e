#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using Kind = BoundaryCurve::Kind;

// Closed curves with the domain on the left, on nodes numbered one after the other.
struct Curves {
  Boundary boundary;
  std::vector<Point2> points;

  Curves& add(const std::vector<Point2>& nodes, Kind kind = Kind::kDomain, bool closed = true) {
    BoundaryCurve curve{kind, closed, {}, std::vector<int>(nodes.size() - (closed ? 0 : 1), 1)};
    for (const Point2 p : nodes) {
      curve.nodes.push_back(static_cast<Index>(points.size()));
      points.push_back(p);
    }
    boundary.curves.push_back(curve);
    return *this;
  }
  ContractedBoundary contracted_to(const std::vector<Index>& selected) const {
    std::vector<std::uint8_t> survives(points.size(), 0);
    for (const Index v : selected) survives[v] = 1;
    return {boundary, points, contract_boundary(boundary, points, survives)};
  }
  std::vector<std::size_t> broken(const std::vector<Index>& selected) const {
    return contracted_to(selected).broken_edges(selected);
  }
};

using Edges = std::vector<std::size_t>;

// 0 (0,0), 1 (4,0), 2 (4,4), 3 (0,4): a square, with nodes between.
Curves square() {
  Curves curves;
  curves.add({{0, 0}, {1, -1}, {3, -1}, {4, 0}, {4, 4}, {0, 4}});
  return curves;
}

TEST(ContractBoundary, JoinsSurvivorsInTheirOrderAlongTheCurve) {
  const Curves curves = square();
  const ContractedBoundary contracted = curves.contracted_to({0, 3, 5});
  const auto& edges = contracted.edges();
  ASSERT_EQ(edges.size(), 3u);
  EXPECT_EQ(edges[0].a, 0u);
  EXPECT_EQ(edges[0].b, 3u);
  EXPECT_EQ(edges[0].steps, 3u);
  EXPECT_EQ(edges[1].b, 5u);
  EXPECT_EQ(edges[2].b, 0u);
  EXPECT_EQ(edges[2].steps, 1u);
  EXPECT_EQ(chain_points(curves.boundary, curves.points, edges[0]),
            (std::vector<Point2>{{0, 0}, {1, -1}, {3, -1}, {4, 0}}));
  EXPECT_EQ(middle_node(curves.boundary, edges[0]), 1u);
}

TEST(ContractBoundary, TakesTheMarkerOfTheFirstEdgeOfEachChain) {
  Curves curves = square();
  std::iota(curves.boundary.curves[0].markers.begin(), curves.boundary.curves[0].markers.end(), 1);
  const auto edges = curves.contracted_to({2, 4}).edges();
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_EQ(edges[0].marker, 3);
  EXPECT_EQ(edges[1].marker, 5);
}

TEST(ContractBoundary, LosesCurvesWithoutTwoSurvivors) {
  EXPECT_TRUE(square().contracted_to({}).edges().empty());
  EXPECT_TRUE(square().contracted_to({4}).edges().empty());
}

TEST(ContractBoundary, KeepsOpenCurvesOpen) {
  Curves curves;
  curves.add({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, Kind::kInner, false);
  EXPECT_EQ(curves.contracted_to({0, 3}).edges().size(), 1u);
  EXPECT_EQ(curves.contracted_to({0, 1, 3}).edges().size(), 2u);
}

TEST(BrokenEdges, AreNoneOnAConvexCurve) {
  EXPECT_EQ(square().broken({0, 3, 4, 5}), Edges());
  EXPECT_EQ(square().broken({0, 2, 4}), Edges());
}

TEST(BrokenEdges, CrossAnother) {
  Curves curves = square();
  curves.add({{2, -0.5}, {2, 1}, {3, 0.5}});  // a hole that reaches into the bulge under edge 0, 3
  EXPECT_EQ(curves.broken({0, 1, 2, 3, 4, 5, 6, 7, 8}), Edges());
  EXPECT_EQ(curves.broken({0, 3, 4, 5, 6, 7, 8}), (Edges{0}));
}

// Figure 7.5: without the nodes between, both curves would lie across each other.
TEST(BrokenEdges, AreBothOfTwoChainsThatCross) {
  Curves curves;
  curves.add({{0, 0}, {4, 0}, {4, 4}, {9, -9}});
  curves.add({{1, 3}, {2, 3}, {3, 1}, {0, 9}});
  EXPECT_EQ(curves.broken({0, 1, 2, 3, 4, 5, 6, 7}), Edges());
  EXPECT_EQ(curves.broken({0, 2, 3, 4, 6, 7}), (Edges{0, 3}));
}

TEST(BrokenEdges, PassThroughASelectedNode) {
  Curves curves = square();
  curves.add({{2, 0}, {2, 2}, {3, 1}});  // a hole whose tip lies on the edge from 0 to 3
  EXPECT_EQ(curves.broken({0, 2, 3, 4, 5, 6, 7, 8}), Edges());
  EXPECT_EQ(curves.broken({0, 3, 4, 5, 6, 7, 8}), (Edges{0}));
}

TEST(BrokenEdges, JumpOverASelectedNode) {
  Curves curves = square();
  curves.add({{2, -0.9}, {1.5, -0.5}, {2.5, -0.5}});  // a hole in the bulge under the edge 0 to 3
  EXPECT_EQ(curves.broken({0, 1, 2, 3, 4, 5, 6, 7, 8}), Edges());
  EXPECT_EQ(curves.broken({0, 3, 4, 5, 6, 7, 8}), (Edges{0}));
}

TEST(BrokenEdges, JoinTheNodesOfAnotherEdge) {
  EXPECT_EQ(square().broken({0, 3}), (Edges{0, 1})) << "the square has closed";
  Curves curves;
  curves.add({{0, 0}, {4, 0}, {2, 3}});
  EXPECT_EQ(curves.broken({0, 1}), (Edges{1})) << "an edge that has not moved gets no node back";
}

TEST(LeavesOutside, AgreesWithTheRegionBetweenTheCurves) {
  const Curves curves = square();
  const ContractedBoundary contracted = curves.contracted_to({0, 3, 4, 5});
  EXPECT_TRUE(contracted.leaves_outside({2, -0.5})) << "in the bulge that is cut off";
  EXPECT_TRUE(contracted.leaves_outside({2, 0})) << "on the new edge";
  EXPECT_FALSE(contracted.leaves_outside({2, 0.5}));
  EXPECT_FALSE(curves.contracted_to({0, 1, 2, 3, 4, 5}).leaves_outside({2, -0.5}));
}

TEST(LeavesOutside, DoesNotMindInnerCurves) {
  Curves curves;
  curves.add({{0, 0}, {2, 2}, {4, 0}}, Kind::kInner, false);
  EXPECT_FALSE(curves.contracted_to({0, 2}).leaves_outside({2, 1}));
  EXPECT_TRUE(curves.contracted_to({0, 2}).leaves_outside({2, 0})) << "on the new edge";
}

TEST(ContractAndRepair, TakesNodesBackUntilNothingIsBroken) {
  Curves curves = square();
  curves.add({{2, -0.9}, {1.5, -0.5}, {2.5, -0.5}});
  const auto nodes = static_cast<Index>(curves.points.size());
  NodeSelection selection(nodes, curves.boundary.twins, [](Index, std::vector<Conflict>&) {});
  selection.force(std::vector<Index>{0, 3, 4, 5, 6, 7, 8});
  const ContractedBoundary repaired =
      contract_and_repair(curves.boundary, curves.points, selection);
  EXPECT_TRUE(selection.is_selected(1) || selection.is_selected(2));
  EXPECT_TRUE(repaired.broken_edges(selection.selected()).empty());
}

}  // namespace
}  // namespace wellspaced
