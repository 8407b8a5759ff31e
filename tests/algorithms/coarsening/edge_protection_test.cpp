#include "wellspaced/algorithms/coarsening/edge_protection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

// A grid whose boundary is contracted to every `stride`-th node.
struct Protected {
  TriangleMesh mesh;
  Graph graph;
  LocalSearch search;
  Boundary boundary;
  std::vector<ContractedEdge> edges;
  NodeSelection selection;

  Protected(const TriangleMesh& grid, Index stride)
      : mesh(grid),
        graph(mesh_graph(mesh)),
        search(graph),
        boundary(boundary_of(mesh, corner_table(mesh.triangles, graph.nodes()))),
        selection(graph.nodes(), boundary.twins, [](Index, std::vector<Conflict>&) {}) {
    std::vector<std::uint8_t> survives(graph.nodes(), 0);
    for (const BoundaryCurve& curve : boundary.curves)
      for (std::size_t i = 0; i < curve.nodes.size(); i += stride) survives[curve.nodes[i]] = 1;
    edges = contract_boundary(boundary, mesh.points, survives);
  }
  bool lies_too_close(Index v, double ratio) const {
    const Point2 p = mesh.points[v];
    for (const ContractedEdge& edge : edges) {
      const Point2 a = mesh.points[edge.a], b = mesh.points[edge.b];
      const double length = distance(a, b);
      const bool in_circle = distance(p, {(a.x + b.x) / 2, (a.y + b.y) / 2}) < length / 2;
      const double area = std::fabs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
      if (in_circle && area / length < ratio * length) return true;
    }
    return false;
  }
};

TEST(ProtectEdges, MakesInvalidExactlyTheInteriorNodesInTheZones) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const double ratio : {0.0, 0.15, 0.2, 0.5}) {
      const TriangleMesh grid = test::grid_mesh({.nx = 20, .ny = 20, .hole = 0.02, .seed = seed});
      Protected domain(grid, 5);
      protect_edges(domain.search, domain.mesh.points, domain.edges, domain.boundary.on_boundary,
                    {.ratio = ratio}, domain.selection);
      for (Index v = 0; v < domain.graph.nodes(); ++v) {
        const bool expected = !domain.boundary.on_boundary[v] && domain.lies_too_close(v, ratio);
        EXPECT_EQ(!domain.selection.is_free(v), expected) << "node " << v << ", seed " << seed;
      }
    }
}

TEST(ProtectEdges, ExemptsSelectedNodes) {
  Protected domain(test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0}), 20);
  domain.selection.force(std::vector<Index>{31});  // (10, 1), above the middle of the lower edge
  protect_edges(domain.search, domain.mesh.points, domain.edges, domain.boundary.on_boundary,
                {.ratio = 0.2}, domain.selection);
  EXPECT_TRUE(domain.selection.is_selected(31));
  EXPECT_FALSE(domain.selection.is_free(32));
}

// The lower left corner of a grid with edges of length 2, cut along the rising diagonals.
TEST(InspectEdges, CountsTheUnselectedNodesInTheCircleAndBesideIt) {
  Protected domain(test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0}), 2);
  for (const ContractedEdge& edge : domain.edges)
    domain.selection.force(std::vector<Index>{edge.a, edge.b});
  const std::vector<ContractedEdge> lowest(1, domain.edges[0]);
  ASSERT_EQ(lowest[0].a, 0u);
  ASSERT_EQ(lowest[0].b, 2u);
  const SearchCount count =
      inspect_edges(domain.search, domain.mesh.points, lowest, 0.2, domain.selection);
  EXPECT_EQ(count.searches, 1u);
  // Inside the circle of radius 1.077 about (1, 0): the ends, (1, 0) and (1, 1).
  std::vector<bool> inspected(domain.graph.nodes());
  for (const Index v : {0u, 1u, 2u, 22u}) {
    inspected[v] = true;
    for (const Graph::Arc& arc : domain.graph.arcs_of(v)) inspected[arc.target] = true;
  }
  std::size_t expected = 0;
  for (Index v = 0; v < domain.graph.nodes(); ++v)
    expected += inspected[v] && !domain.selection.is_selected(v);
  EXPECT_EQ(count.max, expected);
  EXPECT_EQ(count.total, expected);
}

}  // namespace
}  // namespace wellspaced
