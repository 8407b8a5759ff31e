#include "wellspaced/algorithms/transfer/transfer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/data_files.hpp"
#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/algorithms/audit/transfer_audit.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/shortest_paths.hpp"

namespace wellspaced {
namespace {

Hierarchy deep_hierarchy(const TriangleMesh& mesh) {
  CoarseningOptions options = multigrid_profile();
  options.until_nodes = 20;
  return coarsen(mesh, options).value();
}

bool in_closed_triangle(const TriangleMesh& mesh, const std::array<Index, 3>& t, Point2 p) {
  for (unsigned i = 0; i < 3; ++i)
    if (orient2d(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]], p) < 0) return false;
  return true;
}

bool in_mesh(const TriangleMesh& mesh, Point2 p) {
  return std::ranges::any_of(mesh.triangles,
                             [&](const auto& t) { return in_closed_triangle(mesh, t, p); });
}

Point2 interpolated_place(const SparseMatrix& p, const TriangleMesh& coarse, Index row) {
  Point2 place{0, 0};
  for (std::size_t k = 0; k < p.row(row).size(); ++k) {
    place.x += p.row_values(row)[k] * coarse.points[p.row(row)[k]].x;
    place.y += p.row_values(row)[k] * coarse.points[p.row(row)[k]].y;
  }
  return place;
}

bool is_displaced(const Transfer& transfer, Index node) {
  return std::ranges::binary_search(transfer.displaced, node, {}, &DisplacedNode::node);
}

// No entry joins nodes that are more than twice as far through the finer mesh as straight.
void expect_no_detours(const Level& finer, const Level& coarser, const Transfer& transfer) {
  const Graph graph = mesh_graph(finer.mesh);
  const SparseMatrix& p = transfer.prolongation;
  for (Index v = 0; v < p.rows(); ++v) {
    if (p.row(v).size() == 1) continue;
    std::vector<double> start(graph.nodes(), INFINITY);
    start[v] = 0;
    const auto through = shortest_distances(graph, start);
    for (const Index c : p.row(v)) {
      const Index w = coarser.parent[c];
      EXPECT_LE(through[w], 2 * distance(finer.mesh.points[v], finer.mesh.points[w]) * (1 + 1e-12));
    }
  }
}

// Compares a hierarchy's transfers with their definition, by brute force.
void expect_transfers_by_definition(const TriangleMesh& mesh) {
  const Hierarchy hierarchy = deep_hierarchy(mesh);
  const auto transfers = transfers_of(hierarchy).value();
  ASSERT_EQ(transfers.size() + 1, hierarchy.levels.size());
  for (std::size_t k = 0; k < transfers.size(); ++k) {
    SCOPED_TRACE("level " + std::to_string(k));
    const Level &finer = hierarchy.levels[k], &coarser = hierarchy.levels[k + 1];
    const SparseMatrix& p = transfers[k].prolongation;
    EXPECT_TRUE(audit::audit_transfer(p, coarser.parent).pass());
    for (Index v = 0; v < p.rows(); ++v) {
      const Point2 here = finer.mesh.points[v], there = interpolated_place(p, coarser.mesh, v);
      if (is_displaced(transfers[k], v) || p.row(v).size() == 1) continue;
      EXPECT_TRUE(in_mesh(coarser.mesh, here)) << "node " << v;
      EXPECT_NEAR(distance(here, there), 0, 1e-12) << "node " << v;
    }
    for (const DisplacedNode& node : transfers[k].displaced) {
      const Point2 there = interpolated_place(p, coarser.mesh, node.node);
      EXPECT_NEAR(distance(finer.mesh.points[node.node], there), node.distance, 1e-12);
    }
    expect_no_detours(finer, coarser, transfers[k]);
  }
}

TEST(Transfer, FollowsItsDefinitionOnRandomMeshes) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    expect_transfers_by_definition(
        test::grid_mesh({.nx = 16, .ny = 12, .hole = 0.02, .seed = seed}));
}

TEST(Transfer, OfAConvexDomainDisplacesNoNode) {
  const Hierarchy hierarchy = deep_hierarchy(test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0}));
  const auto transfers = transfers_of(hierarchy).value();
  for (const Transfer& transfer : transfers) EXPECT_TRUE(transfer.displaced.empty());
}

