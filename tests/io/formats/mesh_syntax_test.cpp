// The syntax of each mesh format: what files in the wild look like, and what is refused.
#include <gtest/gtest.h>

#include "tests/support/formats.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/gmsh.hpp"
#include "wellspaced/io/formats/medit.hpp"
#include "wellspaced/io/formats/metis.hpp"
#include "wellspaced/io/formats/solver_files.hpp"
#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/text/base64.hpp"
#include "wellspaced/io/text/inflate.hpp"

namespace wellspaced {
namespace {

using test::expect_refused;
using test::parsed;
using test::TemporaryDirectory;
using Triangles = std::vector<std::array<Index, 3>>;

// ---- Medit ---------------------------------------------------------------------------------

constexpr const char* kMedit =
    "MeshVersionFormatted\n2\n# c\nDimension\n2 Vertices 3\n0 0 7\n1 0 0\n0 1 0\nTriangles 1\n1 2 "
    "3 5\nRequiredEdges 1 1\nEdges\n1\n1 2 9\nCorners\n2\n1\n2\nEnd\n";

TEST(ParseMedit, DoesNotMindLines) {
  const Geometry g = parsed(parse_medit, kMedit);
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 9}}));
  EXPECT_EQ(g.mesh.point_markers, (std::vector<int>{7, 0, 0}));
  EXPECT_EQ(cell_markers(g), (std::vector<int>{5}));
  EXPECT_TRUE(g.notes.empty());
}

TEST(ParseMedit, TakesFlatFilesOfDimensionThreeAsPlanar) {
  EXPECT_EQ(parsed(parse_medit,
                   "MeshVersionFormatted 1\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                   "Triangles 1\n1 2 3 0\nEnd")
                .dimension,
            2);
}

TEST(ParseMedit, NotesKeywordsThatItDoesNotKnow) {
  const Geometry g = parsed(parse_medit,
                            "MeshVersionFormatted 2 Dimension 2 Vertices 1 0 0 0\nSurprise 2\n1.5 "
                            "2\nIdentifier\n\"a name\"\nEnd");
  EXPECT_EQ(g.mesh.points.size(), 1u);
  ASSERT_GE(g.notes.size(), 1u);
  EXPECT_EQ(g.notes[0], "x: 'Surprise' was passed over");
}

TEST(ParseMedit, RefusesWhatItCannotRead) {
  expect_refused(parse_medit, "Vertices 1\n0 0 0", "MeshVersionFormatted should stand first");
  expect_refused(parse_medit, "MeshVersionFormatted 9\n", "version 9");
  expect_refused(parse_medit, "MeshVersionFormatted 2\nDimension 4\n", "x:2: the dimension");
  expect_refused(parse_medit, "MeshVersionFormatted 2\nDimension 2\nVertices 90000000\n0 0 0\n",
                 "x:3: the file is too short for the 90000000 vertices");
  expect_refused(parse_medit,
                 "MeshVersionFormatted 2\nDimension 2\nVertices 1\n0 0 0\nEdges 1\n1 2 0\n",
                 "x:6: point 2 is not among");
  expect_refused(parse_medit, "MeshVersionFormatted 2\nDimension 2\nVertices 1\n0 inf 0\nEnd\n",
                 "x:4: the y");
  expect_refused(parse_medit,
                 "MeshVersionFormatted 2\nDimension 3\nHexahedra 1\n1 1 1 1 1 1 1 1 0\n",
                 "Hexahedra are not understood");
  expect_refused(parse_medit, "MeshVersionFormatted 2\n12 13\n", "where a keyword should stand");
}

// ---- Gmsh ----------------------------------------------------------------------------------

constexpr const char* kGmsh22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 3 \"the wall\"\n"
    "$EndPhysicalNames\n$Nodes\n3\n10 0 0 0\n7 1 0 0\n99 0 1 0\n$EndNodes\n$Elements\n4\n"
    "1 15 2 8 1 7\n2 1 2 3 1 10 7\n3 2 2 5 1 10 7 99\n4 2 2 6 1 10 7 99\n$EndElements\n"
    "$Periodic\nanything at all\n$EndPeriodic\n";

TEST(ParseGmsh, ReadsSparseNumbersGroupsAndNames) {
  const Geometry g = parsed(parse_gmsh, kGmsh22);
  EXPECT_EQ(g.mesh.points, (std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}})) << "listed once for each group";
  EXPECT_EQ(cell_markers(g), (std::vector<int>{5}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 3}}));
  EXPECT_EQ(g.mesh.point_markers, (std::vector<int>{0, 8, 0}));
  EXPECT_EQ(g.marker_names, (std::vector<MarkerName>{{1, 3, "the wall"}}));
  EXPECT_EQ(g.notes.size(), 1u);
}

