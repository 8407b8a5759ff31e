#include "wellspaced/io/formats/triangle_files.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"

namespace wellspaced {
namespace {

bool has_extension(const std::string& path, std::string_view extension) {
  return path.size() > extension.size() &&
         std::string_view(path).substr(path.size() - extension.size()) == extension;
}

// One reading of a set.
class SetReader {
 public:
  SetReader(const std::string& path, std::uint64_t largest)
      : path_(path), set_(triangle_set_name(path)), largest_(largest) {}

  Result<Geometry> read();

 private:
  Status read_points();
  Status read_poly();
  Status read_edges();
  Status read_cells();
  Status check_points_of_poly(const Geometry& poly, const std::string& name) const;

  std::string path_, set_;
  std::uint64_t largest_;
  Geometry geometry_;
};

Status SetReader::read_points() {
  const std::string name = set_ + ".node";
  if (!file_exists(name) && file_exists(set_ + ".poly")) return Ok{};  // the .poly must hold them
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  auto points = parse_node(*text, name);
  if (!points) return points.error();
  geometry_ = *std::move(points);
  return Ok{};
}

Status SetReader::check_points_of_poly(const Geometry& poly, const std::string& name) const {
  const auto& mine = geometry_.mesh.points;
  const auto& listed = poly.mesh.points;
  const auto differ = std::mismatch(listed.begin(), listed.end(), mine.begin(), mine.end()).first;
  if (differ == listed.end()) return Ok{};
  const auto i = static_cast<Index>(differ - listed.begin());
  return Error{ErrorCode::kInvalidGeometry,
               name + ": its point " + std::to_string(std::uint64_t{i} + poly.index_base) +
                   " is not that of " + set_ + ".node; remove the points of one of them",
               {i}};
}

Status SetReader::read_poly() {
  const std::string name = set_ + ".poly";
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  const bool refers = poly_refers_to_node(*text);
  const bool has_node = file_exists(set_ + ".node");
  if (refers && !has_node)
    return Error{
        ErrorCode::kUnreadable, name + ": holds no points, and " + set_ + ".node is missing", {}};
  auto poly = parse_poly(*text, name, refers ? &geometry_ : nullptr);
  if (!poly) return poly.error();
  if (refers || !has_node) {
    geometry_ = *std::move(poly);
    return Ok{};
  }
  if (Status status = check_points_of_poly(*poly, name); !status) return status;
  geometry_.mesh.segments = std::move(poly->mesh.segments);
  geometry_.holes = std::move(poly->holes);
  geometry_.regions = std::move(poly->regions);
  return Ok{};
}

Status SetReader::read_edges() {
  const std::string name = set_ + ".edge";
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  const auto edges = parse_edge(*text, name, geometry_);
  if (!edges) return edges.error();
  std::copy_if(edges->begin(), edges->end(), std::back_inserter(geometry_.mesh.segments),
               [](const Segment& s) { return s.marker != 0; });
  return Ok{};
}

Status SetReader::read_cells() {
  const std::string name = set_ + ".ele";
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  return parse_ele(*text, name, geometry_);
}

Result<Geometry> SetReader::read() {
  if (!file_exists(path_)) return read_input(path_).error();
  if (Status status = read_points(); !status) return status.error();
  const bool plane = geometry_.dimension == 2;
  if (file_exists(set_ + ".poly")) {
    if (!plane) {
      geometry_.notes.push_back(set_ + ".poly: facets in space are not read");
    } else if (Status status = read_poly(); !status) {
      return status.error();
    }
  } else if (plane && file_exists(set_ + ".edge")) {
    if (Status status = read_edges(); !status) return status.error();
  }
  if (file_exists(set_ + ".ele"))
    if (Status status = read_cells(); !status) return status.error();
  return std::move(geometry_);
}

bool needs_poly(const Geometry& geometry) {
  return !geometry.mesh.segments.empty() || !geometry.holes.empty() || !geometry.regions.empty();
}

}  // namespace

std::string triangle_set_name(const std::string& path) {
  for (const std::string_view extension : {".node", ".ele", ".poly", ".edge"})
    if (has_extension(path, extension)) return path.substr(0, path.size() - extension.size());
  return path;
}

Result<Geometry> read_triangle_set(const std::string& path, std::uint64_t largest) {
  return SetReader(path, largest).read();
}

Result<Geometry> read_triangle_file(const std::string& path, std::uint64_t largest) {
  const auto text = read_input(path, largest);
  if (!text) return text.error();
  if (has_extension(path, ".node")) return parse_node(*text, path);
  if (!has_extension(path, ".poly"))
    return Error{
        ErrorCode::kUnreadable, path + ": holds no points; name its .node or .poly file", {}};
  if (!poly_refers_to_node(*text)) return parse_poly(*text, path);
  const std::string node = triangle_set_name(path) + ".node";
  const auto node_text = read_input(node, largest);
  if (!node_text) return node_text.error();
  const auto points = parse_node(*node_text, node);
  if (!points) return points.error();
  return parse_poly(*text, path, &*points);
}

Status write_triangle_set(OutputSet& outputs, const std::string& path, const Geometry& geometry,
                          EmptyFiles empty) {
  const std::string set = triangle_set_name(path);
  const bool all = empty == EmptyFiles::kWrite;
  const auto add = [&](const char* extension, const auto& write) {
    return outputs.add(set + extension, [&](TextWriter& out) { write(out, geometry); });
  };
  const auto write_references = [](TextWriter& out, const Geometry& g) {
    write_poly(out, g, PolyPoints::kInNodeFile);
  };
  Status status = add(".node", write_node);
  if (status.ok() && (all || geometry.has_cells())) status = add(".ele", write_ele);
  if (status.ok() && geometry.dimension == 2 && (all || needs_poly(geometry)))
    status = add(".poly", write_references);
  if (status.ok() && has_extension(path, ".edge")) status = add(".edge", write_edge);
  return status;
}

Status write_poly_file(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  return outputs.add(path,
                     [&](TextWriter& out) { write_poly(out, geometry, PolyPoints::kInside); });
}

}  // namespace wellspaced
