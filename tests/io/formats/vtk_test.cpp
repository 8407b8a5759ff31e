#include "wellspaced/io/formats/vtk.hpp"

#include <gtest/gtest.h>

#include "wellspaced/io/text/base64.hpp"
#include "wellspaced/io/text/bytes.hpp"

namespace wellspaced {
namespace {

TriangleMesh sample() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0.5, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.segments = {{0, 1, 7}};
  mesh.point_markers = {1, 2, 3};
  return mesh;
}

std::string vtu(const VtkGrid& grid, VtuEncoding encoding) {
  TextWriter out;
  write_vtu(out, grid, encoding);
  return out.text();
}

template <class T>
std::string block(const std::vector<T>& values) {
  std::string bytes;
  append_bytes(bytes, std::uint64_t{values.size() * sizeof(T)});
  for (const T value : values) append_bytes(bytes, value);
  return bytes;
}

TEST(VtkGrid, HoldsTrianglesThenSegmentsWithTheirMarkers) {
  const VtkGrid grid = vtk_grid(sample());
  EXPECT_EQ(grid.connectivity, (std::vector<std::int64_t>{0, 1, 2, 0, 1}));
  EXPECT_EQ(grid.offsets, (std::vector<std::int64_t>{3, 5}));
  EXPECT_EQ(grid.types, (std::vector<std::uint8_t>{kVtkTriangle, kVtkLine}));
  EXPECT_EQ(std::get<1>(grid.cell_fields[0].values), (std::vector<std::int32_t>{0, 7}));
  EXPECT_EQ(std::get<1>(grid.point_fields[0].values), (std::vector<std::int32_t>{1, 2, 3}));
}

TEST(VtkGrid, ShowsBarePointsAsVertices) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}};
  EXPECT_EQ(vtk_grid(mesh).types, (std::vector<std::uint8_t>{kVtkVertex, kVtkVertex}));
}

TEST(VtkGrid, HoldsTetrahedraAndFacets) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.facets = {{{0, 2, 1}, 4}};
  const VtkGrid grid = vtk_grid(mesh);
  EXPECT_EQ(grid.types, (std::vector<std::uint8_t>{kVtkTetra, kVtkTriangle}));
  EXPECT_EQ(std::get<1>(grid.cell_fields[0].values), (std::vector<std::int32_t>{0, 4}));
}

TEST(WriteVtu, WritesPlainText) {
  EXPECT_EQ(vtu(vtk_grid(sample()), VtuEncoding::kAscii),
            R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="3" NumberOfCells="2">
<Points>
<DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0.5 1 0 
</DataArray>
</Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">
0 1 2 0 1 
</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">
3 5 
</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">
5 3 
</DataArray>
</Cells>
<PointData>
<DataArray type="Int32" Name="marker" format="ascii">
1 2 3 
</DataArray>
</PointData>
<CellData>
<DataArray type="Int32" Name="marker" format="ascii">
0 7 
</DataArray>
</CellData>
</Piece>
</UnstructuredGrid>
</VTKFile>
)");
}

TEST(WriteVtu, EncodesSizeAndDataAsOneBase64Stream) {
  const std::string text = vtu(vtk_grid(sample()), VtuEncoding::kBase64);
  const auto expect_array = [&](const std::string& bytes) {
    std::string array = ">\n";
    array.append(base64(bytes)).append("\n<");
    EXPECT_NE(text.find(array), std::string::npos);
  };
  expect_array(block(std::vector<double>{0, 0, 0, 1, 0, 0, 0.5, 1, 0}));
  expect_array(block(std::vector<std::int64_t>{3, 5}));
}

TEST(WriteVtu, AppendsRawArraysAtTheOffsetsItNames) {
  const VtkGrid grid = vtk_grid(sample());
  const std::string text = vtu(grid, VtuEncoding::kRaw);
  const std::string mark = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t data = text.find(mark) + mark.size();
  const auto expect_block = [&](const std::string& name, const std::string& bytes) {
    const std::size_t at = text.find("offset=\"", text.find("Name=\"" + name + '"')) + 8;
    const std::size_t offset = std::stoul(text.substr(at));
    EXPECT_EQ(text.substr(data + offset, bytes.size()), bytes) << name;
  };
  expect_block("Points", block(std::vector<double>{0, 0, 0, 1, 0, 0, 0.5, 1, 0}));
  expect_block("connectivity", block(grid.connectivity));
  expect_block("offsets", block(grid.offsets));
  expect_block("types", block(grid.types));
  expect_block("marker", block(std::vector<std::int32_t>{1, 2, 3}));
}

TEST(WriteVtu, EscapesNames) {
  VtkGrid grid = vtk_grid(sample());
  grid.point_fields.push_back({"a<b&\"c\"", std::vector<double>{1, 2, 3}});
  EXPECT_NE(vtu(grid, VtuEncoding::kAscii).find("Name=\"a&lt;b&amp;&quot;c&quot;\""),
            std::string::npos);
}

TEST(WriteVtk, WritesTheOldFormat) {
  VtkGrid grid = vtk_grid(sample());
  grid.cell_fields.push_back({"aspect ratio", std::vector<double>{0.5, 0}});
  TextWriter out;
  write_vtk(out, grid);
  EXPECT_EQ(out.text(),
            "# vtk DataFile Version 3.0\nwellspaced\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 3 double\n0 0 0 \n1 0 0 \n0.5 1 0 \n\n"
            "CELLS 2 7\n3 0 1 2 \n2 0 1 \n\nCELL_TYPES 2\n5 \n3 \n\n"
            "POINT_DATA 3\nSCALARS marker int 1\nLOOKUP_TABLE default\n1 \n2 \n3 \n\n\n"
            "CELL_DATA 2\nSCALARS marker int 1\nLOOKUP_TABLE default\n0 \n7 \n\n"
            "SCALARS aspect_ratio double 1\nLOOKUP_TABLE default\n0.5 \n0 \n\n");
}

TEST(WriteVtk, WritesBigEndianBytes) {
  TextWriter out;
  write_vtk(out, vtk_grid(sample()), VtkEncoding::kBinary);
  std::string cells;
  for (const std::int32_t i : {3, 0, 1, 2, 2, 0, 1}) append_bytes(cells, i, std::endian::big);
  EXPECT_NE(out.text().find("\nCELLS 2 7\n" + cells + "\nCELL_TYPES 2\n"), std::string::npos);
  EXPECT_NE(out.text().find("\nBINARY\n"), std::string::npos);
}

TEST(Base64, AgreesWithTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace wellspaced