constexpr const char* kGmsh41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 1 0\n1 0 0 0 0\n"
    "4 0 0 0 1 0 0 1 3 2 1 -1\n6 0 0 0 1 1 0 2 5 -6 1 4\n$EndEntities\n$Nodes\n2 3 1 30\n"
    "1 4 1 1\n30\n0 0 0 0.5\n2 6 0 2\n2\n1\n1 0 0\n0 1 0\n$EndNodes\n$Elements\n2 2 1 2\n"
    "1 4 1 1\n1 30 2\n2 6 2 1\n2 30 2 1\n$EndElements\n";

TEST(ParseGmsh, ReadsEntitiesWithSeveralGroupsAndParametricNodes) {
  const Geometry g = parsed(parse_gmsh, kGmsh41);
  EXPECT_EQ(g.mesh.points, (std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 3}}));
  EXPECT_EQ(cell_markers(g), (std::vector<int>{5})) << "the first group counts";
}

TEST(ParseGmsh, RefusesWhatItCannotRead) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  expect_refused(parse_gmsh, "$MeshFormat\n4 0 8\n$EndMeshFormat\n", "version '4'");
  expect_refused(parse_gmsh, "$MeshFormat\n4.1 0 4\n$EndMeshFormat\n", "data size");
  expect_refused(parse_gmsh, "$MeshFormat\n4.1 1 8\n\x01", "the file ends within");
  expect_refused(parse_gmsh, "$Nodes\n", "$MeshFormat should stand first");
  expect_refused(parse_gmsh, head + "$Nodes\n80000000\n1 0 0 0\n", "too short");
  expect_refused(parse_gmsh, head + "$Nodes\n1\n1 0 0 0\n", "the file ends before '$EndNodes'");
  expect_refused(parse_gmsh, head + "$Nodes\n2\n1 0 0 0\n1 0 0 0\n$EndNodes\n", "occurs twice");
  expect_refused(parse_gmsh, head + "$Nodes\n1\n1 0 0 nan\n$EndNodes\n", "x:6: the z coordinate");
  expect_refused(parse_gmsh, head + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 2 0 1 1 2\n",
                 "x:10: node 2 does not exist");
  expect_refused(parse_gmsh,
                 head + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 9 0 1 1 1 1 1 1",
                 "x:10: elements of type 9");
  expect_refused(parse_gmsh, head + "(0 \"Fluent\")\n", "where a section should begin");
}

// ---- VTK -----------------------------------------------------------------------------------

constexpr const char* kOldVtk =
    "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 "
    "0 1 0\nCELLS 2 7\n3 0 1 2 2 0 1\nCELL_TYPES 2\n5 3\nCELL_DATA 2\nSCALARS marker int\n"
    "LOOKUP_TABLE default\n0 7\nPOINT_DATA 3\nVECTORS v double\n1 2 3 4 5 6 7 8 9\nMETADATA\n"
    "INFORMATION 0\n\nFIELD f 2\na 2 3 float\n1 2 3 4 5 6\nmarker 1 3 int\n4 5 6\n";
constexpr const char* kNewVtk =
    "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 "
    "0 0 0 1 0\nMETADATA\nINFORMATION 0\n\nCELLS 3 5\nOFFSETS vtktypeint64\n0 3 5\nCONNECTIVITY "
    "vtktypeint64\n0 1 2 0 1\nCELL_TYPES 2\n5\n3\n";

