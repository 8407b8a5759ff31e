#include "wellspaced/kernel/space/voronoi3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/support/points3.hpp"

namespace wellspaced {
namespace {

Delaunay3 built(const std::vector<Point3>& points) {
  auto result = Delaunay3::build(points);
  EXPECT_TRUE(result.ok());
  return result.ok() ? std::move(result).value() : Delaunay3();
}

TEST(Voronoi3, CellInsideALatticeIsACubeInSpiteOfTies) {
  const Delaunay3 d = built(test::lattice3(3, 3, 3));
  const VoronoiCell3 cell = voronoi_cell(d, 13, {{-10, -10, -10}, {10, 10, 10}});
  EXPECT_EQ(cell.facets.size(), 6u);
  EXPECT_EQ(cell.vertices.size(), 8u);
  EXPECT_EQ(cell.volume, 1.0);
  for (const auto& facet : cell.facets) {
    EXPECT_EQ(facet.corners.size(), 4u);
    EXPECT_NE(facet.neighbor, kNoIndex);
  }
}

TEST(Voronoi3, CellAtTheHullIsCutOffByTheBox) {
  const Delaunay3 d = built(test::lattice3(3, 3, 3));
  const VoronoiCell3 cell = voronoi_cell(d, 0, {{-2, -2, -2}, {10, 10, 10}});
  EXPECT_EQ(cell.facets.size(), 6u);
  EXPECT_NEAR(cell.volume, 2.5 * 2.5 * 2.5, 1e-12);
  EXPECT_EQ(std::count_if(cell.facets.begin(), cell.facets.end(),
                          [](const auto& f) { return f.neighbor == kNoIndex; }),
            3);
}

// Four facets meet in some of its corners.
TEST(Voronoi3, CellOfTheFaceCentredLatticeIsARhombicDodecahedron) {
  std::vector<Point3> points;
  Index middle = 0;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if ((x + y + z) % 2 == 0) {
          if (x == 0 && y == 0 && z == 0) middle = static_cast<Index>(points.size());
          points.push_back({double(x), double(y), double(z)});
        }
  const VoronoiCell3 cell = voronoi_cell(built(points), middle, {{-9, -9, -9}, {9, 9, 9}});
  EXPECT_EQ(cell.facets.size(), 12u);
  EXPECT_EQ(cell.vertices.size(), 14u);
  EXPECT_NEAR(cell.volume, 2, 1e-14);
}

TEST(Voronoi3, CellsFillTheBox) {
  for (const auto& [name, points] : test::degenerate_sets3()) {
    SCOPED_TRACE(name);
    Box3 box{{-1, -2, -3}, {4, 5, 6}};
    double largest = 0;
    for (const Point3 p : points)
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    // Beyond what voronoi_cell asks for.
    if (largest > 0x1p200 || largest < 0x1p-200 || name.find("2^-1000") != name.npos) continue;
    const double scale = largest / 4;
    for (double* x : {&box.low.x, &box.low.y, &box.low.z, &box.high.x, &box.high.y, &box.high.z})
      *x *= scale;
    const Delaunay3 d = built(points);
    double volume = 0;
    for (Index v = 0; v < points.size(); ++v)
      if (d.representative(v) == v) volume += voronoi_cell(d, v, box).volume;
    EXPECT_NEAR(volume / (scale * scale * scale), 5.0 * 7 * 9, 1e-9);
  }
}

TEST(Voronoi3, EveryEdgeOfACellBelongsToTwoFacets) {
  const Delaunay3 d = built(test::uniform3(200, 3));
  for (Index v = 0; v < 200; ++v) {
    std::map<std::pair<Index, Index>, int> edges;
    const VoronoiCell3 cell = voronoi_cell(d, v, {{0, 0, 0}, {1, 1, 1}});
    for (const auto& facet : cell.facets)
      for (std::size_t i = 0; i < facet.corners.size(); ++i)
        ++edges[{facet.corners[i], facet.corners[(i + 1) % facet.corners.size()]}];
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_EQ(cell.vertices.size() - edges.size() / 2 + cell.facets.size(), 2u);
  }
}

TEST(Voronoi3, CornersAreEquallyFarFromTheNeighborsOfTheirFacets) {
  const Delaunay3 d = built(test::uniform3(100, 4));
  const auto distance = [](Point3 a, Point3 b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  };
  for (Index v = 0; v < 100; ++v) {
    const VoronoiCell3 cell = voronoi_cell(d, v, {{0, 0, 0}, {1, 1, 1}});
    for (const auto& facet : cell.facets)
      for (const Index c : facet.corners)
        if (facet.neighbor != kNoIndex)
          EXPECT_NEAR(distance(cell.vertices[c], d.points()[v]),
                      distance(cell.vertices[c], d.points()[facet.neighbor]), 1e-9);
  }
}

TEST(Voronoi3, BoxOffTheCellLeavesNothing) {
  const Delaunay3 d = built(test::lattice3(3, 3, 3));
  const VoronoiCell3 cell = voronoi_cell(d, 0, {{5, 5, 5}, {6, 6, 6}});
  EXPECT_TRUE(cell.facets.empty());
  EXPECT_EQ(cell.volume, 0);
}

}  // namespace
}  // namespace wellspaced
