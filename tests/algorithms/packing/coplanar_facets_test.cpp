#include "wellspaced/algorithms/packing/coplanar_facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "tests/support/data.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

Pls::Facet facet(std::vector<Index> polygon, int marker = 0) {
  return {{std::move(polygon)}, {}, marker};
}

// The triangles of the squares of a (n + 1) x (n + 1) grid in the plane z = 0.
Pls grid(Index n) {
  Pls domain;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) domain.points.push_back({double(i), double(j), 0});
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      domain.facets.push_back(facet({a, b, b + 1}));
      domain.facets.push_back(facet({a, b + 1, a + 1}));
    }
  }
  return domain;
}

Pls cube_of_triangles() {
  Pls cube;
  for (int i = 0; i < 8; ++i)
    cube.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  const std::vector<std::vector<Index>> faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                 {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    cube.facets.push_back(facet({f[0], f[1], f[2]}));
    cube.facets.push_back(facet({f[3], f[2], f[0]}));  // turns the other way
  }
  return cube;
}

MergedFacets merged(const Pls& domain, double flatness = kFlatness) {
  auto result = merge_coplanar_facets(domain, flatness);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  return result.ok() ? std::move(result).value() : MergedFacets{};
}

std::vector<Index> sorted(std::vector<Index> list) {
  std::sort(list.begin(), list.end());
  return list;
}

TEST(CoplanarFacets, TrianglesOfACubeBecomeItsSixSquares) {
  const MergedFacets result = merged(cube_of_triangles());
  ASSERT_EQ(result.domain.facets.size(), 6u);
  for (const Pls::Facet& f : result.domain.facets) {
    ASSERT_EQ(f.polygons.size(), 1u);
    EXPECT_EQ(f.polygons[0].size(), 4u);
  }
  for (Index f = 0; f < 12; ++f) EXPECT_EQ(result.merged_into[f], f / 2);
  EXPECT_EQ(sorted(result.domain.facets[1].polygons[0]), (std::vector<Index>{4, 5, 6, 7}));
  EXPECT_TRUE(result.freed_points.empty());
  EXPECT_EQ(result.flatness, 0);
}

TEST(CoplanarFacets, PointsInsideAreFreed) {
  const MergedFacets result = merged(grid(4));
  ASSERT_EQ(result.domain.facets.size(), 1u);
  ASSERT_EQ(result.domain.facets[0].polygons.size(), 1u);
  EXPECT_EQ(result.domain.facets[0].polygons[0].size(), 16u);
  EXPECT_EQ(result.freed_points, (std::vector<Index>{6, 7, 8, 11, 12, 13, 16, 17, 18}));
}

TEST(CoplanarFacets, PointsThatOthersUseStay) {
  Pls domain = grid(4);
  domain.points.push_back({1, 1, 5});
  domain.segments.push_back({6, 25, 0});
  const MergedFacets result = merged(domain);
  ASSERT_EQ(result.domain.facets.size(), 1u);
  EXPECT_EQ(result.domain.facets[0].polygons.back(), std::vector<Index>{6});
  EXPECT_EQ(result.freed_points.size(), 8u);
}

TEST(CoplanarFacets, EdgesThatOthersHaveStay) {
  Pls domain = grid(4);
  domain.points.push_back({1, 1, 5});
  domain.facets.push_back(facet({6, 11, 25}, 7));  // stands on an edge inside
  const MergedFacets result = merged(domain);
  ASSERT_EQ(result.domain.facets.size(), 2u);
  EXPECT_EQ(result.domain.facets[0].polygons.back(), (std::vector<Index>{6, 11}));
  EXPECT_EQ(result.domain.facets[1], domain.facets.back());
  EXPECT_EQ(result.freed_points.size(), 7u);
}

TEST(CoplanarFacets, MarkersAndSegmentsSeparate) {
  Pls domain = grid(1);
  domain.facets[1].marker = 5;
  EXPECT_EQ(merged(domain).domain.facets, domain.facets);
  domain.facets[1].marker = 0;
  EXPECT_EQ(merged(domain).domain.facets.size(), 1u);
  domain.segments.push_back({3, 0, 0});  // the diagonal
  EXPECT_EQ(merged(domain).domain.facets, domain.facets);
}

TEST(CoplanarFacets, FacetsOnOneSideOfTheirEdgeAreNotJoined) {
  Pls domain;
  domain.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 2, 0}};
  domain.facets = {facet({0, 1, 2}), facet({0, 1, 3})};
  EXPECT_EQ(merged(domain).domain.facets, domain.facets);
  domain.facets[1] = facet({1, 0, 3});
  EXPECT_EQ(merged(domain).domain.facets, domain.facets);
}

TEST(CoplanarFacets, RingHasTwoPolygons) {
  Pls domain = grid(3);
  domain.facets.erase(domain.facets.begin() + 8, domain.facets.begin() + 10);  // the middle square
  const MergedFacets result = merged(domain);
  ASSERT_EQ(result.domain.facets.size(), 1u);
  const auto& polygons = result.domain.facets[0].polygons;
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0].size(), 12u);
  EXPECT_EQ(sorted(polygons[1]), (std::vector<Index>{5, 6, 9, 10}));
  EXPECT_TRUE(result.freed_points.empty());
}

TEST(CoplanarFacets, HolesAndSeveralPolygonsAreLeftAsTheyAre) {
  Pls domain = grid(1);
  domain.facets[0].holes.push_back({0.5, 0.25, 0});
  EXPECT_EQ(merged(domain).domain.facets, domain.facets);
}