TEST(ParseVtk, ReadsOldAndNewCellsAndFields) {
  const Geometry old_one = parsed(parse_vtk, kOldVtk);
  EXPECT_EQ(old_one.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(old_one.mesh.segments, (std::vector<Segment>{{0, 1, 7}}));
  EXPECT_EQ(old_one.mesh.point_markers, (std::vector<int>{4, 5, 6}));
  const Geometry new_one = parsed(parse_vtk, kNewVtk);
  EXPECT_EQ(new_one.mesh.points, old_one.mesh.points);
  EXPECT_EQ(new_one.mesh.triangles, old_one.mesh.triangles);
  EXPECT_EQ(new_one.mesh.segments, (std::vector<Segment>{{0, 1, 0}}));
}

TEST(ParseVtk, ReadsPolydata) {
  const Geometry g = parsed(parse_vtk,
                            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 "
                            "double\n0 0 0 1 0 0 1 1 1 0 1 0\nPOLYGONS 2 9\n3 0 1 2\n4 0 1 2 3\n"
                            "LINES 1 4\n3 0 1 2\n");
  EXPECT_EQ(g.polygons.size(), 2u);
  EXPECT_EQ(g.solid.segments.size(), 2u);
}

TEST(ParseVtk, RefusesWhatItCannotRead) {
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const std::string points = head + "POINTS 1 double\n0 0 0\n";
  expect_refused(parse_vtk, "# vtk", "should stand first");
  expect_refused(parse_vtk, "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
                 "STRUCTURED_POINTS");
  expect_refused(parse_vtk, head + "POINTS 50000000 double\n0 0 0\n", "x:5: the file is too short");
  expect_refused(parse_vtk, head + "POINTS 1 quad\n0 0 0\n", "'quad'");
  expect_refused(parse_vtk, head + "POINTS 1 double\n0 nan 0\n", "point 0 (counted from 0)");
  expect_refused(parse_vtk, points + "CELLS 1 2\n1 1\nCELL_TYPES 1\n1\n", "point 1 is not among");
  expect_refused(parse_vtk, points + "CELLS 1 3\n9 0 0\nCELL_TYPES 1\n1\n", "is incomplete");
  expect_refused(parse_vtk, points + "CELLS 1 2\n1 0\n", "types of cells");
  expect_refused(parse_vtk, points + "CELLS 1 7\n6 0 0 0 0 0 0\nCELL_TYPES 1\n13\n", "type 13");
  expect_refused(parse_vtk, points + "NONSENSE 1\n", "'NONSENSE'");
}

std::string vtu_with(const std::string& root, const std::string& points) {
  return "<?xml version=\"1.0\"?><!-- > -->\n<VTKFile type=\"UnstructuredGrid\" " + root +
         ">\n<UnstructuredGrid><Piece NumberOfPoints='3' NumberOfCells=\"1\">\n<Points>" + points +
         "</Points>\n<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 "
         "2</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray>\n"
         "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells>\n"
         "</Piece></UnstructuredGrid>";
}

TEST(ParseVtu, ReadsZlibBlocks) {
  // Nine 32-bit floats, 0 0 0 1 0 0 0 1 0, packed by Python's zlib.
  const std::string packed = "AQAAAACAAAAkAAAAEAAAAA==eJxjYEAGDfYMWPgAFIoBfw==";
  const Geometry g =
      parsed(parse_vtu, vtu_with("compressor=\"vtkZLibDataCompressor\" header_type=\"UInt32\"",
                                 "<DataArray type=\"Float32\" NumberOfComponents=\"3\" "
                                 "format=\"binary\">\n  " +
                                     packed + "\n</DataArray>") +
                            "</VTKFile>");
  EXPECT_EQ(g.mesh.points, (std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(ParseVtu, RefusesWhatItCannotRead) {
  const std::string array = "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"";
  expect_refused(parse_vtu, "<a></a>", "the tag VTKFile is missing");
  expect_refused(parse_vtu, "<VTKFile type=\"PolyData\">", "x:1: only VTK files of type");
  expect_refused(parse_vtu, "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkLZ4\"/>", "vtkLZ4");
  expect_refused(parse_vtu, vtu_with("", array + "ascii\">0 0 0 1 0 0 0 1</DataArray>"),
                 "x:4: the array '' is too short");
  expect_refused(parse_vtu, vtu_with("", array + "binary\">AAAA</DataArray>"), "cannot be decoded");
  expect_refused(parse_vtu, vtu_with("", array + "binary\">/////w==</DataArray>"), "cannot be");
  expect_refused(
      parse_vtu,
      vtu_with("", array + "appended\" offset=\"9\"/>") + "<AppendedData encoding=\"raw\">_abc",
      "begins after the end");
  expect_refused(parse_vtu, vtu_with("", ""), "the points of a piece are missing");
  expect_refused(parse_vtu, "<VTKFile type=\"UnstructuredGrid\"><Piece NumberOfPoints=\"-1\"/>",
                 "makes no sense");
}

TEST(Inflate, ReadsEveryKindOfBlock) {
  const auto text = [](const char* packed, std::size_t size) {
    return inflate(*decode_base64(packed), size).value_or("refused");
  };
  EXPECT_EQ(text("eAEBAwD8/2FiYwJNASc=", 3), "abc") << "stored";
  EXPECT_EQ(text("eNpLTEpOTAIABb8B6g==", 5), "abcab") << "fixed codes";
  EXPECT_EQ(text("eNpLTEpOTAIABb8B6g==", 4), "refused") << "another size";
  EXPECT_EQ(text("eNpLTEpOTAIABb8B6w==", 5), "refused") << "another checksum";
  EXPECT_EQ(text("eNpLTEpOTAIABb8B6g==", std::size_t{1} << 40), "refused") << "allocates nothing";
}

// ---- SU2, MFEM, fort.14 --------------------------------------------------------------------

constexpr const char* kSu2 =
    "% c\nNDIME = 2\nNELEM=1\n5 0 1 2 0\nNPOIN= 3 3\n0 0 0\n1 0 1\n0 1 2\nNMARK= 2\nMARKER_TAG= "
    "wall side\nMARKER_ELEMS= 1\n3 0 1\nMARKER_TAG=7\nMARKER_ELEMS=2\n3 1 2 0\n3 2 0 1\n";

TEST(ParseSu2, ReadsSectionsAndNamesOfBoundaries) {
  const Geometry g = parsed(parse_su2, kSu2);
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 1}, {1, 2, 7}, {2, 0, 7}}));
  EXPECT_EQ(g.marker_names, (std::vector<MarkerName>{{1, 1, "wall side"}}));
}

