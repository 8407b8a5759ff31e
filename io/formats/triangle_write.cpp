#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/io/formats/space_domain.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

TextWriter& operator<<(TextWriter& out, const Point2& p) { return out << p.x << ' ' << p.y; }

TextWriter& operator<<(TextWriter& out, const Point3& p) {
  return out << p.x << ' ' << p.y << ' ' << p.z;
}

void write_row(TextWriter& out, const Attributes& attributes, std::size_t row) {
  for (Index a = 0; a < attributes.columns; ++a)
    out << ' ' << attributes.values[row * attributes.columns + a];
}

template <class Point>
void write_point_lines(TextWriter& out, const std::vector<Point>& points,
                       const Geometry& geometry) {
  const std::vector<int>& markers = geometry.point_markers();
  for (std::size_t i = 0; i < points.size(); ++i) {
    out << i + geometry.index_base << ' ' << points[i];
    write_row(out, geometry.point_attributes, i);
    if (!markers.empty()) out << ' ' << markers[i];
    out << '\n';
  }
}

void write_point_header(TextWriter& out, const Geometry& geometry, std::size_t count) {
  out.comment("#", geometry.remark);
  out << count << ' ' << geometry.dimension << ' ' << geometry.point_attributes.columns << ' '
      << (geometry.point_markers().empty() ? 0 : 1) << '\n';
}

void write_points_or_header(TextWriter& out, const Geometry& geometry, PolyPoints points) {
  if (points == PolyPoints::kInside) {
    write_node(out, geometry);
  } else {
    write_point_header(out, geometry, 0);
  }
}

template <std::size_t kCorners>
void write_cells(TextWriter& out, const std::vector<std::array<Index, kCorners>>& cells,
                 const Geometry& geometry) {
  out.comment("#", geometry.remark);
  out << cells.size() << ' ' << kCorners << ' ' << geometry.cell_attributes.columns << '\n';
  for (std::size_t t = 0; t < cells.size(); ++t) {
    out << t + geometry.index_base;
    for (const Index v : cells[t]) out << ' ' << std::uint64_t{v} + geometry.index_base;
    write_row(out, geometry.cell_attributes, t);
    out << '\n';
  }
}

void write_segments(TextWriter& out, const std::vector<Segment>& segments, Index base) {
  const bool marked =
      std::any_of(segments.begin(), segments.end(), [](const Segment& s) { return s.marker != 0; });
  out << segments.size() << (marked ? " 1\n" : " 0\n");
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& [a, b, marker] = segments[i];
    out << i + base << ' ' << std::uint64_t{a} + base << ' ' << std::uint64_t{b} + base;
    if (marked) out << ' ' << marker;
    out << '\n';
  }
}

Segment ascending(Index a, Index b, int marker) { return {std::min(a, b), std::max(a, b), marker}; }

}  // namespace

void write_node(TextWriter& out, const Geometry& geometry) {
  write_point_header(out, geometry, geometry.point_count());
  if (geometry.dimension == 2) {
    write_point_lines(out, geometry.mesh.points, geometry);
  } else {
    write_point_lines(out, geometry.solid.points, geometry);
  }
}

void write_ele(TextWriter& out, const Geometry& geometry) {
  if (geometry.dimension == 2) {
    write_cells(out, geometry.mesh.triangles, geometry);
  } else {
    write_cells(out, geometry.solid.tets, geometry);
  }
}

void write_smesh(TextWriter& out, const Geometry& geometry, PolyPoints points) {
  write_points_or_header(out, geometry, points);
  write_space_domain(out, FacetSyntax::kSmesh, geometry);
}

void write_face(TextWriter& out, const Geometry& geometry) {
  const Index base = geometry.index_base;
  const auto& facets = geometry.solid.facets;
  out.comment("#", geometry.remark);
  out << facets.size() << " 1\n";
  for (std::size_t i = 0; i < facets.size(); ++i) {
    out << i + base;
    for (const Index v : facets[i].points) out << ' ' << std::uint64_t{v} + base;
    out << ' ' << facets[i].marker << '\n';
  }
}

void write_poly(TextWriter& out, const Geometry& geometry, PolyPoints points) {
  write_points_or_header(out, geometry, points);
  if (geometry.dimension == 3) return write_space_domain(out, FacetSyntax::kPoly, geometry);
  const Index base = geometry.index_base;
  write_segments(out, geometry.mesh.segments, base);
  out << geometry.holes.size() << '\n';
  for (std::size_t i = 0; i < geometry.holes.size(); ++i)
    out << i + base << ' ' << geometry.holes[i] << '\n';
  if (geometry.regions.empty()) return;
  out << geometry.regions.size() << '\n';
  for (std::size_t i = 0; i < geometry.regions.size(); ++i) {
    const Pslg::Region& region = geometry.regions[i];
    out << i + base << ' ' << region.seed << ' ' << region.attribute << ' ' << region.max_area
        << '\n';
  }
}

void write_edge(TextWriter& out, const Geometry& geometry) {
  std::vector<Segment> edges;
  for (const Segment& s : geometry.solid.segments) edges.push_back(ascending(s.a, s.b, s.marker));
  for (const Segment& s : geometry.mesh.segments) edges.push_back(ascending(s.a, s.b, s.marker));
  for (const auto& [a, b, c] : geometry.mesh.triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edges.push_back(ascending(from, to, 0));
  const auto ends = [](const Segment& s) { return std::pair(s.a, s.b); };
  sort(edges, [&](const Segment& s, const Segment& t) { return ends(s) < ends(t); });
  const auto last =
      std::unique(edges.begin(), edges.end(),
                  [&](const Segment& s, const Segment& t) { return ends(s) == ends(t); });
  edges.erase(last, edges.end());
  out.comment("#", geometry.remark);
  write_segments(out, edges, geometry.index_base);
}

}  // namespace wellspaced