// Nodes above and below a slit in the middle of a grid: no row may mix them.
TEST(Transfer, TakesNothingFromAcrossASlit) {
  constexpr Index kColumns = 25;
  TriangleMesh mesh = test::grid_mesh({.nx = 24, .ny = 24, .jitter = 0});
  test::cut_slit(mesh, kColumns, 12, 0, 20);
  const Hierarchy hierarchy = deep_hierarchy(mesh);
  const auto transfers = transfers_of(hierarchy).value();
  ASSERT_GE(transfers.size(), 2u);
  // The side of a node: above or below the slit, by its number among the twins.
  const auto side = [&](Index origin) {
    const Point2 p = mesh.points[origin];
    if (p.x >= 20) return 0;
    if (p.y != 12) return p.y > 12 ? 1 : -1;
    return origin >= Index{kColumns} * kColumns ? 1 : -1;
  };
  for (std::size_t k = 0; k < transfers.size(); ++k) {
    const SparseMatrix& p = transfers[k].prolongation;
    for (Index v = 0; v < p.rows(); ++v)
      for (const Index c : p.row(v))
        EXPECT_NE(side(hierarchy.levels[k].origin[v]) * side(hierarchy.levels[k + 1].origin[c]), -1)
            << "level " << k << ", node " << v;
  }
}

TEST(Transfer, KeepsIsolatedNodes) {
  TriangleMesh mesh = test::grid_mesh({.nx = 10, .ny = 10});
  mesh.points.push_back({30, 30});
  const Hierarchy hierarchy = deep_hierarchy(mesh);
  const auto transfer = transfer_between(hierarchy.levels[0], hierarchy.levels[1]);
  ASSERT_TRUE(transfer.ok());
  const SparseMatrix& p = transfer->prolongation;
  EXPECT_EQ(p.row(p.rows() - 1).size(), 1u);
  EXPECT_EQ(p.row_values(p.rows() - 1)[0], 1);
}

TEST(Transfer, RefusesAPartWithoutACoarseNode) {
  Level finer;
  finer.mesh.points = {{0, 0}, {1, 0}, {0, 1}, {5, 5}};
  finer.mesh.triangles = {{0, 1, 2}};
  Level coarser;
  coarser.mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  coarser.mesh.triangles = {{0, 1, 2}};
  coarser.parent = {0, 1, 2};
  const auto transfer = transfer_between(finer, coarser);
  ASSERT_FALSE(transfer.ok());
  EXPECT_EQ(transfer.error().ids, std::vector<Index>{3});
}

// Shrinks a hexagon to a triangle: the three corners cut off lie nearest to one edge each.
TEST(Transfer, ProjectsNodesOutsideToTheNearestBoundaryEdge) {
  Level finer;
  finer.mesh.points = {{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}, {0, 0}};
  for (Index i = 0; i < 6; ++i) finer.mesh.triangles.push_back({6, i, (i + 1) % 6});
  Level coarser;
  coarser.mesh.points = {{2, 0}, {-1, 2}, {-1, -2}};
  coarser.mesh.triangles = {{0, 1, 2}};
  coarser.parent = {0, 2, 4};
  const Transfer transfer = transfer_between(finer, coarser).value();
  ASSERT_EQ(transfer.displaced.size(), 3u);
  EXPECT_EQ(transfer.displaced[1].node, 3u);
  EXPECT_DOUBLE_EQ(transfer.displaced[1].distance, 1);
  const auto row = transfer.prolongation.row(3);
  EXPECT_EQ(std::vector<Index>(row.begin(), row.end()), (std::vector<Index>{1, 2}));
  EXPECT_DOUBLE_EQ(transfer.prolongation.row_values(3)[0], 0.5);
}

void expect_audited(const std::string& file) {
  const auto mesh = test::data_mesh(file);
  if (!mesh) GTEST_SKIP() << "no " << test::data_path(file);
  const Hierarchy hierarchy = coarsen(*mesh, multigrid_profile()).value();
  const auto transfers = transfers_of(hierarchy).value();
  for (std::size_t k = 0; k < transfers.size(); ++k)
    EXPECT_TRUE(
        audit::audit_transfer(transfers[k].prolongation, hierarchy.levels[k + 1].parent).pass());
}

TEST(Transfer, PassesTheAuditOnRealMeshes) {
  for (const char* file :
       {"thesis/airfoil1", "thesis/airfoil3_original", "thesis/crack_float32", "thesis/crack_slit",
        "graded/su2_naca0012_inv", "graded/adcirc_shinnecock", "graded/thetis_north_sea_demo"})
    expect_audited(file);
}

}  // namespace
}  // namespace wellspaced
