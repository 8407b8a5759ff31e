#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/algorithms/mesh/triangle_locator.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// All pairs of nodes by Floyd and Warshall over the lines of sight: the visibility graph.
std::vector<double> slow_geodesic(const TriangleMesh& mesh, const Visibility& visibility,
                                  const std::vector<double>& spacing, double factor) {
  const std::size_t n = mesh.points.size();
  std::vector<double> d(n * n, HUGE_VAL), f;
  for (Index p = 0; p < n; ++p)
    for (Index q = 0; q < n; ++q)
      if (visibility.sees(p, q)) d[p * n + q] = distance(mesh.points[p], mesh.points[q]);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n; ++q)
        d[p * n + q] = std::min(d[p * n + q], d[p * n + k] + d[k * n + q]);
  for (std::size_t p = 0; p < n; ++p) {
    f.push_back(factor * spacing[p]);
    for (std::size_t q = 0; q < n; ++q) f[p] = std::min(f[p], factor * spacing[q] + d[p * n + q]);
  }
  return f;
}

// A few nodes with small values, so that long paths matter.
std::vector<double> sparse_spacing(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> spacing;
  for (std::size_t v = 0; v < n; ++v)
    spacing.push_back(random.below(25) == 0 ? random.uniform() : 50);
  return spacing;
}

TEST(GeodesicCoarseningFunction, IsThatOfShortestPathsInTheDomain) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const double jitter = seed <= 6 ? 0.2 : 0;
    TriangleMesh mesh =
        test::grid_mesh({.nx = 10, .ny = 9, .jitter = jitter, .hole = 0.25, .seed = seed});
    if (seed % 2 == 0) {
      mesh = test::grid_mesh({.nx = 11, .ny = 9, .jitter = jitter, .seed = seed});
      test::cut_slit(mesh, 12, 3, 0, 9);
      test::cut_slit(mesh, 12, 6, 2, 10);
    }
    const Visibility visibility(mesh);
    const auto spacing = sparse_spacing(mesh.points.size(), seed);
    const auto f = geodesic_coarsened_spacing(visibility, mesh_graph(mesh), spacing, 1.5);
    const auto expected = slow_geodesic(mesh, visibility, spacing, 1.5);
    for (Index v = 0; v < mesh.points.size(); ++v)
      EXPECT_NEAR(f[v], expected[v], 1e-12 * expected[v]) << "node " << v << ", seed " << seed;
  }
}

// Lemma 7.1.4, with the dilation that the boundary makes of it: f_E <= f_geodesic <= f_M.
TEST(GeodesicCoarseningFunction, LiesBetweenTheEuclideanAndTheGraphFunction) {
  TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 20, .seed = 8});
  test::cut_slit(mesh, 21, 10, 0, 15);
  const Visibility visibility(mesh);
  const Graph graph = mesh_graph(mesh);
  const auto spacing = sparse_spacing(mesh.points.size(), 9);
  const auto geodesic = geodesic_coarsened_spacing(visibility, graph, spacing, 2);
  const auto euclidean = euclidean_coarsened_spacing(mesh.points, spacing, 2);
  const auto along_edges = coarsened_spacing(graph, spacing, 2);
  bool differs = false;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    EXPECT_LE(euclidean[v], geodesic[v] * (1 + 1e-14));
    EXPECT_LE(geodesic[v], along_edges[v]);
    differs = differs || geodesic[v] > 1.1 * euclidean[v];
  }
  EXPECT_TRUE(differs);
}

TEST(GeodesicCoarseningFunction, AtAnyPlaceIsTheLowestConeThatThePlaceSees) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 9, .ny = 9, .hole = 0.15, .seed = 10});
  const Visibility visibility(mesh);
  const TriangleLocator locator(mesh.points, mesh.triangles);
  const auto spacing = sparse_spacing(mesh.points.size(), 11);
  const GeodesicCoarseningFunction f(visibility, mesh_graph(mesh), spacing, 1);
  const std::vector<double> at_nodes = f.at_nodes();
  Random random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const Point2 x{random.uniform(0, 9), random.uniform(0, 9)};
    const auto triangles = locator.triangles_at(x);
    if (triangles.empty()) continue;
    double expected = HUGE_VAL;
    for (Index v = 0; v < mesh.points.size(); ++v)
      if (visibility.sees(x, triangles[0], v))
        expected = std::min(expected, at_nodes[v] + distance(x, mesh.points[v]));
    EXPECT_NEAR(f(x, triangles[0]), expected, 1e-12 * expected);
  }
}

}  // namespace
}  // namespace wellspaced
