#include "wellspaced/kernel/graph.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

std::set<std::array<Index, 2>> arcs(const Graph& graph) {
  std::set<std::array<Index, 2>> result;
  for (Index v = 0; v < graph.nodes(); ++v)
    for (const auto& arc : graph.arcs_of(v)) {
      EXPECT_TRUE(result.insert({v, arc.target}).second) << "arc given twice";
    }
  return result;
}

TEST(MeshGraph, HasTheEdgesOfTheTrianglesInBothDirections) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TriangleMesh mesh = test::grid_mesh({.nx = 6, .ny = 9, .hole = 0.2, .seed = seed});
    std::set<std::array<Index, 2>> expected;
    for (const auto& [a, b, c] : mesh.triangles)
      expected.insert({{a, b}, {b, a}, {b, c}, {c, b}, {c, a}, {a, c}});
    const Graph graph = mesh_graph(mesh);
    EXPECT_EQ(arcs(graph), expected);
    for (Index v = 0; v < graph.nodes(); ++v)
      for (const auto& [w, length] : graph.arcs_of(v))
        EXPECT_EQ(length, distance(mesh.points[v], mesh.points[w]));
  }
}

TEST(MeshGraph, AddsTheSegmentsThatAreNoEdgeOfATriangle) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {3, 0}, {4, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.segments = {{1, 0, 7}, {1, 3, 7}, {3, 1, 7}, {3, 4, 7}, {4, 4, 7}};
  EXPECT_EQ(arcs(mesh_graph(mesh)),
            (std::set<std::array<Index, 2>>{
                {0, 1}, {1, 0}, {1, 2}, {2, 1}, {2, 0}, {0, 2}, {1, 3}, {3, 1}, {3, 4}, {4, 3}}));
}

TEST(MeshGraph, OfNothingHasNoNodes) { EXPECT_EQ(mesh_graph(TriangleMesh{}).nodes(), 0u); }

}  // namespace
}  // namespace wellspaced
