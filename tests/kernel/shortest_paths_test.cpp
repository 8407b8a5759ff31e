#include "wellspaced/kernel/shortest_paths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slow_shortest_paths.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::bellman_ford;
using test::random_graph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A path 0 - 1 - ... that turns back and forth through the numbering of its nodes.
Graph shuffled_path(Index nodes, std::uint64_t seed) {
  std::vector<Index> order(nodes);
  std::iota(order.begin(), order.end(), Index{0});
  Random random(seed);
  for (Index i = nodes; i-- > 1;) std::swap(order[i], order[random.below(i + 1)]);
  std::vector<std::vector<Graph::Arc>> arcs(nodes);
  for (Index i = 0; i + 1 < nodes; ++i) {
    const double length = random.uniform(0.5, 2);
    arcs[order[i]].push_back({order[i + 1], length});
    arcs[order[i + 1]].push_back({order[i], length});
  }
  Graph graph{{0}, {}};
  for (const auto& list : arcs) {
    graph.arcs.insert(graph.arcs.end(), list.begin(), list.end());
    graph.first.push_back(static_cast<Index>(graph.arcs.size()));
  }
  return graph;
}

std::vector<double> random_starts(const Graph& graph, double range, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> start(graph.nodes());
  for (double& value : start) value = random.uniform(0, range);
  return start;
}

TEST(ShortestDistances, AgreeWithBellmanFordFromAllNodes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const double range : {0.0, 1.0, 10.0, 1000.0}) {
      const Graph graph = random_graph(seed);
      const std::vector<double> start = random_starts(graph, range, seed);
      EXPECT_EQ(shortest_distances(graph, start), bellman_ford(graph, start));
    }
}

TEST(ShortestDistances, AgreeWithBellmanFordFromOneNode) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Graph graph = random_graph(seed);
    std::vector<double> start(graph.nodes(), kInfinity);
    start[seed * 31 % graph.nodes()] = 0;
    EXPECT_EQ(shortest_distances(graph, start), bellman_ford(graph, start));
  }
}

TEST(ShortestDistances, AgreeWithBellmanFordWhereSweepsDoNotPay) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Graph graph = shuffled_path(3000, seed);
    std::vector<double> start(graph.nodes(), kInfinity);
    start[7] = 1;
    EXPECT_EQ(shortest_distances(graph, start), bellman_ford(graph, start));
  }
}

TEST(ShortestDistances, LeaveNodesThatNoPathReachesInfinite) {
  const Graph graph{{0, 1, 2, 2}, {{1, 2.0}, {0, 2.0}}};
  EXPECT_EQ(shortest_distances(graph, std::vector<double>{1, kInfinity, kInfinity}),
            (std::vector<double>{1, 3, kInfinity}));
}

TEST(ShortestDistances, OfTheEmptyGraphAreEmpty) {
  EXPECT_TRUE(shortest_distances(Graph{{0}, {}}, {}).empty());
}

// Corollary 7.1.5, in the graph metric itself: no edge is steeper than 1.
TEST(ShortestDistances, AreOneLipschitzAlongEveryEdge) {
  const Graph graph = random_graph(3);
  const auto distance = shortest_distances(graph, random_starts(graph, 50, 3));
  for (Index v = 0; v < graph.nodes(); ++v)
    for (const auto& [w, length] : graph.arcs_of(v)) EXPECT_LE(distance[w], distance[v] + length);
}