TEST(ParseSu2, RefusesWhatItCannotRead) {
  expect_refused(parse_su2, "NPOIN= 1\n0 0\n", "NDIME must come before NPOIN");
  expect_refused(parse_su2, "NZONE= 2\n", "several zones");
  expect_refused(parse_su2, "NDIME= 2\nNELEM= 1\n9 0 1 2 3\n", "x:3: elements of type 9");
  expect_refused(parse_su2, "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 2\n0 0\n1 0\n",
                 "x:3: point 2 is not among");
  expect_refused(parse_su2, "NDIME= 2\nNPOIN= 70000000\n0 0\n", "x:2: the file is too short");
  expect_refused(parse_su2, "NELEM= 0\n", "NDIME is missing");
}

constexpr const char* kMfem =
    "MFEM mesh v1.0\n\n# c\ndimension\n2\n\nelements\n1\n4 2 0 1 2\n\nboundary\n1\n6 1 1 0\n\n"
    "vertices\n3\n2\n0 0\n1 0\n0 1\n";

TEST(ParseMfem, ReadsElementsThatComeBeforeTheirVertices) {
  const Geometry g = parsed(parse_mfem, kMfem);
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(cell_markers(g), (std::vector<int>{4}));
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{1, 0, 6}}));
}

TEST(ParseMfem, RefusesWhatItCannotRead) {
  expect_refused(parse_mfem, "MFEM mesh v1.3\n", "MFEM mesh v1.0 should stand");
  expect_refused(parse_mfem, "MFEM mesh v1.0\nvertices\n1\nnodes\nFiniteElementSpace\n", "curved");
  expect_refused(parse_mfem, "MFEM mesh v1.0\nelements\n1\n1 3 0 1 2 3\nvertices\n4\n2\n",
                 "type 3");
  expect_refused(parse_mfem, "MFEM mesh v1.0\nelements\n1\n1 2 0 1 2\nvertices\n1\n2\n0 0\n",
                 "x:4: point 1 is not among");
  expect_refused(parse_mfem, "MFEM mesh v1.0\nelements\n500000\n1 2 0 1 2\n", "too short");
}

constexpr const char* kFort14 =
    "a title # 1\n2 4 ! elements, nodes\n1 1000 0 10.5\n2 1100 0 10\n3 1100 95 9\n4 1000 95 -1\n"
    "1 3 1 2 3\n2 3 1 3 4\n1 = open boundaries\n2 = nodes\n2 = nodes of 1\n1\n2\n2 = land\n6\n"
    "3 0 = nodes, type\n2\n3\n4\n2 24 = weir\n1 4 0.5 1 1\n2 3 0.5 1 1\n";

