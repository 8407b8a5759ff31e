#include "wellspaced/io/formats/space_domain.hpp"

#include <gtest/gtest.h>

#include "tests/support/damage.hpp"
#include "tests/support/data.hpp"
#include "tests/support/formats.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"

namespace wellspaced {
namespace {

using test::data_path;
using test::expect_refused;
using test::parsed;
using test::TemporaryDirectory;
using Polygons = std::vector<std::vector<Index>>;

constexpr const char* kPoints = "5 3 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n";

Geometry poly(std::string_view text) {
  return parsed([](std::string_view t, const TextSource& n) { return parse_poly(t, n); }, text);
}

Geometry smesh(std::string_view text) {
  return parsed([](std::string_view t, const TextSource& n) { return parse_smesh(t, n); }, text);
}

void expect_poly_refused(const std::string& text, const std::string& part) {
  expect_refused([](std::string_view t, const TextSource& n) { return parse_poly(t, n); },
                 kPoints + text, part);
}

std::string written(const Geometry& g, FacetSyntax syntax) {
  TextWriter out;
  if (syntax == FacetSyntax::kPoly) write_poly(out, g, PolyPoints::kInside);
  if (syntax == FacetSyntax::kSmesh) write_smesh(out, g, PolyPoints::kInside);
  return out.text();
}

TEST(ParsePolyInSpace, ReadsFacetsWithPolygonsAndHoles) {
  const Geometry g = poly(std::string(kPoints) +
                          "2 1\n2 1 7 # a facet\n4 1 2\n3 4\n1 5\n1 0.5 0.5 0\n1\n3 1 2 5\n"
                          "1\n1 0.5 0.25 0.125\n2\n1 1 1 1 -3 0.1\n2 2 2 2 4\n");
  ASSERT_EQ(g.polygons.size(), 2u);
  EXPECT_EQ(g.polygons[0].polygons, (Polygons{{0, 1, 2, 3}, {4}})) << "corners go on in a new line";
  EXPECT_EQ(g.polygons[0].holes, (std::vector<Point3>{{0.5, 0.5, 0}}));
  EXPECT_EQ(g.polygons[0].marker, 7);
  EXPECT_EQ(g.polygons[1].marker, 0) << "the marker may be missing";
  EXPECT_EQ(g.volume_holes, (std::vector<Point3>{{0.5, 0.25, 0.125}}));
  ASSERT_EQ(g.volume_regions.size(), 2u);
  EXPECT_EQ(g.volume_regions[0], (Pls::Region{{1, 1, 1}, -3, 0.1}));
  EXPECT_EQ(g.volume_regions[1].max_volume, -1);
}

TEST(ParsePolyInSpace, ReadsFacetsOfTwoPointsAsSegments) {
  const Geometry g = poly(std::string(kPoints) + "2 1\n1 0 3\n2 1 5\n1 0 4\n3 1 2 3\n");
  EXPECT_EQ(g.solid.segments, (std::vector<Segment>{{0, 4, 3}}));
  EXPECT_EQ(g.solid.facets, (std::vector<TetMesh::Facet>{{{0, 1, 2}, 4}}));
}

TEST(ParseSmesh, ReadsOnePolygonALine) {
  const Geometry g = smesh(std::string(kPoints) + "2 1\n3 1 2 5 6\n4 1 2 3 4 -2\n0\n0\n");
  ASSERT_EQ(g.polygons.size(), 2u);
  EXPECT_EQ(g.polygons[0].marker, 6);
  EXPECT_EQ(g.polygons[1].polygons, (Polygons{{0, 1, 2, 3}}));
}

TEST(ParsePolyInSpace, NamesTheLineOfWhatIsWrong) {
  expect_poly_refused("", "the file ends where the number of facets should follow");
  expect_poly_refused("9000000 0\n1\n3 1 2 3\n", "x:7: the file is too short for the 9000000");
  expect_poly_refused("1 0\n90000\n3 1 2 3\n", "x:8: the file is too short for the 90000 poly");
  expect_poly_refused("1 0\n1 500\n3 1 2 3\n", "x:8: the file is too short for the 500 holes");
  expect_poly_refused("1 0\n1\n3 1 2 6\n", "x:9: point 6 is not among the points");
  expect_poly_refused("1 0\n1\n4 1 2 3\n", "the next corner of the polygon");
  expect_poly_refused("1 0\n1\n0 0 0\n", "x:9: a polygon without corners");
  expect_poly_refused("1 0\n1\n-3 1 2 3\n", "number of corners is negative");
  expect_poly_refused("1 0\n1\n3 1 2 3\n1\n1 0 0 nan\n", "x:11: the z coordinate 'nan'");
  expect_poly_refused("1 0\n1\n3 1 2 3\n0\n0\n7\n", "x:12: more lines follow");
}

TEST(WriteSpaceDomain, ReadsBackAsItWas) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Geometry g = test::random_surface(seed);
    g.index_base = static_cast<Index>(seed / 2 % 2);
    g.volume_holes = {{0.5, 0.25, 0.125}};
    g.volume_regions = {{{1, 2, 3}, 4.5, -1}};
    if (seed % 2 == 1) g.polygons.push_back({{{0, 1, 2}, {3, 4}, {5}}, {{1e-300, 2, 3}}, 9});
    const std::string text = written(g, FacetSyntax::kPoly);
    const Geometry back = poly(text);
    EXPECT_EQ(back.solid.points, g.solid.points);
    EXPECT_EQ(back.solid.facets, g.solid.facets);
    EXPECT_EQ(back.polygons, g.polygons);
    EXPECT_EQ(back.solid.segments, g.solid.segments);
    EXPECT_EQ(back.volume_holes, g.volume_holes);
    EXPECT_EQ(back.volume_regions, g.volume_regions);
    EXPECT_EQ(written(back, FacetSyntax::kPoly), text);
    if (seed % 2 == 1) g.polygons.pop_back();
    const std::string simple = written(g, FacetSyntax::kSmesh);
    EXPECT_EQ(written(smesh(simple), FacetSyntax::kSmesh), simple);
  }
}

