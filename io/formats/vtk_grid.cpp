#include <utility>

#include "wellspaced/io/formats/vtk.hpp"

namespace wellspaced {
namespace {

template <std::size_t kCorners>
void add_cell(VtkGrid& grid, std::uint8_t type, const std::array<Index, kCorners>& corners) {
  grid.connectivity.insert(grid.connectivity.end(), corners.begin(), corners.end());
  grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
  grid.types.push_back(type);
}

void add_point_markers(VtkGrid& grid, const std::vector<int>& markers) {
  if (!markers.empty())
    grid.point_fields.push_back(
        {"marker", std::vector<std::int32_t>(markers.begin(), markers.end())});
}

void add_points_as_cells(VtkGrid& grid) {
  for (Index v = 0; v < grid.points.size(); ++v) add_cell<1>(grid, kVtkVertex, {v});
}

// The cells must all be in place.
void add_cell_markers(VtkGrid& grid, std::vector<std::int32_t> markers) {
  if (grid.types.empty()) add_points_as_cells(grid);
  markers.resize(grid.types.size());
  grid.cell_fields.push_back({"marker", std::move(markers)});
}

}  // namespace

VtkGrid vtk_grid(const TriangleMesh& mesh) {
  VtkGrid grid;
  for (const Point2& p : mesh.points) grid.points.push_back({p.x, p.y, 0});
  for (const auto& t : mesh.triangles) add_cell(grid, kVtkTriangle, t);
  std::vector<std::int32_t> markers(mesh.triangles.size(), 0);
  for (const Segment& s : mesh.segments) {
    add_cell<2>(grid, kVtkLine, {s.a, s.b});
    markers.push_back(s.marker);
  }
  add_point_markers(grid, mesh.point_markers);
  add_cell_markers(grid, std::move(markers));
  return grid;
}

VtkGrid vtk_grid(const TetMesh& mesh) {
  VtkGrid grid;
  grid.points = mesh.points;
  for (const auto& t : mesh.tets) add_cell(grid, kVtkTetra, t);
  std::vector<std::int32_t> markers(mesh.tets.size(), 0);
  for (const TetMesh::Facet& f : mesh.facets) {
    add_cell(grid, kVtkTriangle, f.points);
    markers.push_back(f.marker);
  }
  for (const Segment& s : mesh.segments) {
    add_cell<2>(grid, kVtkLine, {s.a, s.b});
    markers.push_back(s.marker);
  }
  add_point_markers(grid, mesh.point_markers);
  add_cell_markers(grid, std::move(markers));
  return grid;
}

}  // namespace wellspaced
