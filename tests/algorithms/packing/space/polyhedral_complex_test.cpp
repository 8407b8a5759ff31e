#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/solids.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

PolyhedralComplex complex_of(const Pls& domain) {
  auto complex = build_complex(domain);
  EXPECT_TRUE(complex.ok()) << (complex.ok() ? "" : complex.error().message);
  return complex.ok() ? std::move(complex).value() : PolyhedralComplex{};
}

double area_of(const PolyhedralComplex& complex, const PolyhedralComplex::Facet& facet) {
  double area = 0;
  for (const auto& [a, b, c] : facet.triangles)
    area += length(cross(complex.points[b] - complex.points[a],
                         complex.points[c] - complex.points[a])) /
            2;
  return area;
}

TEST(PolyhedralComplex, MakesSixSquaresOfTheTwelveTrianglesOfACube) {
  for (const Pls& domain : {test::triangulated_cube(), test::turned(test::triangulated_cube())}) {
    const PolyhedralComplex complex = complex_of(domain);
    ASSERT_EQ(complex.facets.size(), 6u);
    EXPECT_EQ(complex.segments.size(), 12u);
    for (const auto& facet : complex.facets) {
      EXPECT_TRUE(facet.is_convex);
      EXPECT_EQ(facet.points.size(), 4u);
      EXPECT_EQ(facet.segments.size(), 4u);
      EXPECT_NEAR(area_of(complex, facet), 1, 1e-12);
    }
  }
}

TEST(PolyhedralComplex, CoversFacetsThatAreNotConvex) {
  for (const Pls& domain : {test::l_prism(), test::turned(test::l_prism())}) {
    const PolyhedralComplex complex = complex_of(domain);
    ASSERT_EQ(complex.facets.size(), 8u);
    EXPECT_EQ(complex.segments.size(), 18u);
    for (std::size_t f = 0; f < 8; ++f) EXPECT_EQ(complex.facets[f].is_convex, f >= 2);
    EXPECT_NEAR(area_of(complex, complex.facets[0]), 3, 1e-12);
  }
}

TEST(PolyhedralComplex, LeavesHolesOfFacetsOpen) {
  const PolyhedralComplex complex = complex_of(test::turned(test::two_boxes()));
  ASSERT_EQ(complex.facets.size(), 12u);
  EXPECT_NEAR(area_of(complex, complex.facets[1]), 3, 1e-12);
  EXPECT_NEAR(area_of(complex, complex.facets[6]), 1, 1e-12);
  EXPECT_FALSE(complex.facets[1].is_convex);
  EXPECT_EQ(complex.facets[1].segments.size(), 8u);
  EXPECT_EQ(complex.segments.size(), 24u);
}

TEST(PolyhedralComplex, LeavesTheEndsOfATriangulatedTubeOpen) {
  for (const Pls& domain : {test::triangulated_tube(), test::turned(test::triangulated_tube())}) {
    const PolyhedralComplex complex = complex_of(domain);
    ASSERT_EQ(complex.facets.size(), 10u);
    double area = 0;
    for (const auto& facet : complex.facets) area += area_of(complex, facet);
    EXPECT_NEAR(area, 2 * 8 + 3 * (12 + 4), 1e-12);
  }
}

TEST(PolyhedralComplex, KeepsSegmentsAndPointsInsideAndOnFacets) {
  Pls domain = test::furnished_box();
  domain.points.push_back({1, 1, 0});
  domain.points.push_back({3, 3, 0});
  domain.facets[0].polygons.push_back({15});  // on the bottom: a point
  domain.facets[0].polygons.push_back({16, 15});
  const PolyhedralComplex complex = complex_of(domain);
  EXPECT_EQ(complex.segments.size(), 12u + 4 + 1 + 1);
  EXPECT_EQ(complex.facets[0].points.size(), 6u);
  EXPECT_EQ(complex.facets[0].segments.size(), 5u);
  EXPECT_TRUE(complex.facets[0].is_convex);
  int sevens = 0;
  for (const Segment& s : complex.segments) sevens += s.marker == 7;
  EXPECT_EQ(sevens, 1);
}

TEST(PolyhedralComplex, WeldsPointsThatCoincide) {
  Pls domain;
  for (const auto& side : test::kBoxSides) {  // every facet with points of its own
    Pls corners;
    test::add_corners(corners, {0, 0, 0}, {1, 1, 1});
    const auto first = static_cast<Index>(domain.points.size());
    for (const Index v : side) domain.points.push_back(corners.points[v]);
    domain.facets.push_back(test::polygon({first, first + 1, first + 2, first + 3}));
  }
  const PolyhedralComplex complex = complex_of(domain);
  EXPECT_EQ(complex.segments.size(), 12u);
  int vertices = 0;
  for (const auto is_vertex : complex.is_vertex) vertices += is_vertex;
  EXPECT_EQ(vertices, 8);
  ASSERT_EQ(complex.notes.size(), 1u);
  EXPECT_EQ(complex.notes[0], "16 points coincide with others");
}

TEST(PolyhedralComplex, RefusesWhatIsNoDomain) {
  const auto error_of = [](const Pls& domain) {
    const auto complex = build_complex(domain);
    EXPECT_FALSE(complex.ok());
    return complex.ok() ? Error{} : complex.error();
  };
  Pls nan = test::unit_cube();
  nan.points[3].y = NAN;
  EXPECT_EQ(error_of(nan).ids, std::vector<Index>{3});
  Pls nameless = test::unit_cube();
  nameless.facets[2].polygons[0][1] = 8;
  EXPECT_EQ(error_of(nameless).ids, std::vector<Index>{2});
  Pls bent = test::unit_cube();
  bent.points[7] = {1, 1.25, 1.25};
  EXPECT_EQ(error_of(bent).code, ErrorCode::kInvalidGeometry);
  Pls bow_tie = test::unit_cube();
  bow_tie.facets[4].polygons[0] = {0, 6, 2, 4};
  EXPECT_EQ(error_of(bow_tie).ids, std::vector<Index>{4});
  Pls empty_facet = test::unit_cube();
  empty_facet.facets.push_back({});
  EXPECT_EQ(error_of(empty_facet).ids, std::vector<Index>{6});
}

}  // namespace
}  // namespace wellspaced
