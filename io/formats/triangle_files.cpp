#include "wellspaced/io/formats/triangle_files.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

bool has_extension(const std::string& path, std::string_view extension) {
  return path.size() > extension.size() &&
         std::string_view(path).substr(path.size() - extension.size()) == extension;
}

template <class Point>
std::optional<Index> first_difference(const std::vector<Point>& listed,
                                      const std::vector<Point>& mine) {
  const auto found = std::mismatch(listed.begin(), listed.end(), mine.begin(), mine.end()).first;
  if (found == listed.end()) return {};
  return static_cast<Index>(found - listed.begin());
}

// One reading of a set.
class SetReader {
 public:
  SetReader(const std::string& path, std::uint64_t largest, const Progress& progress)
      : path_(path), set_(triangle_set_name(path)), largest_(largest), progress_(progress) {}

  Result<Geometry> read();

 private:
  bool has(const char* extension) const { return file_exists(concat({set_, extension})); }
  Status read_points();
  Status read_domain(const char* extension);
  Status read_edges();
  Status read_faces();
  Status read_cells();
  Status read_boundary();
  Status check_points_of_domain(const Geometry& domain, const std::string& name) const;

  std::string path_, set_;
  std::uint64_t largest_;
  const Progress& progress_;
  Geometry geometry_;
};

Status SetReader::read_points() {
  const std::string name = concat({set_, ".node"});
  if (!has(".node") && (has(".poly") || has(".smesh"))) return Ok{};  // they must hold them
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  auto points = parse_node(*text, {name, progress_});
  if (!points) return points.error();
  geometry_ = *std::move(points);
  return Ok{};
}

Status SetReader::check_points_of_domain(const Geometry& domain, const std::string& name) const {
  const auto i = domain.dimension == 2
                     ? first_difference(domain.mesh.points, geometry_.mesh.points)
                     : first_difference(domain.solid.points, geometry_.solid.points);
  if (!i) return Ok{};
  return Error{ErrorCode::kInvalidGeometry,
               {name, ": its point ", std::uint64_t{*i} + domain.index_base, " is not that of ",
                set_, ".node; remove the points of one of them"},
               {*i}};
}

// A .poly or .smesh, which may lean on the .node.
Result<Geometry> parse_domain(std::string_view text, const TextSource& source,
                              const Geometry* points) {
  return has_extension(source.name, ".smesh") ? parse_smesh(text, source, points)
                                              : parse_poly(text, source, points);
}

Status SetReader::read_domain(const char* extension) {
  const std::string name = concat({set_, extension});
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  const bool refers = poly_refers_to_node(*text);
  if (refers && !has(".node"))
    return Error{ErrorCode::kUnreadable,
                 {name, ": holds no points, and ", set_, ".node is missing"}};
  auto domain = parse_domain(*text, {name, progress_}, refers ? &geometry_ : nullptr);
  if (!domain) return domain.error();
  if (!refers && has(".node")) {
    if (Status status = check_points_of_domain(*domain, name); !status) return status;
    domain->mesh.points = std::move(geometry_.mesh.points);
    domain->mesh.point_markers = std::move(geometry_.mesh.point_markers);
    domain->solid.points = std::move(geometry_.solid.points);
    domain->solid.point_markers = std::move(geometry_.solid.point_markers);
    domain->point_attributes = std::move(geometry_.point_attributes);
    domain->index_base = geometry_.index_base;
    domain->dimension = geometry_.dimension;
  }
  geometry_ = *std::move(domain);
  return Ok{};
}

Status SetReader::read_edges() {
  const std::string name = concat({set_, ".edge"});
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  const auto edges = parse_edge(*text, {name, progress_}, geometry_);
  if (!edges) return edges.error();
  auto& segments = geometry_.dimension == 2 ? geometry_.mesh.segments : geometry_.solid.segments;
  std::copy_if(edges->begin(), edges->end(), std::back_inserter(segments),
               [](const Segment& s) { return s.marker != 0; });
  return Ok{};
}

Status SetReader::read_faces() {
  const std::string name = concat({set_, ".face"});
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  auto faces = parse_face(*text, {name, progress_}, geometry_);
  if (!faces) return faces.error();
  geometry_.solid.facets = *std::move(faces);
  return Ok{};
}

Status SetReader::read_cells() {
  const std::string name = concat({set_, ".ele"});
  const auto text = read_input(name, largest_);
  if (!text) return text.error();
  return parse_ele(*text, {name, progress_}, geometry_);
}

// The boundary of a mesh in space is in its .face and .edge; any other is in the domain's file.
Status SetReader::read_boundary() {
  const bool listed = geometry_.dimension == 3 && has(".ele") && has(".face");
  if (!listed && has(".poly")) return read_domain(".poly");
  if (!listed && has(".smesh")) return read_domain(".smesh");
  Status status = Ok{};
  if (geometry_.dimension == 3 && has(".face")) status = read_faces();
  if (status.ok() && has(".edge")) status = read_edges();
  return status;
}

