#include "wellspaced/algorithms/coarsening/node_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
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
  std::vector<Conflict> list;
  rule(node, list);
  std::set<Index> all, holding;
  for (const Conflict& c : list) {
    EXPECT_TRUE(all.insert(c.node).second) << "told twice";
    if (c.holds && c.node != node) holding.insert(c.node);
  }
  return holding;
}

// Keys by which nodes come in the order of their numbers.
std::vector<std::uint64_t> ascending_keys(Index nodes) {
  std::vector<std::uint64_t> keys(nodes);
  std::iota(keys.begin(), keys.end(), std::uint64_t{0});
  return keys;
}

std::vector<Index> all_nodes(Index nodes) {
  std::vector<Index> list(nodes);
  std::iota(list.begin(), list.end(), Index{0});
  return list;
}

void select_in_order(NodeSelection& selection, Index nodes) {
  EXPECT_TRUE(selection.select(all_nodes(nodes), ascending_keys(nodes), [] { return true; }));
}

// What the definition says: one after the other.
std::vector<Index> greedy(const Graph& graph, const ConflictRule& rule,
                          std::span<const std::uint64_t> keys) {
  std::vector<Index> order = all_nodes(graph.nodes());
  std::ranges::sort(order, {}, [&](Index v) { return keys[v]; });
  std::set<Index> selected, invalid;
  for (const Index v : order) {
    const auto conflicts = conflicts_of(rule, v);
    const auto is_selected = [&](Index w) { return selected.contains(w); };
    if (invalid.contains(v) || std::ranges::any_of(conflicts, is_selected)) continue;
    selected.insert(v);
    invalid.insert(conflicts.begin(), conflicts.end());
  }
  return {selected.begin(), selected.end()};
}

TEST(FunctionConflicts, AreAllPairsOfTheDefinition) {
  for (const double beta : {1.2, 2.0, 3.5, 25.0}) {
    const Graph graph = random_graph(7);
    const auto f = random_function(graph, 3);
    LocalSearch search(graph);
    const ConflictRule rule = function_conflicts(search, f, beta);
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
  LocalSearch search(graph);
  EXPECT_TRUE(conflicts_of(function_conflicts(search, touching, 2), 0).empty());
  EXPECT_FALSE(conflicts_of(function_conflicts(search, overlapping, 2), 0).empty());
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

TEST(NodeSelection, IsThatOfTheGreedyRuleInTheOrderOfTheKeys) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Graph graph = random_graph(seed);
    const auto f = random_function(graph, seed);
    Random random(seed);
    std::vector<std::uint64_t> keys(graph.nodes());
    for (std::uint64_t& key : keys) key = random.bits();
    LocalSearch search(graph);
    for (const ConflictRule& rule :
         {neighbor_conflicts(graph), function_conflicts(search, f, 1.3),
          function_conflicts(search, f, 6), function_conflicts(search, f, 40)}) {
      const TwinNodes no_twins;
      std::size_t considered = 0;
      NodeSelection selection(graph.nodes(), no_twins, rule, [&](Index) { ++considered; });
      EXPECT_TRUE(selection.select(all_nodes(graph.nodes()), keys, [] { return true; }));
      EXPECT_EQ(selection.selected(), greedy(graph, rule, keys));
      EXPECT_GE(considered, selection.selected().size());
      for (Index v = 0; v < graph.nodes(); ++v) EXPECT_FALSE(selection.is_free(v));
    }
  }
}

TEST(NodeSelection, ConsidersOnlyTheNodesGiven) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  const std::vector<Index> odd = {1, 5, 9};
  EXPECT_TRUE(selection.select(odd, ascending_keys(10), [] { return true; }));
  EXPECT_EQ(selection.selected(), odd);
  EXPECT_TRUE(selection.is_free(3));
  EXPECT_TRUE(selection.is_free(7));
  select_in_order(selection, 10);
  EXPECT_EQ(selection.selected(), (std::vector<Index>{1, 3, 5, 7, 9}));
}

