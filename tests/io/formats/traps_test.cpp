// What files of the wild do that formats do not forbid, and what users of them trip over.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/formats.hpp"
#include "tests/support/grid_meshes.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/gmsh.hpp"
#include "wellspaced/io/formats/medit.hpp"
#include "wellspaced/io/formats/solver_files.hpp"
#include "wellspaced/io/formats/surface_files.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/io/formats/vtk.hpp"

namespace wellspaced {
namespace {

using test::expect_refused;
using test::parsed;
using test::written_by;
using Triangles = std::vector<std::array<Index, 3>>;

const Format& format_called(std::string_view name) {
  for (const Format& format : formats())
    if (format.name == name) return format;
  ADD_FAILURE() << name;
  return formats()[0];
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

Geometry marked_square() {
  Geometry g = to_geometry(test::grid_mesh({.nx = 3, .ny = 3}));
  for (std::size_t s = 0; s < g.mesh.segments.size(); ++s)
    g.mesh.segments[s].marker = static_cast<int>(1 + s % 3);
  return g;
}

void expect_same_file(const Format& format, std::string_view text, std::string_view original) {
  EXPECT_TRUE(format.recognise == nullptr || format.recognise(text)) << format.name;
  const Geometry g = parsed(format.parse, text), expected = parsed(format.parse, original);
  EXPECT_EQ(g.dimension, expected.dimension);
  EXPECT_EQ(g.mesh.points, expected.mesh.points);
  EXPECT_EQ(g.mesh.triangles, expected.mesh.triangles);
  EXPECT_EQ(g.mesh.segments, expected.mesh.segments);
  EXPECT_EQ(g.mesh.point_markers, expected.mesh.point_markers);
  EXPECT_EQ(g.solid.points, expected.solid.points);
  EXPECT_EQ(g.marker_names, expected.marker_names);
}

TEST(TextFiles, MayHaveTheLineEndsOfWindowsAByteOrderMarkAndNoLastNewline) {
  for (const char* name :
       {"gmsh", "gmsh22", "vtu-ascii", "vtk", "medit", "mfem", "su2", "off", "stl", "obj"}) {
    SCOPED_TRACE(name);
    const Format& format = format_called(name);
    const std::string text = written_by(format.write, marked_square());
    ASSERT_EQ(text.back(), '\n');
    expect_same_file(format, replaced(text, "\n", "\r\n"), text);
    expect_same_file(format, replaced(text, "\n", " \t\n"), text);
    if (format.name != "vtk") expect_same_file(format, "\xEF\xBB\xBF" + text, text);
    expect_same_file(format, text.substr(0, text.size() - 1), text);
  }
}

TEST(TextFiles, MaySeparateNumbersByTabs) {
  for (const char* name : {"gmsh", "gmsh22", "medit", "mfem", "su2", "off", "stl", "obj"}) {
    SCOPED_TRACE(name);
    const Format& format = format_called(name);
    const std::string text = written_by(format.write, marked_square());
    const std::size_t body = text.find('\n') + 1;
    expect_same_file(format, text.substr(0, body) + replaced(text.substr(body), " ", "\t"), text);
  }
}

TEST(TextFiles, MayWriteNumbersAsFortranDoes) {
  EXPECT_EQ(parsed(parse_su2, "NDIME= 2\nNELEM= 0\nNPOIN= 1\n1.5D+00 -2.D-1\n").mesh.points,
            (std::vector<Point2>{{1.5, -0.2}}));
  EXPECT_EQ(parsed(parse_fort14, "t\n1 3\n1 0 0 1.0d+01\n2 1 0 1\n3 0 1 1\n1 3 1 2 3\n0\n0\n0\n0\n")
                .point_attributes.values[0],
            10);
}

// ---- Gmsh

TEST(GmshFiles, MayHaveElementsWithoutTags) {
  const Geometry g = parsed(parse_gmsh,
                            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n"
                            "3 0 1 0\n$EndNodes\n$Elements\n2\n1 2 0 1 2 3\n2 1 1 4 1 2\n"
                            "$EndElements\n");
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 4}})) << "a lone tag is the physical one";
}

TEST(GmshFiles, MayHaveNoPhysicalGroupsAtAll) {
  const Geometry g = parsed(parse_gmsh,
                            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n"
                            "3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 "
                            "3\n$EndElements\n");
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_TRUE(g.cell_attributes.values.empty());
}

// ---- VTK

std::string vtu_of_arrays(const std::string& root, const std::string& points,
                          const std::string& end = "") {
  return "<VTKFile type=\"UnstructuredGrid\" " + root +
         "><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points>" + points +
         "</Points><Cells><DataArray type=\"UInt64\" Name=\"connectivity\" format=\"ascii\">0 1 2"
         "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
         "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells></Piece>"
         "</UnstructuredGrid>" +
         end + "</VTKFile>";
}

// Nine bytes 0 0 0 1 0 0 0 1 0 behind their number, of 32 or 64 bits, in either order of bytes.
TEST(VtuFiles, CountBytesWithTheWordsThatTheyName) {
  const std::string array = "<DataArray type=\"Int8\" NumberOfComponents=\"3\" format=\"binary\">";
  const std::vector<Point2> expected = {{0, 0}, {1, 0}, {0, 1}};
  const auto points = [&](const std::string& root, const std::string& data) {
    return parsed(parse_vtu, vtu_of_arrays(root, array + data + "</DataArray>")).mesh.points;
  };
  EXPECT_EQ(points("", "CQAAAAAAAAEAAAABAA=="), expected) << "32 bits where nothing is said";
  EXPECT_EQ(points("byte_order=\"BigEndian\"", "AAAACQAAAAEAAAABAA=="), expected);
  EXPECT_EQ(points("header_type=\"UInt64\"", "CQAAAAAAAAAAAAABAAAAAQA="), expected);
}

