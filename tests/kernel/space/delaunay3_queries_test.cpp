#include "wellspaced/kernel/space/delaunay3_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/support/delaunay3_checks.hpp"
#include "tests/support/points3.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

Delaunay3 built(const std::vector<Point3>& points) {
  auto result = Delaunay3::build(points);
  EXPECT_TRUE(result.ok());
  return result.ok() ? std::move(result).value() : Delaunay3();
}

TEST(Delaunay3Queries, ValidityHoldsForEveryDegenerateFamilyAndBelowDimensionThree) {
  for (const auto& [name, points] : test::degenerate_sets3()) EXPECT_TRUE(is_valid(built(points)));
  EXPECT_TRUE(is_valid(built({})));
  EXPECT_TRUE(is_valid(built(test::lattice3(4, 4, 1))));
}

TEST(Delaunay3Queries, HullFacetsFaceOutwardsAndAreClosed) {
  for (const auto& [name, points] : test::degenerate_sets3()) {
    SCOPED_TRACE(name);
    const Delaunay3 d = built(points);
    std::set<std::pair<Index, Index>> edges;
    for (const auto& [a, b, c] : hull_facets(d)) {
      EXPECT_TRUE(edges.insert({a, b}).second && edges.insert({b, c}).second &&
                  edges.insert({c, a}).second);
      int outside = 0;
      for (const Point3 p : points) outside += orient3d(points[a], points[b], points[c], p) < 0;
      EXPECT_EQ(outside, 0);
    }
    for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u);
  }
}

TEST(Delaunay3Queries, HullVerticesIncludeThoseInsideFlatFaces) {
  EXPECT_EQ(hull_vertices(built(test::lattice3(3, 3, 3))).size(), 26u);
  EXPECT_EQ(hull_vertices(built(test::lattice3(3, 3, 1))).size(), 8u);
  EXPECT_EQ(hull_vertices(built(test::lattice3(5, 1, 1))), (std::vector<Index>{0, 4}));
  EXPECT_EQ(hull_vertices(built({{1, 1, 1}})), (std::vector<Index>{0}));
  EXPECT_TRUE(hull_vertices(built({})).empty());
}

TEST(Delaunay3Queries, StarHoldsExactlyTheTetsOfTheVertex) {
  const Delaunay3 d = built(test::whole3(200, 6, 1));
  for (Index v = 0; v < d.points().size(); ++v) {
    std::vector<Index> expected;
    for (Index t = 0; t < d.topology().size(); ++t) {
      const auto& corners = d.topology().vertices(t);
      if (std::find(corners.begin(), corners.end(), v) != corners.end()) expected.push_back(t);
    }
    std::vector<Index> tets = star(d, v);
    std::sort(tets.begin(), tets.end());
    EXPECT_EQ(tets, expected);
    EXPECT_EQ(tets.empty(), d.representative(v) != v);
  }
}

TEST(Delaunay3Queries, LinkIsASphereOnTheNeighbors) {
  const Delaunay3 d = built(test::uniform3(100, 1));
  for (Index v = 0; v < 100; ++v) {
    std::set<std::pair<Index, Index>> edges;
    std::set<Index> vertices;
    const auto facets = link(d, v);
    for (const auto& f : facets) {
      const auto [a, b, c] = d.topology().vertices(f);
      vertices.insert({a, b, c});
      for (const auto& edge : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)})
        edges.insert(edge);
    }
    EXPECT_EQ(vertices.size() - edges.size() + facets.size(), 2u);  // Euler's formula
    vertices.erase(Triangulation3::kGhost);
    EXPECT_EQ(neighbors(d, v), std::vector<Index>(vertices.begin(), vertices.end()));
  }
}

TEST(Delaunay3Queries, TetsAroundAnEdgeAreThoseThatHoldItInRingOrder) {
  const Delaunay3 d = built(test::uniform3(60, 2));
  const Triangulation3& topology = d.topology();
  for (Index t = 0; t < topology.size(); ++t)
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = 0; j < 4; ++j) {
        if (i == j) continue;
        const auto ring = tets_around_edge(topology, t, i, j);
        ASSERT_EQ(ring.front(), t);
        std::size_t holding = 0;
        for (Index u = 0; u < topology.size(); ++u) {
          const auto& v = topology.vertices(u);
          holding += std::count(v.begin(), v.end(), topology.vertex(t, i)) == 1 &&
                     std::count(v.begin(), v.end(), topology.vertex(t, j)) == 1;
        }
        EXPECT_EQ(ring.size(), holding);
        for (std::size_t k = 0; k < ring.size(); ++k) {
          const Index next = ring[(k + 1) % ring.size()];
          const auto& links = topology.links(ring[k]);
          EXPECT_TRUE(std::any_of(links.begin(), links.end(),
                                  [&](std::uint32_t link) { return link >> 2 == next; }));
        }
      }
}

TEST(Delaunay3Queries, NearestVertexIsTheLowestOfTheNearest) {
  for (const std::uint64_t below : {4, 7, 1000}) {
    const Delaunay3 d = built(test::whole3(150, below, below));
    Random random(3);
    for (int i = 0; i < 200; ++i) {
      const auto draw = [&] { return static_cast<double>(random.below(3 * below)) / 2 - 1.0; };
      const Point3 p{draw(), draw(), draw()};
      Index expected = 0;
      for (Index v = 1; v < d.points().size(); ++v)
        if (compare_distances(p, d.points()[v], d.points()[expected]) < 0) expected = v;
      EXPECT_EQ(nearest_vertex(d, p, static_cast<Index>(random.below(5000))), expected);
    }
  }
}

TEST(Delaunay3Queries, NearestVertexWorksBelowDimensionThree) {
  EXPECT_EQ(nearest_vertex(built({}), {0, 0, 0}), kNoIndex);
  EXPECT_EQ(nearest_vertex(built({{1, 0, 0}, {0, 1, 0}, {0, 0.5, 0}}), {0, 0, 0}), 2u);
}

TEST(Delaunay3Queries, CellsOfALatticeAreItsCubes) {
  const auto cells = delaunay_cells(built(test::lattice3(5, 4, 3)));
  EXPECT_EQ(cells.size(), 4u * 3 * 2);
  for (const auto& cell : cells) EXPECT_EQ(cell.size(), 8u);
}

TEST(Delaunay3Queries, PointsOfOneSphereAreOneCell) {
  const std::vector<Point3> points = test::exact_sphere3();
  const auto cells = delaunay_cells(built(points));
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].size(), points.size());
}

}  // namespace
}  // namespace wellspaced