// Lemma 7.1.4: f_E <= f_M <= mu f_E, with the dilation mu of Definition 7.1.3.
TEST(ShortestDistances, LieBetweenTheEuclideanFunctionAndItsDilation) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 9, .ny = 9, .seed = 5});
  const Graph graph = mesh_graph(mesh);
  const Index n = graph.nodes();
  double dilation = 1;
  for (Index v = 0; v < n; ++v) {
    std::vector<double> start(n, kInfinity);
    start[v] = 0;
    const auto from_v = shortest_distances(graph, start);
    for (Index w = 0; w < n; ++w)
      if (w != v)
        dilation = std::max(dilation, from_v[w] / distance(mesh.points[v], mesh.points[w]));
  }
  EXPECT_LT(dilation, 2.418);  // Keil and Gutwin's bound for Delaunay triangulations

  const auto start = random_starts(graph, 8, 6);
  const auto f_graph = shortest_distances(graph, start);
  for (Index v = 0; v < n; ++v) {
    double f_euclidean = kInfinity;
    for (Index w = 0; w < n; ++w)
      f_euclidean = std::min(f_euclidean, start[w] + distance(mesh.points[v], mesh.points[w]));
    EXPECT_LE(f_euclidean, f_graph[v] * (1 + 1e-14));
    EXPECT_LE(f_graph[v], dilation * f_euclidean * (1 + 1e-14));
  }
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

// Lemma 5.4.4: coarsening by 2 twice is coarsening by 4.
TEST(ShortestDistances, OfTwiceTheDistancesAreThoseOfFourTimesTheStart) {
  const Graph graph = random_graph(8);
  const auto start = random_starts(graph, 5, 8);
  const auto by_2 = shortest_distances(graph, scaled(start, 2));
  const auto by_2_twice = shortest_distances(graph, scaled(by_2, 2));
  const auto by_4 = shortest_distances(graph, scaled(start, 4));
  for (Index v = 0; v < graph.nodes(); ++v) EXPECT_NEAR(by_2_twice[v], by_4[v], 1e-14 * by_4[v]);
}

TEST(ShortestPathTree, HasPathsThatAddUpToTheDistances) {
  for (const double range : {0.0, 3.0, 300.0}) {
    const Graph graph = random_graph(4);
    const auto start = random_starts(graph, range, 4);
    const auto distance = shortest_distances(graph, start);
    const ShortestPathTree tree = shortest_path_tree(graph, start, distance);
    for (Index v = 0; v < graph.nodes(); ++v) {
      const Index u = tree.parent[v];
      if (u == kNoIndex) {
        EXPECT_EQ(distance[v], start[v]);
        EXPECT_EQ(tree.depth[v], 0u);
        continue;
      }
      EXPECT_LT(distance[v], start[v]);
      EXPECT_EQ(tree.depth[v], tree.depth[u] + 1);
      const auto arcs = graph.arcs_of(u);
      EXPECT_TRUE(std::any_of(arcs.begin(), arcs.end(), [&](const Graph::Arc& arc) {
        return arc.target == v && distance[u] + arc.length == distance[v];
      }));
    }
  }
}

TEST(ShortestPathTree, TakesTheNearestThenTheLowestOfEqualParents) {
  // A square 0 1 3 2 with unit sides: both ways from 0 to 3 are 2 long.
  const Graph graph{
      {0, 2, 4, 6, 8},
      {{1, 1.0}, {2, 1.0}, {0, 1.0}, {3, 1.0}, {0, 1.0}, {3, 1.0}, {1, 1.0}, {2, 1.0}}};
  const std::vector<double> start = {0, kInfinity, kInfinity, kInfinity};
  const auto tree = shortest_path_tree(graph, start, shortest_distances(graph, start));
  EXPECT_EQ(tree.parent, (std::vector<Index>{kNoIndex, 0, 0, 1}));
  EXPECT_EQ(tree.depth, (std::vector<Index>{0, 1, 1, 2}));
}

TEST(ShortestPathTree, EndsWhereAnEdgeIsTooShortToChangeTheSum) {
  const Graph graph{{0, 1, 3, 4}, {{1, 1.0}, {0, 1.0}, {2, 1e-30}, {1, 1e-30}}};
  const std::vector<double> start = {0, kInfinity, kInfinity};
  const auto tree = shortest_path_tree(graph, start, shortest_distances(graph, start));
  EXPECT_EQ(tree.parent, (std::vector<Index>{kNoIndex, 0, kNoIndex}));
}

}  // namespace
}  // namespace wellspaced
