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
  ProtectedEdges with(const ProtectiveZone& zone) const {
    return {mesh.points, boundary.on_boundary, edges, zone};
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
      protect_edges(domain.with({.ratio = ratio}), domain.search, domain.selection);
      for (Index v = 0; v < domain.graph.nodes(); ++v) {
        const bool expected = !domain.boundary.on_boundary[v] && domain.lies_too_close(v, ratio);
        EXPECT_EQ(!domain.selection.is_free(v), expected) << "node " << v << ", seed " << seed;
      }
    }
}

TEST(ProtectEdges, ExemptsSelectedNodes) {
  Protected domain(test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0}), 20);
  domain.selection.force(std::vector<Index>{31});  // (10, 1), above the middle of the lower edge
  protect_edges(domain.with({.ratio = 0.2}), domain.search, domain.selection);
  EXPECT_TRUE(domain.selection.is_selected(31));
  EXPECT_FALSE(domain.selection.is_free(32));
}

// A grid of unit squares, its boundary contracted to edges of length 4: but for the ends of an
// edge, its circle of radius 2 about the middle has 3 nodes of the boundary, 3 in the first row
// above it and none in the second, where it touches one.
TEST(InspectEdges, CountsWhatEachBoundaryNodeFindsInTheCirclesOfItsEdges) {
  Protected domain(test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0}), 4);
  const std::size_t in_circle = 2 + 3 + 3;
  const SearchCount all = inspect_edges(domain.search, domain.mesh.points, domain.edges);
  EXPECT_EQ(all.searches, domain.edges.size()) << "a closed curve has as many nodes as edges";
  EXPECT_EQ(all.max, 2 * in_circle);
  EXPECT_EQ(all.total, 2 * in_circle * domain.edges.size());

  const SearchCount one =
      inspect_edges(domain.search, domain.mesh.points, std::span(domain.edges).first(1));
  EXPECT_EQ(one.searches, 2u);
  EXPECT_EQ(one.max, in_circle);
  EXPECT_EQ(one.total, 2 * in_circle);
}

TEST(InspectEdges, CountsTheEndsOfEdgesWhoseCirclesAreEmpty) {
  Protected domain(test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0}), 1);
  const SearchCount count = inspect_edges(domain.search, domain.mesh.points, domain.edges);
  EXPECT_EQ(count.max, 4u);
  EXPECT_EQ(count.total, 4 * count.searches);
}

}  // namespace
}  // namespace wellspaced
