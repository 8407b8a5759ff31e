#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// Every pair, every node, by all distances.
SelectionCheck slow_check(const TriangleMesh& mesh, const Level& level, double beta) {
  const Graph graph = mesh_graph(mesh);
  const Index n = graph.nodes();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, HUGE_VAL));
  for (Index v = 0; v < n; ++v) {
    d[v][v] = 0;
    for (const Graph::Arc& arc : graph.arcs_of(v)) d[v][arc.target] = arc.length;
  }
  for (Index k = 0; k < n; ++k)
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);

  SelectionCheck check;
  const auto& nodes = level.origin;
  const auto& f = level.spacing;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto fixed = [&](std::size_t k) {
        return std::ranges::count(level.mesh.fixed, static_cast<Index>(k)) != 0;
      };
      if (fixed(i) && fixed(j)) continue;
      const double ratio = (f[i] + f[j]) / (beta * d[nodes[i]][nodes[j]]);
      check.conflicts += ratio > 1 + 1e-9;
      if (2 * std::max(f[i], f[j]) >= beta * d[nodes[i]][nodes[j]])
        check.conflict_max = std::max(check.conflict_max, ratio);
    }
  for (Index v = 0; v < n; ++v) {
    if (std::ranges::count(nodes, v) != 0) continue;
    double value = HUGE_VAL, least = HUGE_VAL;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      value = std::min(value, f[j] + d[v][nodes[j]]);
      least = std::min(least, beta * d[v][nodes[j]] - f[j]);
    }
    check.uncovered += least / value > 1 + 1e-9;
    check.uncovered_max = std::max(check.uncovered_max, least / value);
  }
  return check;
}

TEST(SelectionCheck, AgreesWithAllPairs) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const TriangleMesh mesh = test::grid_mesh({.nx = 6, .ny = 5, .jitter = 0.2, .seed = seed});
    Level level;
    for (Index v = 0; v < mesh.points.size(); ++v) {
      if (random.below(4) != 0) continue;
      if (random.below(3) == 0) level.mesh.fixed.push_back(static_cast<Index>(level.origin.size()));
      level.origin.push_back(v);
      level.spacing.push_back(random.uniform(0.5, 3));
    }
    const double beta = random.uniform(1.5, 5);
    const SelectionCheck fast = check_selection(mesh_graph(mesh), level, beta);
    const SelectionCheck slow = slow_check(mesh, level, beta);
    EXPECT_EQ(fast.conflicts, slow.conflicts) << seed;
    EXPECT_EQ(fast.uncovered, slow.uncovered) << seed;
    EXPECT_NEAR(fast.conflict_max, slow.conflict_max, 1e-9) << seed;
    EXPECT_NEAR(fast.uncovered_max, slow.uncovered_max, 1e-9) << seed;
  }
}

TEST(SelectionCheck, FindsTheConflictAndTheGapThatArePlanted) {
  TriangleMesh mesh;
  for (Index i = 0; i < 10; ++i) mesh.points.push_back({static_cast<double>(i), 0});
  for (Index i = 0; i + 1 < 10; ++i) mesh.segments.push_back({i, i + 1, 1});
  Level level;
  level.origin = {0, 1, 9};
  level.spacing = {2, 2, 2};
  const SelectionCheck check = check_selection(mesh_graph(mesh), level, 2);
  EXPECT_EQ(check.conflicts, 1u);
  EXPECT_EQ(check.conflict_max, 2);
  EXPECT_EQ(check.uncovered, 0u);  // 5, as far from 1 as from 9: 2 * 4 - 2 = 2 + 4, just covered
  EXPECT_EQ(check.uncovered_max, 1);
}

}  // namespace
}  // namespace wellspaced