TEST(CoplanarFacets, GentleBendsDoNotAddUp) {
  // Strips that turn by 0.4e-6 each: any two are flat, all together are not.
  Pls domain;
  double height = 0;
  for (Index i = 0; i <= 100; ++i) {
    domain.points.push_back({double(i), 0, height});
    domain.points.push_back({double(i), 1, height});
    height += 0.4e-6 * i;
    if (i > 0) domain.facets.push_back(facet({2 * i - 2, 2 * i - 1, 2 * i + 1, 2 * i}));
  }
  const MergedFacets result = merged(domain);
  EXPECT_GT(result.domain.facets.size(), 3u);
  EXPECT_LT(result.domain.facets.size(), 50u);
  EXPECT_GT(result.flatness, 0);
  EXPECT_LE(result.flatness, kFlatness);
  EXPECT_EQ(merged(domain, 1e-3).domain.facets.size(), 1u);
}

TEST(CoplanarFacets, ScalesAndTurnsChangeNothing) {
  const double c = std::sqrt(0.5);
  for (const double scale : {1e-30, 1.0, 1e30}) {
    Pls domain = grid(4);
    for (Point3& p : domain.points) {
      p = {p.x * c, p.y + 3, p.x * c};
      p = {scale * (p.x * c - p.y * c), scale * (p.x * c + p.y * c), scale * p.z};
    }
    const MergedFacets result = merged(domain, 1e-14);
    EXPECT_EQ(result.domain.facets.size(), 1u) << scale;
    EXPECT_EQ(result.freed_points.size(), 9u);
  }
}

TEST(CoplanarFacets, RefusesFacetsThatAreNone) {
  Pls domain = cube_of_triangles();
  domain.facets.push_back(facet({0, 1, 7, 2}));  // not flat
  domain.facets.push_back(facet({0, 1, 0}));     // no area
  domain.facets.push_back(facet({3, 4}));
  const auto refused = merge_coplanar_facets(domain);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(refused.error().ids, (std::vector<Index>{12, 13, 14}));
  domain = grid(1);
  domain.points[3] = {1e200, 1e200, 0};
  EXPECT_FALSE(merge_coplanar_facets(domain).ok());
  domain.points[3] = {std::numeric_limits<double>::quiet_NaN(), 1, 0};
  EXPECT_FALSE(merge_coplanar_facets(domain).ok());
  EXPECT_TRUE(merge_coplanar_facets(Pls{}).ok());
}

double area(const Pls& domain) {
  double sum = 0;
  for (const Pls::Facet& f : domain.facets) {
    Point3 twice{};
    for (const auto& polygon : f.polygons)
      for (std::size_t i = 2; i < polygon.size(); ++i)
        twice = twice + cross(domain.points[polygon[i - 1]] - domain.points[polygon[0]],
                              domain.points[polygon[i]] - domain.points[polygon[0]]);
    sum += std::sqrt(dot(twice, twice)) / 2;
  }
  return sum;
}

TEST(CoplanarFacets, RandomGridsKeepTheirAreaWhateverTheMarkersAndTurns) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    Pls domain = grid(6);
    for (Pls::Facet& f : domain.facets) {
      f.marker = static_cast<int>(random.below(3));
      if (random.below(2) == 0) std::reverse(f.polygons[0].begin(), f.polygons[0].end());
    }
    const MergedFacets result = merged(domain);
    EXPECT_NEAR(area(result.domain), 36, 1e-9) << seed;
    EXPECT_LT(result.domain.facets.size(), domain.facets.size());
    for (Index f = 0; f < domain.facets.size(); ++f)
      EXPECT_EQ(result.domain.facets[result.merged_into[f]].marker, domain.facets[f].marker);
  }
}

// A TetGen .smesh whose facets are one polygon a line.
Pls read_smesh(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  for (std::string line; std::getline(file, line);)
    if (line.rfind('#', 0) != 0) text << line << '\n';
  Pls domain;
  std::size_t points = 0, facets = 0, skip = 0;
  text >> points >> skip >> skip >> skip;
  domain.points.resize(points);
  for (Point3& p : domain.points) text >> skip >> p.x >> p.y >> p.z;
  text >> facets >> skip;
  for (std::size_t f = 0; f < facets; ++f) {
    std::size_t corners = 0;
    text >> corners;
    std::vector<Index> polygon(corners);
    for (Index& v : polygon) text >> v, --v;
    domain.facets.push_back(facet(polygon));
  }
  EXPECT_TRUE(text) << path;
  return domain;
}

// A closed surface stays one: every edge of the merged facets has two of them.
void expect_closed(const Pls& domain) {
  std::map<std::pair<Index, Index>, int> uses;
  for (const Pls::Facet& f : domain.facets)
    for (const auto& polygon : f.polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i)
        ++uses[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
  for (const auto& [edge, count] : uses) EXPECT_EQ(count, 2) << edge.first << ' ' << edge.second;
}

TEST(CoplanarFacets, PublicSurfacesBecomeTheirFaces) {
  WELLSPACED_REQUIRE_DATA("domains3d/cgal_cube.smesh");
  const std::map<std::string, std::size_t> faces = {
      {"cube", 6}, {"beam", 6}, {"corner", 8}, {"cross", 14}};  // prisms over an L and a plus
  for (const auto& [name, count] : faces) {
    SCOPED_TRACE(name);
    const Pls domain = read_smesh(test::data_path("domains3d/cgal_" + name + ".smesh"));
    const MergedFacets result = merged(domain);
    EXPECT_EQ(result.domain.facets.size(), count);
    EXPECT_NEAR(area(result.domain), area(domain), 1e-9 * area(domain));
    expect_closed(result.domain);
  }
}

}  // namespace
}  // namespace wellspaced