TEST(ParsePolyInSpace, SurvivesDamage) {
  Geometry g = test::random_surface(1);
  g.polygons.push_back({{{0, 1, 2}, {3, 4}, {5}}, {{1e-300, 2, 3}}, 9});
  g.volume_holes = {{0.5, 0.25, 0.125}};
  const std::string text = written(g, FacetSyntax::kPoly);
  test::expect_survives_damage(
      [](std::string_view t, const TextSource& n) { return parse_poly(t, n); }, text);
}

TEST(ReadTriangleSet, ReadsAMeshInSpaceWithItsFacesAndEdges) {
  const TemporaryDirectory directory;
  directory.write("a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  directory.write("a.ele", "1 4 0\n0 0 1 2 3\n");
  directory.write("a.face", "2 1\n0 0 2 1 5\n1 0 1 3 -6\n");
  directory.write("a.edge", "2 1\n0 0 1 8\n1 1 2 0\n");
  directory.write("a.smesh", "0 3 0 0\n1 0\n3 0 1 2\n0\n0\n");
  const auto g = read_triangle_set(directory / "a.face");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->solid.tets.size(), 1u);
  EXPECT_EQ(g->solid.facets, (std::vector<TetMesh::Facet>{{{0, 2, 1}, 5}, {{0, 1, 3}, -6}}));
  EXPECT_EQ(g->solid.segments, (std::vector<Segment>{{0, 1, 8}}));

  OutputSet outputs;
  ASSERT_TRUE(write_geometry(outputs, directory / "b.node", "", *g).ok());
  ASSERT_TRUE(outputs.commit().ok());
  const auto back = read_triangle_set(directory / "b");
  ASSERT_FALSE(back.ok()) << "b is no file";
  const auto again = read_geometry(directory / "b");
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(again->solid.facets, g->solid.facets);
  EXPECT_EQ(again->solid.segments, g->solid.segments);
}

TEST(ReadTriangleSet, ReadsADomainInSpaceWithThePointsOfItsNodeFile) {
  const TemporaryDirectory directory;
  directory.write("a.node", kPoints);
  directory.write("a.poly", "0 3 0 0\n1 0\n1\n4 1 2 3 4\n0\n");
  const auto g = read_geometry(directory / "a");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->solid.points.size(), 5u);
  EXPECT_EQ(to_pls(*g).facets.size(), 1u);
  OutputSet outputs;
  ASSERT_TRUE(write_geometry(outputs, directory / "b.smesh", "", *g).ok());
  ASSERT_TRUE(write_geometry(outputs, directory / "c.poly", "", *g).ok());
  ASSERT_TRUE(outputs.commit().ok());
  for (const char* name : {"b.smesh", "c.poly"}) {
    const auto back = read_geometry(directory / name);
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(back->polygons, g->polygons) << name;
  }
}

TEST(RealDomains, HaveTheFacetsOfTheirFiles) {
  struct Expected {
    const char* name;
    std::size_t points, facets;
  };
  for (const auto& [name, points, facets] :
       {Expected{"domains3d/cgal_cube.smesh", 8, 12}, Expected{"domains3d/cgal_beam.smesh", 8, 6},
        Expected{"domains3d/cgal_cross.smesh", 40, 76},
        Expected{"domains3d/cgal_pipe.smesh", 160, 320},
        Expected{"domains3d/tetgen_example.poly", 28, 23}}) {
    WELLSPACED_REQUIRE_DATA(name);
    const auto g = read_geometry(data_path(name));
    ASSERT_TRUE(g.ok()) << g.error().message;
    const Pls domain = to_pls(*g);
    EXPECT_EQ(domain.points.size(), points) << name;
    EXPECT_EQ(domain.facets.size(), facets) << name;
    const Geometry back = to_geometry(domain, g->index_base);
    EXPECT_EQ(back.polygons, g->polygons);
    EXPECT_EQ(back.solid.facets, g->solid.facets);
  }
}

}  // namespace
}  // namespace wellspaced
