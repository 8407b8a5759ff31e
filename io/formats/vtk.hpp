// Unstructured grids for ParaView and its kin: VTU (XML) and legacy VTK files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/io/text/text_source.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A named array of values, one a point or one a cell.
struct VtkField {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>> values;
};

/// Points in space and cells over them. Cell i has the corners
/// connectivity[offsets[i - 1]] .. connectivity[offsets[i] - 1], from 0 for the first.
struct VtkGrid {
  std::vector<Point3> points;
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;  ///< VTK's: kVtkLine, ...
  std::vector<VtkField> point_fields, cell_fields;
  std::string remark;  ///< as in Geometry
};
inline constexpr std::uint8_t kVtkEmpty = 0, kVtkVertex = 1, kVtkPolyVertex = 2, kVtkLine = 3,
                              kVtkPolyLine = 4, kVtkTriangle = 5, kVtkPolygon = 7, kVtkQuad = 9,
                              kVtkTetra = 10;

/// The triangles of `mesh`, then its segments as lines (points with z = 0); a cell field "marker"
/// holds the segments' markers and 0 for triangles, a point field "marker" those of the points.
/// A mesh without cells gets a vertex cell for each point, so that it can be seen.
VtkGrid vtk_grid(const TriangleMesh& mesh);
/// The tetrahedra of `mesh`, then its boundary facets and segments, in the same way.
VtkGrid vtk_grid(const TetMesh& mesh);

/// kBase64 is exact, valid XML and read by everybody; kRaw is smallest, but no XML.
enum class VtuEncoding { kAscii, kBase64, kRaw };

/// Writes version 1.0 with UInt64 headers, little-endian.
/// Requires: every field has as many values as there are points, or cells.
void write_vtu(TextWriter& out, const VtkGrid& grid, VtuEncoding encoding = VtuEncoding::kBase64);

enum class VtkEncoding { kAscii, kBinary };
/// Writes version 3.0, which every reader knows. Blanks in field names become '_'.
void write_vtk(TextWriter& out, const VtkGrid& grid, VtkEncoding encoding = VtkEncoding::kAscii);

// Readers. The point and cell fields "marker" ("gmsh:physical", "medit:ref", "CellEntityIds")
// become markers, "attribute0", "attribute1", ... attributes; others are passed over. Lines are
// segments, polygons facets; vertices are nothing but points. Without tetrahedra and with z = 0
// throughout it is a mesh in the plane. Errors: kUnreadable for malformed files and other cells;
// kInvalidGeometry for an index out of range, NaN and infinity. Nothing is allocated for a count
// that the file is too short to keep.

/// Reads a legacy file: versions up to 5.1, text or binary, UNSTRUCTURED_GRID or POLYDATA.
Result<Geometry> parse_vtk(std::string_view bytes, const TextSource& source);
bool recognise_vtk(std::string_view bytes);

/// Reads a .vtu: text, base64, or appended as base64 or raw bytes; several pieces become one.
Result<Geometry> parse_vtu(std::string_view bytes, const TextSource& source);
bool recognise_vtu(std::string_view bytes);

/// The geometry that a grid from a file describes. Errors: as the readers.
Result<Geometry> geometry_of(const VtkGrid& grid, const std::string& name);

}  // namespace wellspaced