Result<Geometry> SetReader::read() {
  if (!file_exists(path_)) return read_input(path_).error();
  if (Status status = read_points(); !status) return status.error();
  if (Status status = read_boundary(); !status) return status.error();
  if (has(".ele"))
    if (Status status = read_cells(); !status) return status.error();
  return std::move(geometry_);
}

// Whether the domain needs a file of its own: that of a mesh in space is in .face and .edge.
bool needs_poly(const Geometry& g) {
  if (g.dimension == 2) return !g.mesh.segments.empty() || !g.holes.empty() || !g.regions.empty();
  const bool bounds = g.has_facets() || !g.solid.segments.empty();
  return !g.polygons.empty() || !g.volume_holes.empty() || !g.volume_regions.empty() ||
         (bounds && g.solid.tets.empty());
}

// Files of such a set would be hidden: "dir/.node".
bool names_directory(std::string_view set) {
  const std::string_view last = set.substr(set.find_last_of('/') + 1);
  return last.empty() || last == "." || last == "..";
}

bool is_simple(const Pls::Facet& facet) {
  return facet.polygons.size() == 1 && facet.holes.empty();
}

}  // namespace

std::string triangle_set_name(const std::string& path) {
  for (const std::string_view extension : {".node", ".ele", ".poly", ".edge", ".smesh", ".face"})
    if (has_extension(path, extension)) return path.substr(0, path.size() - extension.size());
  return path;
}

Result<Geometry> read_triangle_set(const std::string& path, std::uint64_t largest,
                                   const Progress& progress) {
  return SetReader(path, largest, progress).read();
}

Result<Geometry> read_triangle_file(const std::string& path, std::uint64_t largest,
                                    const Progress& progress) {
  const auto text = read_input(path, largest);
  if (!text) return text.error();
  if (has_extension(path, ".node")) return parse_node(*text, {path, progress});
  if (!has_extension(path, ".poly") && !has_extension(path, ".smesh"))
    return Error{ErrorCode::kUnreadable, {path, ": holds no points; name its .node or .poly file"}};
  if (!poly_refers_to_node(*text)) return parse_domain(*text, {path, progress}, nullptr);
  const std::string node = concat({triangle_set_name(path), ".node"});
  const auto node_text = read_input(node, largest);
  if (!node_text) return node_text.error();
  const auto points = parse_node(*node_text, {node, progress});
  if (!points) return points.error();
  return parse_domain(*text, {path, progress}, &*points);
}

Status write_triangle_set(OutputSet& outputs, const std::string& path, const Geometry& geometry,
                          EmptyFiles empty) {
  const std::string set = triangle_set_name(path);
  if (names_directory(set))
    return Error{ErrorCode::kUsage, {path, ": names a folder; name the files in it"}};
  const bool all = empty == EmptyFiles::kWrite;
  const auto add = [&](const char* extension, const auto& write) {
    return outputs.add(concat({set, extension}), [&](TextWriter& out) { write(out, geometry); });
  };
  const auto write_references = [](TextWriter& out, const Geometry& g) {
    write_poly(out, g, PolyPoints::kInNodeFile);
  };
  Status status = add(".node", write_node);
  if (status.ok() && (all || geometry.has_cells() || has_extension(path, ".ele")))
    status = add(".ele", write_ele);
  const bool plane = geometry.dimension == 2;
  const bool poly = needs_poly(geometry) || (all && plane);
  if (status.ok() && (poly || has_extension(path, ".poly")))
    status = add(".poly", write_references);
  const bool space_mesh = !poly && !plane;
  if (status.ok() && space_mesh && !geometry.solid.facets.empty())
    status = add(".face", write_face);
  const bool edges = space_mesh && !geometry.solid.segments.empty();
  if (status.ok() && (edges || has_extension(path, ".edge"))) status = add(".edge", write_edge);
  return status;
}

Status write_poly_file(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  return outputs.add(path,
                     [&](TextWriter& out) { write_poly(out, geometry, PolyPoints::kInside); });
}

Status write_smesh_file(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (geometry.dimension != 3)
    return Error{ErrorCode::kUsage, {path, ": only a domain in space can be an .smesh file"}};
  if (!std::all_of(geometry.polygons.begin(), geometry.polygons.end(), is_simple))
    return Error{ErrorCode::kUsage,
                 {path, ": a facet has holes or several polygons; write a .poly file"}};
  return outputs.add(path,
                     [&](TextWriter& out) { write_smesh(out, geometry, PolyPoints::kInside); });
}

}  // namespace wellspaced
