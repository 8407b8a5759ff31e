#include "wellspaced/algorithms/spacing/graph_spacing.hpp"

#include <gtest/gtest.h>

#include "tests/support/slow_shortest_paths.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::random_graph;

std::vector<double> random_values(const Graph& graph, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(graph.nodes());
  for (double& value : values) value = random.uniform(0, 5);
  return values;
}

TEST(MeshSpacing, IsHalfTheShortestEdge) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 5, .ny = 5, .seed = 3});
  const auto spacing = mesh_spacing(mesh_graph(mesh));
  std::vector<double> expected(mesh.points.size(), 1e300);
  for (const auto& t : mesh.triangles)
    for (const Index v : t)
      for (const Index w : t)
        if (v != w)
          expected[v] = std::min(expected[v], 0.5 * distance(mesh.points[v], mesh.points[w]));
  EXPECT_EQ(spacing, expected);
}

TEST(MeshSpacing, NeedsNoGraph) {
  TriangleMesh mesh = test::grid_mesh({.nx = 8, .ny = 7, .hole = 0.1, .seed = 4});
  mesh.points.insert(mesh.points.end(), {{20, 20}, {20.25, 20}, {30, 30}});
  const auto first = static_cast<Index>(mesh.points.size() - 3);
  mesh.segments.push_back({first, first + 1, 1});
  mesh.segments.push_back({first + 2, first + 2, 1});
  EXPECT_EQ(mesh_spacing(mesh), mesh_spacing(mesh_graph(mesh)));
  EXPECT_EQ(mesh_spacing(mesh)[first], 0.125);
  EXPECT_EQ(mesh_spacing(mesh)[first + 2], 0);
}

TEST(MeshSpacing, IsZeroAtANodeWithoutEdges) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {5, 5}};
  mesh.segments = {{0, 1, 0}};
  EXPECT_EQ(mesh_spacing(mesh_graph(mesh)), (std::vector<double>{0.5, 0.5, 0}));
}

// Lemma 5.4.1 and Corollary 7.1.5, in the graph metric.
TEST(CoarsenedSpacing, IsOneLipschitzAndAtMostTheScaledSpacing) {
  const Graph graph = random_graph(1);
  const auto g = random_values(graph, 1), f = coarsened_spacing(graph, g, 3);
  for (Index v = 0; v < graph.nodes(); ++v) {
    EXPECT_LE(f[v], 3 * g[v]);
    for (const auto& [w, length] : graph.arcs_of(v)) EXPECT_LE(f[w], f[v] + length);
  }
}

// Lemma 5.4.2: f_{C1} <= f_{C2} for C1 <= C2, and f_{C1 C2} <= C1 f_{C2}.
TEST(CoarsenedSpacing, IsMonotoneInTheFactorAndGrowsAtMostInProportion) {
  const Graph graph = random_graph(2);
  const auto g = random_values(graph, 2);
  const auto by_2 = coarsened_spacing(graph, g, 2), by_6 = coarsened_spacing(graph, g, 6);
  for (Index v = 0; v < graph.nodes(); ++v) {
    EXPECT_LE(by_2[v], by_6[v]);
    EXPECT_LE(by_6[v], 3 * by_2[v] * (1 + 1e-14));
  }
}

// Lemma 5.4.3: no 1-Lipschitz function below C g is above f.
TEST(CoarsenedSpacing, IsTheGreatestLipschitzFunctionBelowTheScaledSpacing) {
  const Graph graph = random_graph(3);
  const auto g = random_values(graph, 3), f = coarsened_spacing(graph, g, 2);
  Random random(9);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> below = g;
    for (double& value : below) value *= 2 * random.uniform();
    const auto h = test::bellman_ford(graph, below);  // 1-Lipschitz, at most 2 g
    for (Index v = 0; v < graph.nodes(); ++v) EXPECT_LE(h[v], f[v]);
  }
}

// Lemma 5.4.4: coarsening step by step gives the same functions as coarsening at once.
TEST(CoarsenedSpacing, IsTheSameStepByStepAndAtOnce) {
  const Graph graph = random_graph(4);
  const auto g = random_values(graph, 4);
  auto step_by_step = g;
  for (int i = 1; i <= 5; ++i) {
    step_by_step = coarsened_spacing(graph, step_by_step, 2);
    const auto at_once = coarsened_spacing(graph, g, 1 << i);
    for (Index v = 0; v < graph.nodes(); ++v)
      EXPECT_NEAR(step_by_step[v], at_once[v], 1e-13 * at_once[v]);
  }
}

}  // namespace
}  // namespace wellspaced
