#include "wellspaced/kernel/local_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/slow_shortest_paths.hpp"

namespace wellspaced {
namespace {

using test::bellman_ford;
using test::random_graph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LocalSearch, SettlesTheNodesWithinARadiusInOrderOfDistance) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Graph graph = random_graph(seed);
    LocalSearch search(graph);
    for (Index source = 0; source < graph.nodes(); source += 37) {
      std::vector<double> start(graph.nodes(), kInfinity);
      start[source] = 0;
      const auto expected = bellman_ford(graph, start);
      std::vector<double> found(graph.nodes(), kInfinity);
      double last = 0;
      const double radius = 4;
      search.run(
          std::vector{source}, [&](Index, double d) { return d <= radius; },
          [&](Index v, double d) {
            EXPECT_TRUE(std::isinf(found[v])) << "settled twice";
            EXPECT_LE(last, d);
            last = found[v] = d;
            return true;
          });
      std::size_t within = 0;
      for (Index v = 0; v < graph.nodes(); ++v) {
        EXPECT_EQ(found[v], expected[v] <= radius ? expected[v] : kInfinity);
        within += expected[v] <= radius;
      }
      EXPECT_EQ(search.labelled(), within);
    }
  }
}

TEST(LocalSearch, MeasuresFromTheNearestOfSeveralSources) {
  const Graph graph = random_graph(2);
  LocalSearch search(graph);
  std::vector<double> start(graph.nodes(), kInfinity);
  start[5] = start[200] = 0;
  const auto expected = bellman_ford(graph, start);
  std::vector<double> found(graph.nodes(), kInfinity);
  search.run(
      std::vector<Index>{5, 200, 5}, [](Index, double) { return true; },
      [&](Index v, double d) { return found[v] = d, true; });
  EXPECT_EQ(found, expected);
}

TEST(LocalSearch, EndsWhenSettleSaysSoAndCountsTheFrontier) {
  // A path 0 - 1 - 2 - 3 of unit edges, searched from 1 up to distance 0: the frontier is 0 and 2.
  const Graph graph{{0, 1, 3, 5, 6}, {{1, 1.0}, {0, 1.0}, {2, 1.0}, {1, 1.0}, {3, 1.0}, {2, 1.0}}};
  LocalSearch search(graph);
  search.run(
      std::vector<Index>{1}, [](Index, double) { return true; },
      [](Index, double d) { return d <= 0; });
  EXPECT_EQ(search.labelled(), 3u);
}

}  // namespace
}  // namespace wellspaced