TEST(VtuFiles, MayAppendTheirDataInBase64) {
  const std::string array =
      "<DataArray type=\"Int8\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>";
  const std::string end =
      "<AppendedData encoding=\"base64\">\n _CQAAAAAAAAEAAAABAA==</AppendedData>";
  EXPECT_EQ(parsed(parse_vtu, vtu_of_arrays("", array, end)).mesh.points,
            (std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(VtkFiles, MayHaveNamesOfEncodedBlanksAndTitlesOfAnyKind) {
  const Geometry g = parsed(
      parse_vtk,
      "# vtk DataFile Version 2.0\n" + std::string(300, 't') +
          "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0\n0 1 0\nCELLS 1 4\n3 0 "
          "1 "
          "2\nCELL_TYPES 1\n5\nPOINT_DATA 3\nSCALARS a%20name double 1\nLOOKUP_TABLE default\n1 2 "
          "3\n");
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
}

// ---- Medit

TEST(MeditFiles, OfAllVersionsAreRead) {
  for (const char* version : {"1", "2", "3", "4"})
    EXPECT_EQ(
        parsed(parse_medit, std::string("MeshVersionFormatted ") + version +
                                "\nDimension\n2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\n"
                                "Triangles\n1\n1 2 3 0\nNormals\n1\n0 1\nNormalAtVertices\n1\n"
                                "1 1\nRidges\n1\n1\nEnd\n")
            .mesh.triangles,
        (Triangles{{0, 1, 2}}));
}

TEST(MeditFiles, OfBinaryKindAreRefusedByName) {
  const std::string binary("\1\0\0\0\2\0\0\0", 8);
  EXPECT_FALSE(recognise_medit(binary));
  expect_refused(parse_medit, binary, "MeshVersionFormatted should stand first");
}

// ---- SU2, MFEM, fort.14

TEST(Su2Files, MayHaveSectionsInAnyOrderAndThoseOfDividedMeshes) {
  const Geometry g = parsed(parse_su2,
                            "NDIME = 2\nNMARK = 2\nMARKER_TAG = far\nMARKER_ELEMS = 1\n3 0 1\n"
                            "MARKER_TAG= SEND_RECEIVE\nMARKER_ELEMS= 2\nSEND_TO= 1\n1 0\n1 2 0\n"
                            "NPOIN =3\n0 0\n1 0\n0 1\nNELEM= 1\n5 0 1 2\nFFD_NBOX= 1\n"
                            "FFD_TAG= box\n");
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 1}}));
}

TEST(MfemFiles, HaveNoAttributesBelowOne) {
  Geometry g = marked_square();
  for (Segment& s : g.mesh.segments) s.marker = 0;
  const std::string text = written_by(write_mfem, g);
  const std::size_t boundary = text.find("boundary\n");
  ASSERT_NE(boundary, text.npos);
  EXPECT_EQ(text.find("\n0 ", text.find("elements\n")), text.npos) << text;
}

TEST(Fort14Files, MayHaveBoundariesOfEveryWidth) {
  const std::string head = "t\n1 3\n1 0 0 1\n2 1 0 1\n3 0 1 1\n1 3 1 2 3\n0\n0\n1\n2\n";
  for (const char* strings :
       {"2 3\n1 0.5 1\n2 0.5 1\n", "2 13\n1 0.5 1\n2 0.5 1\n", "2 4\n1 3 1 1 1\n2 3 1 1 1\n",
        "2 5\n1 3 1 1 1 1 1 1\n2 3 1 1 1 1 1 1\n",
        "2 25 = pipes\n1 3 1 1 1 1 1 1\n2 3 1 1 1 1 1 1\n"})
    EXPECT_EQ(parsed(parse_fort14, head + strings).mesh.segments[0].b, 1u) << strings;
}

// ---- OFF, OBJ, STL

TEST(OffFiles, OfFourDimensionsAndBinaryOnesAreRefused) {
  expect_refused(parse_off, "4OFF\n1 0 0\n0 0 0 1\n", "x");
  expect_refused(parse_off, std::string("OFF BINARY\n\0\0\0\1", 15), "x");
}

TEST(ObjFiles, MayHaveWeightsAndColoursBehindCoordinates) {
  const Geometry g = parsed(parse_obj, "v 0 0 1 0.5\nv 1 0 1 1 0 0\nv 0 1 1\nf 1 2 3\n");
  EXPECT_EQ(g.solid.points, (std::vector<Point3>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}));
}

TEST(StlFiles, HaveOneCornerWhereZerosDifferInTheirSign) {
  const Geometry g = parsed(parse_stl,
                            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 1 0 1\n"
                            "vertex 0 1 1\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
                            "vertex -0 -0 1\nvertex 0 1 1\nvertex -1 0 1\nendloop\nendfacet\n"
                            "endsolid\n");
  EXPECT_EQ(g.solid.points.size(), 4u);
  expect_refused(parse_stl,
                 "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 1\nvertex 1 0 1\n"
                 "vertex 0 1 1\nendloop\nendfacet\nendsolid\n",
                 "nan");
}

// ---- Triangle, TetGen

TEST(TriangleFiles, WithSixNodesATriangleAreRefused) {
  Geometry points = parsed(parse_node, "6 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 0\n");
  const Status refused = parse_ele("1 6 0\n1 1 2 3 4 5 6\n", "x", points);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("6"), std::string::npos) << refused.error().message;
}

}  // namespace
}  // namespace wellspaced
