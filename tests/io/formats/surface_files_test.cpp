#include "wellspaced/io/formats/surface_files.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "tests/support/damage.hpp"
#include "tests/support/data.hpp"
#include "tests/support/formats.hpp"
#include "wellspaced/io/text/bytes.hpp"

namespace wellspaced {
namespace {

using test::expect_refused;
using test::parsed;
using test::written_by;
using Faces = std::vector<TetMesh::Facet>;

// ---- OFF -----------------------------------------------------------------------------------

TEST(ParseOff, AcceptsEveryHeaderOfTheWild) {
  const std::string body = "0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n";
  for (const std::string& header :
       {std::string("OFF\n3 1 0\n"), std::string("OFF 3 1 0\n"), std::string("3 1 0\n"),
        std::string("COFF\n# c\n\n3 1 99\n"), std::string("OFF # c\n3 1\n"),
        std::string("\xEF\xBB\xBFNOFF\r\n3 1 0\r\n"), std::string("STOFF\n3\t1\t0\n")}) {
    const Geometry g = parsed(parse_off, header + body);
    EXPECT_EQ(g.dimension, 3) << header;
    EXPECT_EQ(g.solid.points.size(), 3u) << header;
    EXPECT_EQ(g.solid.facets, (Faces{{{0, 1, 2}, 0}})) << header;
  }
}

TEST(ParseOff, PassesOverColoursAndNormals) {
  const Geometry g = parsed(parse_off,
                            "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 1\n"
                            "3 0 1 2 0.5 0.5 0.5\n");
  EXPECT_EQ(g.solid.points[1], (Point3{1, 0, 0}));
  EXPECT_EQ(g.solid.facets.size(), 1u);
}

TEST(ParseOff, KeepsTheOrderOfMixedFaces) {
  const Geometry g = parsed(
      parse_off, "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n3 0 1 4\n4 0 1 2 3\n2 0 4\n1 3\n");
  ASSERT_EQ(g.polygons.size(), 2u);
  EXPECT_TRUE(g.solid.facets.empty());
  EXPECT_EQ(g.polygons[0].polygons[0], (std::vector<Index>{0, 1, 4}));
  EXPECT_EQ(g.polygons[1].polygons[0], (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(g.solid.segments, (std::vector<Segment>{{0, 4, 0}}));
}

TEST(ParseOff, ReadsFlatTrianglesAsAMeshInThePlane) {
  const Geometry g = parsed(parse_off, "OFF\n3 1 0\n0 0 0\n1 0 -0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(g.dimension, 2);
  EXPECT_EQ(g.mesh.triangles.size(), 1u);
}

TEST(ParseOff, RefusesWhatItCannotRead) {
  expect_refused(parse_off, "", "the file ends where the keyword OFF");
  expect_refused(parse_off, "OFF BINARY\n\x01\x02", "binary OFF");
  expect_refused(parse_off, "4OFF\n1 0 0\n0 0 0 1\n", "three coordinates");
  expect_refused(parse_off, "OFF\n4000000000 1 0\n0 0 0\n", "x:2: the file is too short");
  expect_refused(parse_off, "OFF\n1 -1 0\n0 0 0\n", "number of faces is negative");
  expect_refused(parse_off, "OFF\n2 0 0\n0.00 0.00 0.00\n1 0", "x:4: the z coordinate is missing");
  expect_refused(parse_off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "x:4: point 1 is not among");
  expect_refused(parse_off, "OFF\n1 1 0\n0 0 0\n4 0 0 0\n", "x:4: the point number is missing");
  expect_refused(parse_off, "OFF\n1 0 0\n0 nan 0\n", "x:3: the y coordinate 'nan' is not finite");
  expect_refused(parse_off, "OFF\n1 0 0\n0 0 0\n1 1 1\n", "x:4: more lines follow");
}

// ---- OBJ -----------------------------------------------------------------------------------

TEST(ParseObj, ReadsEveryKindOfCorner) {
  const Geometry g =
      parsed(parse_obj,
             "mtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 1 1\nvt 0 0\nvn "
             "0 0 1\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -3 -2 -1\n");
  EXPECT_EQ(g.solid.facets,
            (Faces{{{0, 1, 2}, 0}, {{0, 1, 2}, 0}, {{0, 1, 2}, 0}, {{0, 1, 2}, 0}}));
}

TEST(ParseObj, CountsNegativeNumbersFromTheVerticesSoFar) {
  const Geometry g =
      parsed(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\nv 9 9 9\nf -1 -2 -3\n");
  EXPECT_EQ(g.solid.facets, (Faces{{{2, 1, 0}, 0}, {{3, 2, 1}, 0}}));
}

TEST(ParseObj, JoinsLinesAtABackslash) {
  for (const char* face : {"f 1 2 \\\n3\n", "f 1 2\\\n 3\n", "f \\\r\n1 2 3\r\n"})
    EXPECT_EQ(parsed(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 1\n" + std::string(face)).solid.facets,
              (Faces{{{0, 1, 2}, 0}}));
}

TEST(ParseObj, MakesMarkersOfGroups) {
  const Geometry g = parsed(parse_obj,
                            "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\ng wall\nf 1 2 3\ng 7\nf 1 2 3\ng "
                            "wall\nl 1 2 3\ng\nf 1 2 3\n");
  EXPECT_EQ(g.solid.facets,
            (Faces{{{0, 1, 2}, 0}, {{0, 1, 2}, 1}, {{0, 1, 2}, 7}, {{0, 1, 2}, 0}}));
  EXPECT_EQ(g.solid.segments, (std::vector<Segment>{{0, 1, 1}, {1, 2, 1}}));
  EXPECT_EQ(g.marker_names, (std::vector<MarkerName>{{2, 1, "wall"}}));
  EXPECT_EQ(parsed(parse_obj, written_by(write_obj, g)).marker_names, g.marker_names);
}

TEST(ParseObj, RefusesWhatItCannotRead) {
  expect_refused(parse_obj, "# nothing\n", "no vertex");
  expect_refused(parse_obj, "v 0 0\n", "x:1: the z coordinate is missing");
  expect_refused(parse_obj, "v 0 0 0\nf 1 1 2\n", "x:2: point 2 is not among the 1 points");
  expect_refused(parse_obj, "v 0 0 0\nf 1 1 0\n", "point 0");
  expect_refused(parse_obj, "v 0 0 0\nf -2 1 1\n", "point -2");
  expect_refused(parse_obj, "v 0 0 0\nf a b c\n", "'a' is not an integer");
  expect_refused(parse_obj, "v 0 0 0\nf 1 1\n", "three corners");
  expect_refused(parse_obj, "v 0 0 0\nf 1 1 \\", "the file ends where the rest");
  expect_refused(parse_obj, "v 0 inf 0\n", "not finite");
}

// ---- STL -----------------------------------------------------------------------------------

constexpr const char* kSolid =
    "solid a b\n facet normal nan 0 0\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex "
    "0 1 1\n  endloop\n endfacet\nendsolid a b\n";

std::string binary_stl(std::string_view header, const std::vector<std::array<float, 9>>& facets) {
  std::string bytes(header);
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    for (int i = 0; i < 3; ++i) append_bytes(bytes, 0.0f);
    for (const float c : facet) append_bytes(bytes, c);
    append_bytes(bytes, std::uint16_t{7});
  }
  return bytes;
}

TEST(ParseStl, ReadsTextWhateverItsCaseAndLines) {
  std::string upper = kSolid;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string one_line = kSolid;
  for (char& c : one_line)
    if (c == '\n' && &c > one_line.data() + 10) c = ' ';
  for (const std::string& text : {std::string(kSolid), upper, one_line}) {
    const Geometry g = parsed(parse_stl, text);
    EXPECT_EQ(g.solid.points, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}));
    EXPECT_EQ(g.solid.facets, (Faces{{{0, 1, 2}, 0}}));
  }
}

TEST(ParseStl, TellsBinaryFilesByTheirSizeEvenIfTheyBeginWithSolid) {
  const std::string bytes = binary_stl("solid but binary", {{0, 0, 0, 1, 0, 0, 0, 1, 1}});
  EXPECT_TRUE(recognise_stl(bytes));
  EXPECT_EQ(parsed(parse_stl, bytes).solid.facets, (Faces{{{0, 1, 2}, 0}}));
}

TEST(ParseStl, WeldsCornersByTheirExactCoordinates) {
  const float tiny = 1e-38f;
  const Geometry g = parsed(
      parse_stl, binary_stl("", {{0, 0, 0, 1, 0, 0, 0, 1, 1}, {-0.0f, 0, 0, 1, 0, 0, tiny, 1, 1}}));
  EXPECT_EQ(g.solid.points.size(), 4u);
  EXPECT_EQ(g.solid.facets, (Faces{{{0, 1, 2}, 0}, {{0, 1, 3}, 0}}));
}

TEST(ParseStl, SaysHowManyFacetsWithoutThreeCornersItLeavesOut) {
  const Geometry g =
      parsed(parse_stl, binary_stl("", {{0, 0, 0, 0, 0, 0, 0, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 1, 1}}));
  EXPECT_EQ(g.solid.facets.size(), 1u);
  ASSERT_EQ(g.notes.size(), 1u);
  EXPECT_EQ(g.notes[0], "x: 1 facets with coincident corners were left out");
}

TEST(ParseStl, NumbersSeveralSolids) {
  const Geometry g = parsed(parse_stl, std::string(kSolid) + kSolid);
  EXPECT_EQ(g.solid.facets, (Faces{{{0, 1, 2}, 1}, {{0, 1, 2}, 2}}));
}

TEST(ParseStl, RefusesWhatItCannotRead) {
  expect_refused(parse_stl, "", "x: the solid is missing");
  expect_refused(parse_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nendloop",
                 "endloop");
  expect_refused(parse_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n", "x:4:");
  expect_refused(parse_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "missing");
  expect_refused(parse_stl, "solid a\nsomething\n", "where facet or endsolid should stand");
  expect_refused(parse_stl,
                 binary_stl("", {{0, 0, std::bit_cast<float>(0x7fc00000u), 0, 0, 0, 0, 1, 1}}),
                 "facet 0 (counted from 0) is not finite");
}

TEST(WriteStl, RefusesWhatBinaryFilesCannotHold) {
  Geometry g;
  g.mesh.points = {{0, 0}, {1e39, 0}, {0, 1}};
  g.mesh.triangles = {{0, 1, 2}};
  OutputSet outputs;
  EXPECT_EQ(write_stl_binary(outputs, "-", g).error().code, ErrorCode::kUsage);
  EXPECT_EQ(parsed(parse_stl, written_by(write_stl, g)).mesh.points, g.mesh.points);
}

// ---- All of them ---------------------------------------------------------------------------

TEST(SurfaceFiles, GiveBackRandomSurfacesBitForBit) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Geometry g = test::random_surface(seed);
    const Geometry off = parsed(parse_off, written_by(write_off, g));
    EXPECT_EQ(off.solid.points, g.solid.points);
    EXPECT_EQ(written_by(write_off, off), written_by(write_off, g));
    const Geometry obj = parsed(parse_obj, written_by(write_obj, g));
    EXPECT_EQ(obj.solid.points, g.solid.points);
    EXPECT_EQ(obj.solid.facets, g.solid.facets);
    EXPECT_EQ(obj.polygons, g.polygons);
    EXPECT_EQ(obj.solid.segments, g.solid.segments);
    if (!g.polygons.empty()) continue;
    const std::string stl = written_by(write_stl, g);
    EXPECT_EQ(written_by(write_stl, parsed(parse_stl, stl)), stl);
    const std::string binary = written_by(write_stl_binary, g);
    EXPECT_TRUE(written_by(write_stl_binary, parsed(parse_stl, binary)) == binary);
  }
}

TEST(SurfaceFiles, RefuseTetrahedraAndFacetsWithHoles) {
  Geometry tet = test::random_surface(0);
  tet.solid.tets = {{0, 1, 2, 3}};
  Geometry holed = test::random_surface(0);
  add_facet(holed, {{{0, 1, 2, 3}}, {{0, 0, 0}}, 0});
  OutputSet outputs;
  for (const auto write : {write_off, write_obj, write_stl, write_stl_binary}) {
    EXPECT_EQ(write(outputs, "-", tet).error().code, ErrorCode::kUsage);
    EXPECT_EQ(write(outputs, "-", holed).error().code, ErrorCode::kUsage);
  }
}

TEST(SurfaceFiles, SurviveDamage) {
  const Geometry g = test::random_surface(2);
  test::expect_survives_damage(parse_off, written_by(write_off, g));
  test::expect_survives_damage(parse_obj, written_by(write_obj, g));
  test::expect_survives_damage(parse_stl, written_by(write_stl, g));
  test::expect_survives_damage(parse_stl, written_by(write_stl_binary, g));
}

}  // namespace
}  // namespace wellspaced
