#include "wellspaced/kernel/local_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "tests/support/slow_shortest_paths.hpp"

namespace wellspaced {
namespace {

using test::bellman_ford;
using test::random_graph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Infinite where the search did not get.
std::vector<double> distances(const Graph& graph, const LocalSearch& search,
                              std::span<const Index> reached) {
  std::vector<double> result(graph.nodes(), kInfinity);
  for (const Index v : reached) {
    EXPECT_TRUE(std::isinf(result[v])) << "reached twice";
    result[v] = search.distance(v);
  }
  return result;
}

TEST(LocalSearch, ReachesTheNodesWithinARadius) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Graph graph = random_graph(seed);
    LocalSearch search(graph);
    for (Index source = 0; source < graph.nodes(); source += 37) {
      std::vector<double> start(graph.nodes(), kInfinity);
      start[source] = 0;
      auto expected = bellman_ford(graph, start);
      for (double& d : expected)
        if (d > 4) d = kInfinity;
      const auto reached = search.run(std::vector{source}, [](Index, double d) { return d <= 4; });
      EXPECT_EQ(distances(graph, search, reached), expected);
    }
  }
}

TEST(LocalSearch, MeasuresFromTheNearestOfSeveralSources) {
  const Graph graph = random_graph(2);
  LocalSearch search(graph);
  std::vector<double> start(graph.nodes(), kInfinity);
  start[5] = start[200] = 0;
  const auto reached =
      search.run(std::vector<Index>{5, 200, 5}, [](Index, double) { return true; });
  EXPECT_EQ(distances(graph, search, reached), bellman_ford(graph, start));
}

TEST(LocalSearch, DoesNotPassThroughNodesThatAreNotAccepted) {
  // A path 0 - 1 - 2 - 3 of unit edges.
  const Graph graph{{0, 1, 3, 5, 6}, {{1, 1.0}, {0, 1.0}, {2, 1.0}, {1, 1.0}, {3, 1.0}, {2, 1.0}}};
  LocalSearch search(graph);
  const auto reached = search.run(std::vector<Index>{0}, [](Index v, double) { return v != 2; });
  EXPECT_EQ(reached.size(), 2u);
  EXPECT_EQ(search.include_frontier().size(), 3u);
}

TEST(LocalSearch, CorrectsAPathThatItFoundTooEarly) {
  // From 0 to 1 at 9 directly, found first, but at 3 over 2 and 3; and on to 4.
  const Graph graph{
      {0, 2, 5, 7, 9, 10},
      {{1, 9}, {2, 1}, {0, 9}, {3, 1}, {4, 1}, {0, 1}, {3, 1}, {2, 1}, {1, 1}, {1, 1}}};
  LocalSearch search(graph);
  const auto reached = search.run(std::vector<Index>{0}, [](Index, double) { return true; });
  EXPECT_EQ(distances(graph, search, reached), (std::vector<double>{0, 3, 1, 2, 4}));
}

TEST(LocalSearch, FindsTheSameDistancesWhereItGrowsLarge) {
  TriangleMesh mesh = test::grid_mesh({.nx = 70, .ny = 70, .seed = 3});
  for (Point2& p : mesh.points) p = {std::exp(p.x / 7), std::exp(p.y / 9)};  // graded
  const Graph graph = mesh_graph(mesh);
  LocalSearch search(graph);
  for (const Index source : {0u, 2500u, 5040u}) {
    std::vector<double> start(graph.nodes(), kInfinity);
    start[source] = 0;
    const auto reached = search.run(std::vector{source}, [](Index, double) { return true; });
    EXPECT_EQ(distances(graph, search, reached), bellman_ford(graph, start));
  }
}

}  // namespace
}  // namespace wellspaced
