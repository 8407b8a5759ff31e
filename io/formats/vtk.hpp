// Unstructured grids for ParaView and its kin: VTU (XML) and legacy VTK files.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

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
};
inline constexpr std::uint8_t kVtkVertex = 1, kVtkLine = 3, kVtkTriangle = 5, kVtkPolygon = 7,
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

}  // namespace wellspaced
