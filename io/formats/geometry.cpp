#include "wellspaced/io/formats/geometry.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "wellspaced/io/text/numbers.hpp"

namespace wellspaced {
namespace {

bool is_triangle(const Pls::Facet& facet) {
  return facet.holes.empty() && facet.polygons.size() == 1 && facet.polygons[0].size() == 3;
}

Pls::Facet to_polygon(const TetMesh::Facet& f) {
  return {{{f.points[0], f.points[1], f.points[2]}}, {}, f.marker};
}

bool fits_int(std::int64_t value) {
  return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
}

bool is_int(double value) {
  return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max() &&
         value == static_cast<int>(value);
}

bool lies_in_plane(const Geometry& g) {
  return g.dimension == 3 && g.solid.tets.empty() && g.polygons.empty() && g.volume_holes.empty() &&
         g.volume_regions.empty() &&
         std::all_of(g.solid.points.begin(), g.solid.points.end(),
                     [](const Point3& p) { return p.z == 0; });
}

}  // namespace

Geometry::Geometry() = default;
Geometry::Geometry(const Geometry&) = default;
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(const Geometry& other) { return *this = Geometry(other); }
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

void add_facet(Geometry& geometry, Pls::Facet facet) {
  auto& triangles = geometry.solid.facets;
  auto& polygons = geometry.polygons;
  if (polygons.empty() && is_triangle(facet)) {
    const std::vector<Index>& corners = facet.polygons[0];
    triangles.push_back({{corners[0], corners[1], corners[2]}, facet.marker});
    return;
  }
  for (const TetMesh::Facet& f : std::exchange(triangles, {})) polygons.push_back(to_polygon(f));
  polygons.push_back(std::move(facet));
}

void lay_in_plane(Geometry& geometry) {
  if (!lies_in_plane(geometry)) return;
  TetMesh solid = std::exchange(geometry.solid, {});
  TriangleMesh& mesh = geometry.mesh;
  geometry.dimension = 2;
  for (const Point3& p : solid.points) mesh.points.push_back({p.x, p.y});
  std::vector<int> markers;
  for (const TetMesh::Facet& f : solid.facets) {
    mesh.triangles.push_back(f.points);
    markers.push_back(f.marker);
  }
  mesh.segments = std::move(solid.segments);
  mesh.point_markers = std::move(solid.point_markers);
  set_cell_markers(geometry, markers);
}

Geometry lift_to_space(Geometry geometry) {
  if (geometry.dimension == 3) return geometry;
  const std::vector<int> markers = cell_markers(geometry);
  TriangleMesh mesh = std::exchange(geometry.mesh, {});
  TetMesh& solid = geometry.solid;
  geometry.dimension = 3;
  geometry.cell_attributes = {};
  for (const Point2& p : mesh.points) solid.points.push_back({p.x, p.y, 0});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    solid.facets.push_back({mesh.triangles[t], markers[t]});
  solid.segments = std::move(mesh.segments);
  solid.point_markers = std::move(mesh.point_markers);
  return geometry;
}

Status refuse_polygons(const Geometry& geometry, const std::string& path, const std::string& what) {
  if (geometry.polygons.empty()) return Ok{};
  return Error{ErrorCode::kUsage,
               {path, ": ", what, " has no place for facets that are no triangles; write .poly"}};
}

std::vector<int> without_zeros(std::vector<int> markers) {
  if (std::all_of(markers.begin(), markers.end(), [](int m) { return m == 0; })) markers.clear();
  return markers;
}

std::vector<int> cell_markers(const Geometry& geometry) {
  const std::vector<double>& values = geometry.cell_attributes.values;
  const std::size_t cells =
      geometry.dimension == 2 ? geometry.mesh.triangles.size() : geometry.solid.tets.size();
  std::vector<int> markers(cells, 0);
  if (geometry.cell_attributes.columns == 1 && std::all_of(values.begin(), values.end(), is_int))
    std::transform(values.begin(), values.end(), markers.begin(),
                   [](double value) { return static_cast<int>(value); });
  return markers;
}

void set_cell_markers(Geometry& geometry, const std::vector<int>& markers) {
  geometry.cell_attributes = {};
  if (!without_zeros(markers).empty())
    geometry.cell_attributes = {1, {markers.begin(), markers.end()}};
}

std::string marker_name(const Geometry& geometry, int dimension, int marker) {
  for (const MarkerName& known : geometry.marker_names)
    if (known.dimension == dimension && known.marker == marker) return known.name;
  return std::to_string(marker);
}

int MarkerNumbering::marker_of(std::string_view name) {
  if (const auto found = known_.find(name); found != known_.end()) return found->second;
  const auto number = parse_integer(name);
  const bool keeps = number && fits_int(*number) && !used_.contains(static_cast<int>(*number));
  while (!keeps && used_.contains(next_)) ++next_;
  const int marker = keeps ? static_cast<int>(*number) : next_;
  known_.emplace(name, marker);
  used_.insert(marker);
  if (!keeps) geometry_.marker_names.push_back({dimension_, marker, std::string(name)});
  return marker;
}

}  // namespace wellspaced
