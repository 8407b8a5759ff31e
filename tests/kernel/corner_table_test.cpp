#include "wellspaced/kernel/corner_table.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/grid_meshes.hpp"

namespace wellspaced {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;
using EdgeSet = std::set<std::array<Index, 2>>;

EdgeSet as_set(const std::vector<std::array<Index, 2>>& edges) {
  return {edges.begin(), edges.end()};
}

// Two triangles that touch in node 2 only, and node 5 in no triangle.
const Triangles kBowTie = {{0, 1, 2}, {2, 3, 4}};

TEST(CornerTable, ListsTheTrianglesAroundEachNode) {
  const CornerTable table = corner_table(kBowTie, 6);
  ASSERT_EQ(table.nodes(), 6u);
  ASSERT_EQ(table.at(2).size(), 2u);
  EXPECT_EQ(table.at(2)[0], (CornerTable::Corner{0, 1}));
  EXPECT_EQ(table.at(2)[1], (CornerTable::Corner{3, 4}));
  EXPECT_TRUE(table.at(5).empty());
  EXPECT_TRUE(table.has_edge(0, 1));
  EXPECT_FALSE(table.has_edge(1, 0));
}

TEST(CornerTable, StaysOnTheBoundaryCurveWhereTwoMeetInANode) {
  const CornerTable table = corner_table(kBowTie, 6);
  EXPECT_EQ(table.next_boundary_node(1, 2), 0u);
  EXPECT_EQ(table.next_boundary_node(4, 2), 3u);
  EXPECT_EQ(table.next_boundary_node(2, 0), 1u);
}

TEST(CornerTable, TurnsThroughTheWholeFanToTheNextBoundaryEdge) {
  // A fan of three triangles around node 0.
  const CornerTable table = corner_table(Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, 5);
  EXPECT_EQ(table.next_boundary_node(4, 0), 1u);
}

TEST(CornerTable, EndsTheTurnOnTrianglesThatMakeNoFan) {
  // A closed ring of triangles around node 0 has no boundary edge there.
  const CornerTable table = corner_table(Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 4);
  EXPECT_EQ(table.next_boundary_node(1, 0), kNoIndex);
  EXPECT_EQ(table.next_boundary_node(7, 0), kNoIndex);
}

TEST(BoundaryEdges, AreTheDirectedEdgesWithoutAnOpposite) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TriangleMesh mesh = test::grid_mesh({.nx = 9, .ny = 7, .hole = 0.15, .seed = seed});
    EdgeSet directed, expected;
    for (const auto& [a, b, c] : mesh.triangles) directed.insert({{a, b}, {b, c}, {c, a}});
    for (const auto& [a, b] : directed)
      if (!directed.contains({b, a})) expected.insert({a, b});
    const auto table = corner_table(mesh.triangles, static_cast<Index>(mesh.points.size()));
    EXPECT_EQ(as_set(boundary_edges(table)), expected);
  }
}

TEST(BoundaryEdges, FormClosedCurvesUnderNextBoundaryNode) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TriangleMesh mesh = test::grid_mesh({.nx = 9, .ny = 7, .hole = 0.25, .seed = seed});
    const auto table = corner_table(mesh.triangles, static_cast<Index>(mesh.points.size()));
    const EdgeSet edges = as_set(boundary_edges(table));
    EdgeSet followers;
    for (const auto& [u, v] : edges) {
      const std::array<Index, 2> next{v, table.next_boundary_node(u, v)};
      EXPECT_TRUE(edges.contains(next));
      EXPECT_TRUE(followers.insert(next).second) << "an edge follows two others";
    }
    EXPECT_EQ(followers.size(), edges.size());
  }
}

}  // namespace
}  // namespace wellspaced
