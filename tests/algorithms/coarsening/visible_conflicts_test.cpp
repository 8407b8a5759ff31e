#include "wellspaced/algorithms/coarsening/visible_conflicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

struct Spaced {
  TriangleMesh mesh;
  Graph graph;
  Visibility visibility;
  std::vector<double> f;  // 1-Lipschitz

  explicit Spaced(std::uint64_t seed)
      : mesh(test::grid_mesh({.nx = 14, .ny = 14, .hole = 0.1, .seed = seed})),
        graph(mesh_graph(mesh)),
        visibility(mesh) {
    Random random(seed);
    std::vector<double> values(mesh.points.size());
    for (double& value : values) value = random.uniform(1, 9);
    f = euclidean_coarsened_spacing(mesh.points, values, 1);
  }
  bool are_joined(Index v, Index w) const {
    return std::ranges::any_of(graph.arcs_of(v), [&](const auto& arc) { return arc.target == w; });
  }
};

TEST(VisibleConflicts, AreThePairsTooNearThatSeeEachOtherOrShareAnEdge) {
  std::size_t hidden = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const double beta : {1.5, 2.0, 4.0}) {
      const Spaced set(seed);
      const ConflictRule rule = visible_conflicts(set.visibility, set.graph, set.f, beta);
      for (Index v = 0; v < set.f.size(); ++v) {
        std::vector<Conflict> list;
        rule(v, list);
        std::set<Index> found, expected;
        for (const Conflict& c : list) found.insert(c.node);
        for (Index w = 0; w < set.f.size(); ++w) {
          const double d = distance(set.mesh.points[v], set.mesh.points[w]);
          if (!(set.f[v] + set.f[w] > beta * d)) continue;
          const bool sees = set.visibility.sees(v, w);
          if (sees || set.are_joined(v, w)) expected.insert(w);
          hidden += !sees;
        }
        EXPECT_EQ(found, expected) << "node " << v << ", seed " << seed << ", beta " << beta;
      }
    }
  EXPECT_GT(hidden, 100u);
}

// Lemma 6.3.1, in the convex domain of all pairs: where balls of radius f / beta meet, neither f is
// much the smaller, and the centres are not far apart.
TEST(Lemma631, BoundsTheValuesAndTheDistanceOfNodesInConflict) {
  std::size_t conflicts = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const double beta : {1.5, 2.0, 4.0}) {
      const Spaced set(seed);
      for (Index p = 0; p < set.f.size(); ++p)
        for (Index q = 0; q < set.f.size(); ++q) {
          const double d = distance(set.mesh.points[p], set.mesh.points[q]);
          if (p == q || set.f[p] + set.f[q] < beta * d) continue;
          ++conflicts;
          EXPECT_GE(set.f[q] * (1 + 1e-12), (beta - 1) / (beta + 1) * set.f[p]);
          EXPECT_LE(d, 2 * set.f[p] / (beta - 1) * (1 + 1e-12));
        }
    }
  EXPECT_GT(conflicts, 1000u);
}

}  // namespace
}  // namespace wellspaced