TEST(ParseFort14, ReadsDepthsAndBoundaries) {
  const Geometry g = parsed(parse_fort14, kFort14);
  EXPECT_EQ(g.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(g.point_attributes.values, (std::vector<double>{10.5, 10, 9, -1}));
  EXPECT_EQ(g.mesh.segments,
            (std::vector<Segment>{{0, 1, 1}, {1, 2, 2}, {2, 3, 2}, {0, 1, 26}, {3, 2, 26}}));
  EXPECT_EQ(g.marker_names,
            (std::vector<MarkerName>{{1, 1, "open"}, {1, 2, "land 0"}, {1, 26, "land 24"}}));
  ASSERT_EQ(g.notes.size(), 1u);
  EXPECT_NE(g.notes[0].find("come in pairs"), std::string::npos) << g.notes[0];
  EXPECT_TRUE(recognise_fort14(kFort14));
}

TEST(ParseFort14, ClosesIslands) {
  const Geometry g = parsed(
      parse_fort14, "t\n1 3\n1 0 0 1\n2 1 0 1\n3 0 1 1\n1 3 1 2 3\n0\n0\n1\n3\n3 1\n1\n2\n3\n");
  EXPECT_EQ(g.mesh.segments, (std::vector<Segment>{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  ASSERT_EQ(g.notes.size(), 1u) << "these might be degrees";
}

TEST(ParseFort14, RefusesWhatItCannotRead) {
  expect_refused(parse_fort14, "t\n", "the number of elements and nodes");
  expect_refused(parse_fort14, "t\n0 90000\n1 0 0 1\n", "x:2: the file is too short");
  expect_refused(parse_fort14, "t\n0 1\n2 0 0 1\n", "x:3: node number 2 where 1 should follow");
  expect_refused(parse_fort14, "t\n1 1\n1 0 0 1\n1 4 1 1 1 1\n", "no triangle");
  expect_refused(parse_fort14, "t\n1 1\n1 0 0 1\n1 3 1 1 2\n", "x:4: point 2 is not among");
}

// ---- METIS ---------------------------------------------------------------------------------

TEST(ParseMetis, TakesEmptyLinesForIsolatedVertices) {
  const auto plain = parse_metis_graph("4 2\n2 3\n1\n\xEF", "x");
  ASSERT_FALSE(plain.ok());
  const auto good = parse_metis_graph("% c\n4 2\n2 3\n% c\n1\n1\n\n", "x");
  ASSERT_TRUE(good.ok()) << good.error().message;
  EXPECT_EQ(good->edges, (std::vector<Segment>{{0, 1, 0}, {0, 2, 0}}));
  EXPECT_EQ(good->vertices, 4u);
}

TEST(ParseMetis, PassesOverWeights) {
  const auto graph = parse_metis_graph("2 1 111 2\n9 5 6 2 1\n9 7 8 1 1\n", "x");
  ASSERT_TRUE(graph.ok()) << graph.error().message;
  EXPECT_EQ(graph->edges, (std::vector<Segment>{{0, 1, 0}}));
}

TEST(ParseMetis, RefusesWhatIsNoGraph) {
  const auto message = [](std::string_view text) {
    const auto graph = parse_metis_graph(text, "x");
    return graph.ok() ? std::string("accepted") : graph.error().message;
  };
  EXPECT_NE(message("2 1\n1\n1\n").find("x:2: vertex 1 joins itself"), std::string::npos);
  EXPECT_NE(message("2 1\n2 2\n1\n").find("edge 1-2 is listed twice"), std::string::npos);
  EXPECT_NE(message("2 1\n2\n\n").find("edge 1-2 has no edge back"), std::string::npos);
  EXPECT_NE(message("2 0\n2\n1\n").find("1 edges, not 0"), std::string::npos);
  EXPECT_NE(message("2 1\n3\n1\n").find("point 3 is not among"), std::string::npos);
  EXPECT_NE(message("3 1\n2\n1\n").find("ends before its 3 vertices"), std::string::npos);
  EXPECT_NE(message("1 0\n\n2\n").find("more lines follow"), std::string::npos);
  EXPECT_NE(message("1 0 7\n\n").find("format 7"), std::string::npos);
}

TEST(ReadMetis, FindsCoordinatesBesideTheGraph) {
  const TemporaryDirectory directory;
  directory.write("a.graph", "2 1\n2\n1\n");
  EXPECT_FALSE(read_geometry(directory / "a.graph").ok());
  directory.write("a.coords", "0 0\n1 0\n");
  const auto g = read_geometry(directory / "a.graph");
  ASSERT_TRUE(g.ok()) << g.error().message;
  EXPECT_EQ(g->mesh.segments.size(), 1u);
  directory.write("a.coords", "0 0\n");
  EXPECT_FALSE(read_geometry(directory / "a.graph").ok()) << "a point is missing";
}

}  // namespace
}  // namespace wellspaced
