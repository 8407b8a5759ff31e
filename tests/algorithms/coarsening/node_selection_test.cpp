#include "wellspaced/algorithms/coarsening/node_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/slow_shortest_paths.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::random_graph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> random_function(const Graph& graph, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> g(graph.nodes());
  for (double& value : g) value = random.uniform(0, 30);
  return coarsened_spacing(graph, g, 1);
}

std::set<Index> conflicts_of(const ConflictRule& rule, Index node) {
  std::vector<Index> list;
  rule(node, list);
  std::set<Index> result(list.begin(), list.end());
  EXPECT_EQ(result.size(), list.size()) << "told twice";
  result.erase(node);
  return result;
}

TEST(FunctionConflicts, AreAllPairsOfTheDefinition) {
  for (const double beta : {1.2, 2.0, 3.5, 25.0}) {
    const Graph graph = random_graph(7);
    const auto f = random_function(graph, 3);
    const ConflictRule rule = function_conflicts(graph, f, beta);
    for (Index i = 0; i < graph.nodes(); i += 5) {
      std::vector<double> start(graph.nodes(), kInfinity);
      start[i] = 0;
      const auto d = test::bellman_ford(graph, start);
      std::set<Index> expected;
      for (Index j = 0; j < graph.nodes(); ++j)
        if (j != i && f[i] + f[j] > beta * d[j] && d[j] <= 3 * f[i] / beta) expected.insert(j);
      EXPECT_EQ(conflicts_of(rule, i), expected) << "beta " << beta << ", node " << i;
    }
  }
}

TEST(FunctionConflicts, AreStrict) {
  const Graph graph{{0, 1, 2}, {{1, 2.0}, {0, 2.0}}};  // two nodes 2 apart
  const std::vector<double> touching = {2, 2}, overlapping = {2, 2.0000001};
  EXPECT_TRUE(conflicts_of(function_conflicts(graph, touching, 2), 0).empty());
  EXPECT_FALSE(conflicts_of(function_conflicts(graph, overlapping, 2), 0).empty());
}

TEST(NeighborConflicts, AreTheEdges) {
  const Graph graph = random_graph(2);
  const ConflictRule rule = neighbor_conflicts(graph);
  for (Index v = 0; v < graph.nodes(); ++v) {
    std::set<Index> expected;
    for (const auto& arc : graph.arcs_of(v)) expected.insert(arc.target);
    EXPECT_EQ(conflicts_of(rule, v), expected);
  }
}

// A path 0 - 1 - ... - 9.
Graph path() {
  Graph graph{{0}, {}};
  for (Index v = 0; v < 10; ++v) {
    if (v > 0) graph.arcs.push_back({v - 1, 1});
    if (v < 9) graph.arcs.push_back({v + 1, 1});
    graph.first.push_back(static_cast<Index>(graph.arcs.size()));
  }
  return graph;
}

TEST(NodeSelection, IsMaximalAndWithoutConflicts) {
  const Graph graph = random_graph(5);
  const auto f = random_function(graph, 5);
  const TwinNodes no_twins;
  NodeSelection selection(graph.nodes(), no_twins, function_conflicts(graph, f, 6));
  for (Index v = 0; v < graph.nodes(); ++v) selection.select(v);
  const ConflictRule rule = function_conflicts(graph, f, 6);
  for (Index v = 0; v < graph.nodes(); ++v) {
    const auto conflicts = conflicts_of(rule, v);
    const bool conflicts_with_selected =
        std::ranges::any_of(conflicts, [&](Index w) { return selection.is_selected(w); });
    EXPECT_NE(selection.is_selected(v), conflicts_with_selected);
  }
}

TEST(NodeSelection, ForcesNodesThatConflictWithEachOther) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  selection.force(std::vector<Index>{3, 4});
  EXPECT_FALSE(selection.is_free(2));
  EXPECT_FALSE(selection.is_free(5));
  for (Index v = 0; v < 10; ++v) selection.select(v);
  EXPECT_EQ(selection.selected(), (std::vector<Index>{0, 3, 4, 6, 8}));
}

TEST(NodeSelection, PassesOverInvalidNodes) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  selection.invalidate(0);
  for (Index v = 0; v < 10; ++v) selection.select(v);
  EXPECT_EQ(selection.selected(), (std::vector<Index>{1, 3, 5, 7, 9}));
}

TEST(NodeSelection, NeverTakesBackWhatIsSelected) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  selection.select(5);
  selection.invalidate(5);
  EXPECT_TRUE(selection.is_selected(5));
}

TEST(NodeSelection, KeepsOrDropsTwinsAsOne) {
  const Graph graph = path();
  const TwinNodes twins{{0, 1, 8, 3, 4, 5, 6, 7, 2, 9}};  // 2 and 8
  NodeSelection kept(10, twins, neighbor_conflicts(graph));
  kept.select(2);
  EXPECT_TRUE(kept.is_selected(8));
  for (const Index v : {1, 3, 7, 9}) EXPECT_FALSE(kept.is_free(v));

  NodeSelection dropped(10, twins, neighbor_conflicts(graph));
  dropped.select(9);
  EXPECT_FALSE(dropped.is_free(2)) << "8 is in conflict with 9";
  dropped.select(2);
  EXPECT_EQ(dropped.selected(), (std::vector<Index>{9}));
}

}  // namespace
}  // namespace wellspaced
