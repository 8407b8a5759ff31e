#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// One conversion. Marks of cells wait until the geometry knows its dimension.
class GridReader {
 public:
  GridReader(const VtkGrid& grid, const std::string& name) : grid_(grid), name_(name) {}

  Result<Geometry> read();

 private:
  Status read_cells();
  Status add_cell(std::uint8_t type, std::span<const Index> corners, int marker);
  void read_fields();

  const VtkGrid& grid_;
  const std::string& name_;
  Geometry geometry_;
  std::vector<std::size_t> facets_, tets_;  // their numbers among the cells of the grid
  std::vector<int> tet_markers_;
};

const VtkField* find_field(const std::vector<VtkField>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const VtkField& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

// What programs call the markers that they write.
const VtkField* find_markers(const std::vector<VtkField>& fields) {
  for (const char* name : {"marker", "gmsh:physical", "medit:ref", "CellEntityIds"})
    if (const VtkField* field = find_field(fields, name)) return field;
  return nullptr;
}

int int_of(double value) {
  const bool fits = value >= std::numeric_limits<int>::min() &&
                    value <= std::numeric_limits<int>::max() && value == std::floor(value);
  return fits ? static_cast<int>(value) : 0;
}

double value_at(const VtkField& field, std::size_t i) {
  return std::visit([i](const auto& values) { return static_cast<double>(values[i]); },
                    field.values);
}

std::vector<int> markers_of(const VtkField* field, std::size_t count) {
  std::vector<int> markers(count, 0);
  for (std::size_t i = 0; field != nullptr && i < count; ++i)
    markers[i] = int_of(value_at(*field, i));
  return markers;
}

// The fields "attribute0", "attribute1", ... of the items listed in `which`.
Attributes read_attributes(const std::vector<VtkField>& fields,
                           const std::vector<std::size_t>& which) {
  std::vector<const VtkField*> columns;
  while (const VtkField* field = find_field(fields, concat({"attribute", columns.size()})))
    columns.push_back(field);
  Attributes attributes;
  attributes.columns = static_cast<Index>(columns.size());
  for (const std::size_t i : which)
    for (const VtkField* field : columns) attributes.values.push_back(value_at(*field, i));
  return attributes;
}

Status GridReader::add_cell(std::uint8_t type, std::span<const Index> corners, int marker) {
  TetMesh& solid = geometry_.solid;
  const std::size_t n = corners.size();
  if (type == kVtkVertex || type == kVtkPolyVertex || type == kVtkEmpty) return Ok{};
  if (type == kVtkLine && n == 2) {
    solid.segments.push_back({corners[0], corners[1], marker});
  } else if (type == kVtkPolyLine) {
    for (std::size_t i = 1; i < n; ++i)
      solid.segments.push_back({corners[i - 1], corners[i], marker});
  } else if (n >= 3 && ((type == kVtkTriangle && n == 3) || type == kVtkPolygon ||
                        (type == kVtkQuad && n == 4))) {
    add_facet(geometry_, {{{corners.begin(), corners.end()}}, {}, marker});
  } else if (type == kVtkTetra && n == 4) {
    solid.tets.push_back({corners[0], corners[1], corners[2], corners[3]});
  } else {
    return Error{ErrorCode::kUnreadable,
                 {name_, ": cells of VTK type ", type, " with ", n,
                  " corners are not understood, only lines, polygons and tetrahedra"}};
  }
  return Ok{};
}

Status GridReader::read_cells() {
  const std::vector<int> markers = markers_of(find_markers(grid_.cell_fields), grid_.types.size());
  std::vector<Index> corners;
  std::int64_t begin = 0;
  for (std::size_t cell = 0; cell < grid_.types.size(); ++cell) {
    corners.clear();
    for (; begin < grid_.offsets[cell]; ++begin)
      corners.push_back(static_cast<Index>(grid_.connectivity[static_cast<std::size_t>(begin)]));
    const std::uint8_t type = grid_.types[cell];
    if (Status status = add_cell(type, corners, markers[cell]); !status) return status;
    if (type == kVtkTetra) tets_.push_back(cell), tet_markers_.push_back(markers[cell]);
    if (type == kVtkTriangle || type == kVtkPolygon) facets_.push_back(cell);
  }
  return Ok{};
}

void GridReader::read_fields() {
  const std::size_t points = grid_.points.size();
  geometry_.solid.point_markers =
      without_zeros(markers_of(find_markers(grid_.point_fields), points));
  std::vector<std::size_t> all(points);
  for (std::size_t i = 0; i < points; ++i) all[i] = i;
  geometry_.point_attributes = read_attributes(grid_.point_fields, all);
  set_cell_markers(geometry_, tet_markers_);
  lay_in_plane(geometry_);
  Attributes attributes =
      read_attributes(grid_.cell_fields, geometry_.dimension == 2 ? facets_ : tets_);
  if (attributes.columns > 0) geometry_.cell_attributes = std::move(attributes);
}

Result<Geometry> GridReader::read() {
  geometry_.dimension = 3;
  geometry_.solid.points = grid_.points;
  if (Status status = read_cells(); !status) return status.error();
  read_fields();
  return std::move(geometry_);
}

Error wrong_grid(const std::string& name, const std::string& what) {
  return {ErrorCode::kInvalidGeometry, {name, ": ", what}};
}

Status check_grid(const VtkGrid& grid, const std::string& name) {
  const auto points = static_cast<std::int64_t>(grid.points.size());
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const Point3& p = grid.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return wrong_grid(name, concat({"point ", i, " (counted from 0) is not finite"}));
  }
  if (grid.points.size() >= kNoIndex)
    return Error{ErrorCode::kLimit, {name, ": more than 4294967294 points"}};
  if (grid.offsets.size() != grid.types.size())
    return wrong_grid(name, concat({"there are ", grid.offsets.size(), " offsets for ",
                                    grid.types.size(), " types of cells"}));
  std::int64_t begin = 0;
  for (const std::int64_t end : grid.offsets) {
    if (end < begin) return wrong_grid(name, "the offsets of cells do not ascend");
    begin = end;
  }
  if (begin != static_cast<std::int64_t>(grid.connectivity.size()))
    return wrong_grid(name, "the offsets of cells do not end with their corners");
  for (const std::int64_t v : grid.connectivity)
    if (v < 0 || v >= points)
      return wrong_grid(
          name, concat({"point ", v, " is not among the ", points, " points, counted from 0"}));
  const auto fits = [](const std::vector<VtkField>& fields, std::size_t count) {
    return std::all_of(fields.begin(), fields.end(), [&](const VtkField& field) {
      return std::visit([](const auto& values) { return values.size(); }, field.values) == count;
    });
  };
  if (!fits(grid.point_fields, grid.points.size()) || !fits(grid.cell_fields, grid.types.size()))
    return wrong_grid(name, "a field has another number of values than there are points or cells");
  return Ok{};
}

}  // namespace

Result<Geometry> geometry_of(const VtkGrid& grid, const std::string& name) {
  if (Status status = check_grid(grid, name); !status) return status.error();
  return GridReader(grid, name).read();
}

}  // namespace wellspaced
