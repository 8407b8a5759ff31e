#include "wellspaced/algorithms/audit/level_spacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using Pairs = std::vector<std::array<Index, 2>>;

// All graph distances, by Floyd and Warshall.
std::vector<std::vector<double>> all_distances(const TriangleMesh& mesh) {
  const std::size_t n = mesh.points.size();
  std::vector d(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  const auto join = [&](Index a, Index b) {
    d[a][b] = d[b][a] =
        std::hypot(mesh.points[a].x - mesh.points[b].x, mesh.points[a].y - mesh.points[b].y);
  };
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) join(t[i], t[(i + 1) % 3]);
  for (const Segment& s : mesh.segments) join(s.a, s.b);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  return d;
}

Pairs sorted(Pairs pairs) {
  for (auto& [a, b] : pairs)
    if (b < a) std::swap(a, b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(GraphSpacing, AgreesWithAllDistances) {
  Random random(1);
  for (const TriangleMesh& mesh :
       {test::random_mesh(80, 1), test::slit_square(3), test::annulus(16)}) {
    const auto distance = all_distances(mesh);
    for (int round = 0; round < 20; ++round) {
      std::vector<Index> nodes;
      std::vector<double> spacing;
      for (Index v = 0; v < mesh.points.size(); ++v) {
        if (random.below(3) != 0) continue;
        nodes.push_back(v);
        spacing.push_back(random.uniform(0.1, 4));
      }
      const double beta = random.uniform(2, 30);
      Pairs expected;
      for (Index i = 0; i < nodes.size(); ++i)
        for (Index j = 0; j < i; ++j)
          if (spacing[i] + spacing[j] > beta * distance[nodes[i]][nodes[j]] * (1 + 1e-14))
            expected.push_back({j, i});
      EXPECT_EQ(sorted(audit::graph_spacing_violations(mesh, {nodes, spacing, beta, {}})),
                sorted(expected));
    }
  }
}

TEST(GraphSpacing, ExemptsPairsOfSpecialPointsOnly) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  const std::vector<Index> nodes = {0, 1, 2};
  const std::vector<double> spacing = {1, 1, 1};
  const std::vector<std::uint8_t> exempt = {1, 1, 0};
  EXPECT_EQ(audit::graph_spacing_violations(mesh, {nodes, spacing, 1, {}}).size(), 3u);
  EXPECT_EQ(audit::graph_spacing_violations(mesh, {nodes, spacing, 1, exempt}).size(), 2u);
}

TEST(GraphSpacing, LetsTiesAndWhatRoundingExplainsPass) {
  TriangleMesh mesh;
  for (int i = 0; i <= 10; ++i) mesh.points.push_back({i * 0.1, 0});
  for (Index i = 0; i < 10; ++i) mesh.segments.push_back({i, i + 1, 0});
  const std::vector<Index> nodes = {0, 10};
  for (const double f : {0.5, std::nextafter(0.5, 1)}) {
    const std::vector<double> spacing = {f, f};
    EXPECT_TRUE(audit::graph_spacing_violations(mesh, {nodes, spacing, 1, {}}).empty());
  }
  const std::vector<double> spacing = {0.5, 0.5 + 1e-12};
  EXPECT_EQ(audit::graph_spacing_violations(mesh, {nodes, spacing, 1, {}}).size(), 1u);
}

TEST(EuclideanSpacing, ListsEachEdgeOnce) {
  const TriangleMesh mesh = test::slit_square(2);
  const std::vector<double> spacing(mesh.points.size(), 1.2);
  // Beta 2 asks for edges of length 1.2: the diagonals have it, the sides of cells do not.
  std::size_t sides = 0;
  for (const auto& [a, b] : audit::euclidean_spacing_violations(mesh, spacing, 2))
    sides += mesh.points[a].x == mesh.points[b].x || mesh.points[a].y == mesh.points[b].y;
  EXPECT_EQ(audit::euclidean_spacing_violations(mesh, spacing, 2).size(), sides);
  EXPECT_EQ(sides, 42u);  // 40 of a 4 x 4 grid; two are there twice, along the slit
}

}  // namespace
}  // namespace wellspaced