TEST(NodeSelection, WaitsThroughLongChains) {
  // On a path whose keys descend, every node waits for the next.
  Graph graph{{0}, {}};
  constexpr Index kNodes = 200000;
  for (Index v = 0; v < kNodes; ++v) {
    if (v > 0) graph.arcs.push_back({v - 1, 1});
    if (v + 1 < kNodes) graph.arcs.push_back({v + 1, 1});
    graph.first.push_back(static_cast<Index>(graph.arcs.size()));
  }
  auto keys = ascending_keys(kNodes);
  std::ranges::reverse(keys);
  const TwinNodes no_twins;
  NodeSelection selection(kNodes, no_twins, neighbor_conflicts(graph));
  EXPECT_TRUE(selection.select(all_nodes(kNodes), keys, [] { return true; }));
  for (Index v = 0; v < kNodes; ++v) ASSERT_EQ(selection.is_selected(v), v % 2 == 1);
}

TEST(NodeSelection, StopsWhenTold) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  EXPECT_FALSE(selection.select(all_nodes(10), ascending_keys(10), [] { return false; }));
}

TEST(NodeSelection, ForcesNodesThatConflictWithEachOther) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  selection.force(std::vector<Index>{3, 4});
  EXPECT_FALSE(selection.is_free(2));
  EXPECT_FALSE(selection.is_free(5));
  select_in_order(selection, 10);
  EXPECT_EQ(selection.selected(), (std::vector<Index>{0, 3, 4, 6, 8}));
}

TEST(NodeSelection, PassesOverInvalidNodes) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  selection.invalidate(0);
  select_in_order(selection, 10);
  EXPECT_EQ(selection.selected(), (std::vector<Index>{1, 3, 5, 7, 9}));
}

TEST(NodeSelection, NeverTakesBackWhatIsSelected) {
  const Graph graph = path();
  const TwinNodes no_twins;
  NodeSelection selection(10, no_twins, neighbor_conflicts(graph));
  selection.force(std::vector<Index>{5});
  selection.invalidate(5);
  EXPECT_TRUE(selection.is_selected(5));
}

TEST(NodeSelection, KeepsOrDropsTwinsAsOne) {
  const Graph graph = path();
  const TwinNodes twins{{0, 1, 8, 3, 4, 5, 6, 7, 2, 9}};  // 2 and 8
  NodeSelection kept(10, twins, neighbor_conflicts(graph));
  kept.force(std::vector<Index>{2});
  EXPECT_TRUE(kept.is_selected(8));
  for (const Index v : {1, 3, 7, 9}) EXPECT_FALSE(kept.is_free(v));

  NodeSelection dropped(10, twins, neighbor_conflicts(graph));
  dropped.force(std::vector<Index>{9});
  EXPECT_FALSE(dropped.is_free(2)) << "8 is in conflict with 9";
}

TEST(NodeSelection, ConsidersTwinsAtTheTurnOfTheFirstOfThem) {
  const Graph graph = path();
  const TwinNodes twins{{0, 1, 8, 3, 4, 5, 6, 7, 2, 9}};
  std::vector<std::uint64_t> keys = {10, 11, 12, 13, 14, 15, 16, 17, 1, 19};
  NodeSelection first(10, twins, neighbor_conflicts(graph));
  EXPECT_TRUE(first.select(all_nodes(10), keys, [] { return true; }));
  EXPECT_EQ(first.selected(), (std::vector<Index>{0, 2, 4, 6, 8}));

  keys[7] = 0;  // 7 comes before, and rules out 8, and 2 with it
  NodeSelection later(10, twins, neighbor_conflicts(graph));
  EXPECT_TRUE(later.select(all_nodes(10), keys, [] { return true; }));
  EXPECT_EQ(later.selected(), (std::vector<Index>{0, 3, 5, 7, 9}));
}

}  // namespace
}  // namespace wellspaced
