#include "wellspaced/io/formats/metis.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/io/formats/point_files.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

class MetisParser {
 public:
  MetisParser(std::string_view text, const TextSource& source)
      : scanner_(text, source, {.comment = '%'}) {}

  Result<MetisGraph> parse();

 private:
  void read_header();
  void read_vertex(Index v);
  bool next_vertex_line();
  void check_edges();

  Scanner scanner_;
  MetisGraph graph_;
  std::vector<std::pair<Index, Index>> arcs_;
  std::size_t passed_over_ = 0;  // fields before the neighbours of each vertex
  bool edge_weights_ = false;
  Index edges_ = 0;
};

// fmt: three digits, for vertex sizes, vertex weights and edge weights; ncon: how many weights.
void MetisParser::read_header() {
  if (!scanner_.require_line("the number of vertices")) return;
  graph_.vertices = scanner_.count("vertices", 0);
  edges_ = scanner_.count("edges", 2);
  const std::int64_t format = scanner_.integer_or(0, "format");
  const std::int64_t weights = scanner_.integer_or(1, "number of weights");
  constexpr std::array<std::int64_t, 8> kWeightFormats = {0, 1, 10, 11, 100, 101, 110, 111};
  if (std::find(kWeightFormats.begin(), kWeightFormats.end(), format) == kWeightFormats.end() ||
      weights < 0 || weights > 1000)
    scanner_.fail(ErrorCode::kUnreadable, {"the format ", format, " makes no sense"});
  if (!scanner_.ok()) return;
  passed_over_ =
      (format >= 100 ? 1u : 0u) + (format / 10 % 10 == 1 ? static_cast<std::size_t>(weights) : 0u);
  edge_weights_ = format % 10 == 1;
}

// Lines of comments are no vertices, but empty ones are.
bool MetisParser::next_vertex_line() {
  do {
    if (!scanner_.next_line_or_empty()) return false;
  } while (scanner_.has_comment() && !scanner_.more());
  return true;
}

void MetisParser::read_vertex(Index v) {
  scanner_.skip_fields(passed_over_);
  while (scanner_.more() && scanner_.ok()) {
    const Index w = scanner_.point(graph_.vertices, 1);
    if (edge_weights_) scanner_.number("weight of an edge");
    if (scanner_.ok() && v == w)
      scanner_.fail(ErrorCode::kUnreadable, {"vertex ", v + 1, " joins itself"});
    if (scanner_.ok()) arcs_.emplace_back(v, w);
  }
}

void MetisParser::check_edges() {
  sort(arcs_);
  const auto name = [](std::pair<Index, Index> arc) {
    return concat({std::uint64_t{arc.first} + 1, "-", std::uint64_t{arc.second} + 1});
  };
  for (std::size_t i = 0; i < arcs_.size() && scanner_.ok(); ++i) {
    const auto& [v, w] = arcs_[i];
    if (i > 0 && arcs_[i] == arcs_[i - 1])
      scanner_.fail(ErrorCode::kUnreadable, {"edge ", name(arcs_[i]), " is listed twice"});
    if (!std::binary_search(arcs_.begin(), arcs_.end(), std::pair(w, v)))
      scanner_.fail(ErrorCode::kUnreadable, {"edge ", name(arcs_[i]), " has no edge back"});
    if (v < w) graph_.edges.push_back({v, w, 0});
  }
  if (scanner_.ok() && graph_.edges.size() != edges_)
    scanner_.fail(ErrorCode::kUnreadable,
                  {"there are ", graph_.edges.size(), " edges, not ", edges_, " as announced"});
}

Result<MetisGraph> MetisParser::parse() {
  read_header();
  for (Index v = 0; v < graph_.vertices && scanner_.ok(); ++v) {
    if (!next_vertex_line())
      scanner_.fail(ErrorCode::kUnreadable,
                    {"the file ends before its ", graph_.vertices, " vertices do"});
    read_vertex(v);
  }
  if (scanner_.next_line())
    scanner_.fail(ErrorCode::kUnreadable, "more lines follow than there are vertices");
  if (scanner_.ok()) check_edges();
  if (!scanner_.ok()) return scanner_.error();
  return std::move(graph_);
}

