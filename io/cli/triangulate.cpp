// wellspaced triangulate: Delaunay and constrained Delaunay triangulations.
#include <array>
#include <optional>

#include "wellspaced/algorithms/mesh/delaunay_cells.hpp"
#include "wellspaced/algorithms/mesh/directed_edges.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/hole_seeds.hpp"
#include "wellspaced/io/cli/stopwatch.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

namespace wellspaced::cli {
namespace {

// What the command reports, in the words of its JSON.
struct Report {
  std::size_t points = 0, distinct_points = 0, duplicates = 0, hull_points = 0;
  std::size_t added_points = 0, constrained_edges = 0;
  std::size_t hull_triangles = 0;
  int dimension = -1;
  std::optional<std::size_t> triangles, tets;
  std::optional<std::string> cells_sha256;
  PhaseTime read, triangulate, write;
  std::uint64_t peak_bytes = 0;
};

struct Choices {
  unsigned threads = 1;
  HoleRule holes = HoleRule::kParity;
  CrossingRule crossings = CrossingRule::kSplit;
  bool cells_hash = false;
};

Choices read_choices(Arguments& arguments, const Geometry& input, unsigned threads) {
  constexpr std::array kRules = {HoleRule::kParity, HoleRule::kSeeds, HoleRule::kNone,
                                 HoleRule::kOuter};
  const std::size_t usual = input.mesh.segments.empty() ? 2 : input.holes.empty() ? 0 : 1;
  Choices choices{.threads = threads};
  choices.holes = kRules[arguments.choice("--holes", usual, {"parity", "seeds", "none", "outer"})];
  choices.crossings = arguments.choice("--intersections", 0, {"split", "refuse"}) == 0
                          ? CrossingRule::kSplit
                          : CrossingRule::kRefuse;
  choices.cells_hash = arguments.has("--cells-hash");
  return choices;
}

using Triangles = std::vector<std::array<Index, 3>>;

// All triangles but ghosts, counter-clockwise.
Triangles hull_triangles(const Triangulation2& topology) {
  Triangles triangles;
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) triangles.push_back(topology.vertices(t));
  return triangles;
}

// The vertices on the boundary of the hull; of a chain its ends.
std::size_t count_hull_points(const Delaunay2& delaunay, std::size_t triangles) {
  if (delaunay.dimension() < 2) return static_cast<std::size_t>(delaunay.dimension() + 1);
  return delaunay.topology().size() - triangles;  // a ghost for each hull edge
}

// How many of `count` points from `first` on are no vertices.
std::size_t count_duplicates(const Delaunay2& delaunay, std::size_t first, std::size_t count) {
  std::size_t duplicates = 0;
  for (std::size_t i = first; i < first + count; ++i)
    duplicates += !delaunay.is_vertex(static_cast<Index>(i));
  return duplicates;
}

void describe(const Delaunay2& delaunay, bool cells_hash, std::span<const Segment> segments,
              Report& report) {
  const Triangles all = hull_triangles(delaunay.topology());
  report.dimension = delaunay.dimension();
  report.duplicates = count_duplicates(delaunay, 0, report.points);
  report.distinct_points = report.points - report.duplicates;
  const std::size_t added = delaunay.points().size() - report.points;
  report.added_points = added - count_duplicates(delaunay, report.points, added);
  report.hull_triangles = all.size();
  report.hull_points = count_hull_points(delaunay, all.size());
  if (cells_hash && delaunay.dimension() == 2)
    report.cells_sha256 =
        cells_sha256(delaunay.points(), delaunay_cells(delaunay.points(), all, segments));
}

// What was there before the command keeps its attributes and markers, what is new gets zeros.
void pad_point_data(Geometry& geometry) {
  const std::size_t count = geometry.point_count();
  geometry.point_attributes.values.resize(count * geometry.point_attributes.columns);
  if (!geometry.mesh.point_markers.empty()) geometry.mesh.point_markers.resize(count);
}

// Each of the following turns `geometry` from the input into the triangulation.

Status triangulate_points(const Choices& choices, const Progress& progress, Geometry& geometry,
                          Report& report) {
  const MemoryGauge memory;
  const Stopwatch watch;
  const auto delaunay = Delaunay2::build(geometry.mesh.points, {progress, choices.threads});
  if (!delaunay) return delaunay.error();
  report.triangulate = watch.elapsed();
  report.peak_bytes = memory.peak();
  describe(*delaunay, choices.cells_hash, {}, report);
  geometry.mesh.triangles = hull_triangles(delaunay->topology());
  report.triangles = geometry.mesh.triangles.size();
  return Ok{};
}

Status triangulate_domain(const Choices& choices, const Progress& progress, Geometry& geometry,
                          Report& report) {
  const Pslg graph = to_pslg(geometry);
  const MemoryGauge memory;
  const Stopwatch watch;
  const auto result =
      triangulate(graph, {choices.holes, choices.crossings, progress, choices.threads});
  if (!result) return result.error();
  report.triangulate = watch.elapsed();
  report.peak_bytes = memory.peak();
  describe(result->delaunay, choices.cells_hash, result->segments, report);
  geometry.mesh.points = result->delaunay.points();
  geometry.mesh.triangles = result->triangles();
  geometry.mesh.segments = result->segments;
  pad_point_data(geometry);
  report.triangles = geometry.mesh.triangles.size();
  report.constrained_edges = result->segments.size();
  return Ok{};
}

Status triangulate_solid(const Choices& choices, const Progress& progress, Geometry& geometry,
                         Report& report) {
  const MemoryGauge memory;
  const Stopwatch watch;
  const auto delaunay =
      Delaunay3::build(geometry.solid.points, {.progress = progress, .threads = choices.threads});
  if (!delaunay) return delaunay.error();
  report.triangulate = watch.elapsed();
  report.peak_bytes = memory.peak();
  report.dimension = delaunay->dimension();
  report.duplicates = delaunay->duplicate_count();
  report.distinct_points = report.points - report.duplicates;
  report.hull_points = hull_vertices(*delaunay).size();
  if (choices.cells_hash && delaunay->dimension() == 3)
    report.cells_sha256 = cells_sha256(geometry.solid.points, delaunay_cells(*delaunay));
  geometry.solid.tets = real_tets(*delaunay);
  report.tets = geometry.solid.tets.size();
  return Ok{};
}

Status triangulate_any(const Choices& choices, const Progress& progress, Geometry& geometry,
                       Report& report) {
  if (geometry.dimension == 3) return triangulate_solid(choices, progress, geometry, report);
  const bool bare = geometry.mesh.segments.empty() && choices.holes == HoleRule::kNone;
  return bare ? triangulate_points(choices, progress, geometry, report)
              : triangulate_domain(choices, progress, geometry, report);
}

// ---- Output --------------------------------------------------------------------------------

// Segments outside the domain have no triangle beside them and are no part of a mesh. Where there
// are no triangles at all, they are all that is left.
void leave_out_loose_segments(const Report& report, Session& session, TriangleMesh& mesh) {
  const bool is_hull = report.triangles == report.hull_triangles;  // each edge has a triangle
  if (is_hull || mesh.triangles.empty() || session.options().output.empty()) return;
  const DirectedEdges edges(mesh.triangles);
  const std::size_t dropped =
      std::erase_if(mesh.segments, [&](const Segment& s) { return !edges.has_edge(s.a, s.b); });
  if (dropped > 0)
    session.note(concat({dropped, " segments lie outside the domain and are not written"}));
}

Status write_result(Session& session, const Geometry& geometry) {
  const CommonOptions& options = session.options();
  if (options.output.empty()) return Ok{};
  if (writes_triangle_files(options.output, options.format))
    return write_triangle_set(session.outputs(), options.output, geometry, EmptyFiles::kWrite);
  return write_geometry(session.outputs(), options.output, options.format, geometry);
}

template <class T>
void optional_field(JsonWriter& json, const char* name, const std::optional<T>& value) {
  json.key(name);
  if (value) {
    json.value(*value);
  } else {
    json.null();
  }
}

void time_field(JsonWriter& json, const char* name, const Report& report,
                double PhaseTime::*which) {
  json.key(name).begin_object().field("read", report.read.*which);
  json.field("triangulate", report.triangulate.*which).field("write", report.write.*which);
  json.end_object();
}

JsonWriter to_json(const Report& report) {
  JsonWriter json;
  json.begin_object().field("points", report.points);
  json.field("distinct_points", report.distinct_points).field("dimension", report.dimension);
  optional_field(json, "triangles", report.triangles);
  optional_field(json, "tets", report.tets);
  json.field("hull_points", report.hull_points).field("added_points", report.added_points);
  json.field("constrained_edges", report.constrained_edges);
  json.field("duplicates", report.duplicates);
  optional_field(json, "cells_sha256", report.cells_sha256);
  time_field(json, "seconds", report, &PhaseTime::wall);
  time_field(json, "cpu_seconds", report, &PhaseTime::cpu);
  json.field("peak_bytes", report.peak_bytes).end_object();
  return json;
}

std::string to_text(const Report& report) {
  std::string text = concat({report.points, " points"});
  if (report.duplicates > 0) append(text, {" (", report.duplicates, " duplicates)"});
  if (report.added_points > 0) append(text, {", ", report.added_points, " added"});
  append(text, {", dimension ", report.dimension});
  if (report.triangles) append(text, {", ", *report.triangles, " triangles"});
  if (report.tets) append(text, {", ", *report.tets, " tets"});
  append(text, {", ", report.hull_points, " hull points"});
  if (report.constrained_edges > 0)
    append(text, {", ", report.constrained_edges, " constrained edges"});
  return concat(
      {text, report.cells_sha256 ? concat({"\ncells ", *report.cells_sha256, "\n"}) : "\n"});
}

// Facets and segments are no constraints in space.
void leave_points_alone(const std::string& name, Session& session, Geometry& geometry) {
  if (!geometry.has_facets() && geometry.solid.segments.empty()) return;
  session.note(
      concat({name, ": in space the points alone are triangulated, without facets and segments"}));
  geometry.solid.facets.clear();
  geometry.solid.segments.clear();
  geometry.polygons.clear();
}

// Triangles and tetrahedra of the input, and what belongs to them, give way to new ones.
void leave_cells_alone(const std::string& name, Session& session, Geometry& geometry) {
  if (geometry.cell_attributes.columns > 0)
    session.note(concat({name, ": attributes of its elements are left out: there will be others"}));
  geometry.cell_attributes = {};
  geometry.mesh.triangles.clear();
  geometry.solid.tets.clear();
}

Result<int> run_triangulate(Arguments& arguments, Session& session) {
  const std::string& path = arguments.operands()[0];
  Report report;
  const Stopwatch reading;
  auto geometry = read_geometry(path, session.reading(Siblings::kIgnored));
  if (!geometry) return geometry.error();
  report.read = reading.elapsed();
  report.points = geometry->point_count();

  if (geometry->dimension == 3) leave_points_alone(display_name(path), session, *geometry);
  leave_cells_alone(display_name(path), session, *geometry);
  const Choices choices = read_choices(arguments, *geometry, session.options().threads);
  if (Status status = arguments.status(); !status) return status.error();
  if (Status status = triangulate_any(choices, session.progress(), *geometry, report); !status)
    return in_file(status.error(), path);

  const Stopwatch writing;
  leave_out_loose_segments(report, session, geometry->mesh);
  if (!session.options().output.empty())
    leave_out_filled_holes(display_name(path), choices.holes, session, *geometry);
  if (Status status = write_result(session, *geometry); !status) return status.error();
  report.write = writing.elapsed();
  if (Status status = session.write_json(to_json(report)); !status) return status.error();
  session.print(to_text(report));
  return kExitOk;
}

constexpr std::array kTriangulateOptions = {
    Option{"--holes", "RULE",
           "which regions belong to the domain: parity, seeds, none, outer "
           "(default: seeds if the file lists any, else parity)"},
    Option{"--intersections", "RULE", "crossing segments: split (default) or refuse"},
    Option{"--cells-hash", "", "compute the canonical SHA-256 of the Delaunay cells of the hull"},
};

}  // namespace

extern const Command kTriangulate;
const Command kTriangulate = {
    .name = "triangulate",
    .operands = "FILE",
    .summary = "(constrained) Delaunay triangulation in the plane, Delaunay in space",
    .least_operands = 1,
    .most_operands = 1,
    .options = kTriangulateOptions,
    .run = run_triangulate};

}  // namespace wellspaced::cli
