// Our Delaunay triangulation of space against CGAL's, cell by cell: built only where CGAL is found.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/points3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

namespace wellspaced {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using Structure =
    CGAL::Triangulation_data_structure_3<VertexBase,
                                         CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Peer = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
using Cells = std::set<std::vector<Index>>;

// Every tet's vertices together with those that its neighbours add on the same sphere, until none
// does: CGAL's cells, ties merged by CGAL's own predicate.
Cells peer_cells(const Peer& peer) {
  Cells cells;
  std::set<Peer::Cell_handle> done;
  for (const auto first : peer.finite_cell_handles()) {
    if (!done.insert(first).second) continue;
    std::vector<Peer::Cell_handle> same{first};
    std::set<Index> vertices;
    for (std::size_t next = 0; next < same.size(); ++next) {
      const auto cell = same[next];
      for (int i = 0; i < 4; ++i) {
        vertices.insert(cell->vertex(i)->info());
        const auto other = cell->neighbor(i);
        if (peer.is_infinite(other) || done.count(other) != 0) continue;
        const auto& p = other->vertex(other->index(cell))->point();
        const auto side =
            CGAL::side_of_oriented_sphere(cell->vertex(0)->point(), cell->vertex(1)->point(),
                                          cell->vertex(2)->point(), cell->vertex(3)->point(), p);
        if (side != CGAL::ON_ORIENTED_BOUNDARY) continue;
        done.insert(other);
        same.push_back(other);
      }
    }
    cells.insert({vertices.begin(), vertices.end()});
  }
  return cells;
}

TEST(Delaunay3AgainstCgal, HasTheSameCellsForEveryFamily) {
  auto sets = test::degenerate_sets3();
  sets.push_back({"uniform, many", test::uniform3(20000, 9)});
  for (const auto& [name, points] : sets) {
    SCOPED_TRACE(name);
    const auto ours = Delaunay3::build(points);
    ASSERT_TRUE(ours.ok());
    std::vector<std::pair<Kernel::Point_3, Index>> input;
    for (Index v = 0; v < points.size(); ++v)
      if (ours->representative(v) == v)
        input.emplace_back(Kernel::Point_3(points[v].x, points[v].y, points[v].z), v);
    const Peer peer(input.begin(), input.end());
    ASSERT_EQ(peer.dimension(), ours->dimension());
    const auto cells = delaunay_cells(*ours);
    EXPECT_EQ(Cells(cells.begin(), cells.end()), peer_cells(peer));
  }
}

}  // namespace
}  // namespace wellspaced