std::string without_graph_extension(const std::string& path) {
  constexpr std::string_view kExtension = ".graph";
  const bool has = path.size() > kExtension.size() && path.ends_with(kExtension);
  return has ? path.substr(0, path.size() - kExtension.size()) : path;
}

// All edges of cells and facets, and all segments, once, from their lower end.
std::vector<std::pair<Index, Index>> edges_of(const Geometry& lifted) {
  std::vector<std::pair<Index, Index>> edges;
  const auto add = [&](Index a, Index b) { edges.push_back(std::minmax(a, b)); };
  const auto add_all = [&](const auto& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j) add(corners[i], corners[j]);
  };
  for (const auto& tet : lifted.solid.tets) add_all(tet);
  for (const TetMesh::Facet& facet : lifted.solid.facets) add_all(facet.points);
  for (const Segment& s : lifted.solid.segments) add(s.a, s.b);
  for (const Pls::Facet& facet : lifted.polygons)
    for (const auto& polygon : facet.polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i)
        add(polygon[i], polygon[(i + 1) % polygon.size()]);
  std::erase_if(edges, [](const auto& edge) { return edge.first == edge.second; });
  sort_unique(edges);
  return edges;
}

void write_metis_graph(TextWriter& out, std::size_t vertices,
                       const std::vector<std::pair<Index, Index>>& edges) {
  std::vector<std::pair<Index, Index>> arcs = edges;
  for (const auto& [a, b] : edges) arcs.emplace_back(b, a);
  sort(arcs);
  out << vertices << ' ' << edges.size() << '\n';
  auto arc = arcs.begin();
  for (std::size_t v = 0; v < vertices; ++v) {
    for (const char* blank = ""; arc != arcs.end() && arc->first == v; ++arc, blank = " ")
      out << blank << std::uint64_t{arc->second} + 1;
    out << '\n';
  }
}

}  // namespace

Result<MetisGraph> parse_metis_graph(std::string_view text, const TextSource& source) {
  return MetisParser(text, source).parse();
}

Result<Geometry> read_metis(const std::string& path, std::uint64_t largest,
                            const Progress& progress) {
  const auto text = read_input(path, largest);
  if (!text) return text.error();
  auto graph = parse_metis_graph(*text, {path, progress});
  if (!graph) return graph.error();
  const std::string set = without_graph_extension(path);
  const std::string points =
      file_exists(concat({set, ".xyz"})) ? concat({set, ".xyz"}) : concat({set, ".coords"});
  const auto points_text = read_input(points, largest);
  if (!points_text) return points_text.error();
  auto geometry = parse_xyz(*points_text, {points, progress});
  if (!geometry) return geometry.error();
  if (geometry->point_count() != graph->vertices)
    return Error{ErrorCode::kUnreadable,
                 {points, ": holds ", geometry->point_count(), " points for the ", graph->vertices,
                  " vertices of ", path}};
  auto& segments = geometry->dimension == 2 ? geometry->mesh.segments : geometry->solid.segments;
  segments = std::move(graph->edges);
  return geometry;
}

Status write_metis(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (path == "-")
    return Error{ErrorCode::kUsage, "a graph and its coordinates are two files: name them"};
  const std::string set = without_graph_extension(path);
  const auto edges = edges_of(lift_to_space(geometry));
  Status status = outputs.add(concat({set, ".graph"}), [&](TextWriter& out) {
    write_metis_graph(out, geometry.point_count(), edges);
  });
  if (!status.ok()) return status;
  return outputs.add(concat({set, ".xyz"}), [&](TextWriter& out) { write_xyz(out, geometry); });
}

}  // namespace wellspaced
