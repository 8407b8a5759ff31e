#include "wellspaced/io/cli/mesh_space.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/tet_shape.hpp"
#include "wellspaced/algorithms/packing/space/background_size3.hpp"
#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/mesh_size.hpp"
#include "wellspaced/io/cli/packing_progress.hpp"
#include "wellspaced/io/formats/column_file.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/io/report/solid_report.hpp"
#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

// ---- Options -------------------------------------------------------------------------------

double beta_of(Arguments& arguments) {
  constexpr double kMostBeta = 1000;
  if (!arguments.has("--radius-edge"))
    return arguments.number("--beta", PackingOptions3{}.beta, {3, kMostBeta, false});
  if (arguments.has("--beta")) arguments.refuse("--radius-edge", "excludes --beta");
  const double rho = arguments.number("--radius-edge", 3, more_than(2));
  return beta_for_radius_edge(rho).value_or(kMostBeta);
}

PackingOptions3 read_options(Arguments& arguments) {
  constexpr double kMostPoints = 1 << 28, kLargestFlatness = 0.001;
  for (const char* name : {"--angle", "--allow-small-angles", "--holes", "--intersections"})
    if (arguments.has(name)) arguments.refuse(name, "is for domains in the plane");
  PackingOptions3 options;
  options.beta = beta_of(arguments);
  options.maximality = maximality_of(arguments);
  options.flatness = arguments.number("--flatness", options.flatness, between(0, kLargestFlatness));
  options.max_points =
      static_cast<std::size_t>(arguments.integer("--max-points", 1 << 26, between(1, kMostPoints)));
  return options;
}

// Sizes of a file are lowered as far as the guarantee wants it; where they do not cover the domain
// there is none.
Status add_size_in_space(const Arguments& arguments, const Geometry& domain, Session& session,
                         PackingOptions3& options) {
  const auto wanted = read_size(3, arguments, session);
  if (!wanted) return wanted.error();
  if (wanted->constant > 0) {
    options.size = [size = wanted->constant](Point3) { return size; };
    options.size_slope = 0;
  }
  if (wanted->sizes.empty()) return Ok{};
  auto size =
      BackgroundSize3::build(wanted->background.solid.points, wanted->sizes, 2 / options.beta);
  if (!size) return in_file(size.error(), std::string(*arguments.value("--size")));
  const auto covers = [&](Point3 p) { return size->covers(p); };
  const std::vector<Point3>& points = domain.solid.points;
  if (std::all_of(points.begin(), points.end(), covers)) options.size_slope = size->steepest();
  options.size = std::move(*size);
  return Ok{};
}

// ---- What came out -------------------------------------------------------------------------

struct ShapeSummary {
  double radius_edge = 0;      // the worst
  std::vector<Index> slivers;  // tets
};

ShapeSummary shape_summary(const TetMesh& mesh) {
  ShapeSummary summary;
  for (Index t = 0; t < mesh.tets.size(); ++t) {
    std::array<Point3, 4> corners;
    for (unsigned i = 0; i < 4; ++i) corners[i] = mesh.points[mesh.tets[t][i]];
    summary.radius_edge = std::max(summary.radius_edge, audit::tet_shape(corners).radius_edge);
    if (audit::classify_tet(corners) == audit::TetClass::kSliver) summary.slivers.push_back(t);
  }
  return summary;
}

// Where the input has no markers, facets and segments get the numbers that trace them: a facet that
// in the input, a segment that in the list of the domain's edges.
void number_unmarked(PackedTets& packed) {
  TetMesh& mesh = packed.mesh;
  const auto is_marked = [](const auto& item) { return item.marker != 0; };
  if (std::none_of(mesh.facets.begin(), mesh.facets.end(), is_marked))
    for (std::size_t k = 0; k < mesh.facets.size(); ++k)
      mesh.facets[k].marker = static_cast<int>(packed.facet_of[k] + 1);
  if (std::none_of(mesh.segments.begin(), mesh.segments.end(), is_marked))
    for (std::size_t k = 0; k < mesh.segments.size(); ++k)
      mesh.segments[k].marker = static_cast<int>(packed.segment_of[k] + 1);
}

Geometry packed_solid(PackedTets& packed, const Geometry& input) {
  number_unmarked(packed);
  Geometry geometry = to_geometry(packed.mesh, input.index_base);
  if (!packed.is_complete) geometry.remark = kIncompleteMesh;
  if (input.volume_regions.empty()) return geometry;
  geometry.cell_attributes.columns = 1;
  for (const Index region : packed.region_of)
    geometry.cell_attributes.values.push_back(
        region == kNoIndex ? 0 : input.volume_regions[region].attribute);
  return geometry;
}

}  // namespace

Maximality maximality_of(Arguments& arguments) {
  constexpr std::array kChoices = {Maximality::kDelaunay, Maximality::kFull};
  return kChoices[arguments.choice("--maximal", 0, {"delaunay", "full"})];
}

const char* name_of(Maximality maximality) {
  return maximality == Maximality::kFull ? "full" : "delaunay";
}

std::optional<std::string> spacing_file(const Arguments& arguments, const CommonOptions& common) {
  if (const auto path = arguments.value("--spacing")) return std::string(*path);
  const bool is_set = !common.output.empty() && common.output != "-" &&
                      writes_triangle_files(common.output, common.format);
  return is_set ? std::optional(spacing_beside(common.output)) : std::nullopt;
}

namespace {

// A domain, and the mesh that was made of it.
struct SpaceRun {
  const std::string& path;
  const Geometry& input;
  PackingOptions3 options = {};
  PackedTets packed = {};
  ShapeSummary shape = {};
  PhaseTime read = {}, mesh = {}, write = {};
  std::uint64_t peak_bytes = 0;
};

Status write_files(SpaceRun& run, const Arguments& arguments, Session& session) {
  const CommonOptions& common = session.options();
  if (const auto path = spacing_file(arguments, common)) {
    std::vector<double> spacing = run.packed.radius;
    for (double& value : spacing) value *= run.options.beta;
    const Status written = write_spacing(session.outputs(), *path, spacing,
                                         {!arguments.has("--size"), run.options.beta});
    if (!written) return written.error();
  }
  if (common.output.empty()) return Ok{};
  const Geometry geometry = packed_solid(run.packed, run.input);
  if (writes_triangle_files(common.output, common.format))
    return write_triangle_set(session.outputs(), common.output, geometry, EmptyFiles::kWrite);
  return write_geometry(session.outputs(), common.output, common.format, geometry);
}

void input_fields(JsonWriter& json, const Geometry& input) {
  json.key("input").begin_object();
  json.field("points", input.solid.points.size());
  json.field("facets", input.polygons.size() + input.solid.facets.size());
  json.field("segments", input.solid.segments.size()).end_object();
}

void radius_edge_field(JsonWriter& json, double beta, double worst) {
  json.key("radius_edge").begin_object().field("max", worst).key("bound");
  if (const auto bound = radius_edge_bound(beta)) {
    json.value(*bound);
  } else {
    json.null();
  }
  json.end_object();
}

JsonWriter space_json(const SpaceRun& run) {
  const PackedTets& packed = run.packed;
  const Index base = run.input.index_base;
  JsonWriter json;
  json.begin_object();
  input_fields(json, run.input);
  json.field("complete", packed.is_complete);
  json.field("nodes", packed.mesh.points.size()).field("tets", packed.mesh.tets.size());
  json.field("boundary_faces", packed.mesh.facets.size());
  json.field("boundary_edges", packed.mesh.segments.size());
  json.field("segment_points", packed.segment_points);
  json.field("facet_points", packed.facet_points).field("balls_packed", packed.balls_packed);
  json.field("maximal", name_of(run.options.maximality)).field("beta", run.options.beta);
  radius_edge_field(json, run.options.beta, run.shape.radius_edge);
  json.field("nodes_by_integral", nodes_by_integral(packed)).key("slivers").begin_array();
  for (const Index t : run.shape.slivers) json.value(t + base);
  json.end_array().key("edges").begin_array();
  for (const Segment& s : packed.domain_segments)
    json.begin_array().value(s.a + base).value(s.b + base).end_array();
  json.end_array().key("seconds").begin_object();
  json.field("read", run.read.wall).field("mesh", run.mesh.wall).field("write", run.write.wall);
  json.end_object().field("peak_bytes", run.peak_bytes).end_object();
  return json;
}

std::string space_text(const SpaceRun& run) {
  const TetMesh& mesh = run.packed.mesh;
  const ShapeSummary& shape = run.shape;
  std::string text = concat({mesh.points.size(), " nodes, ", mesh.tets.size(), " tets, ",
                             mesh.facets.size(), " boundary faces\n",
                             "circumradius / shortest edge at most ", decimal(shape.radius_edge)});
  if (const auto bound = radius_edge_bound(run.options.beta))
    append(text, {" (proven: ", decimal(*bound), ")"});
  text += '\n';
  if (!shape.slivers.empty())
    append(text, {shape.slivers.size(),
                  " tets are slivers, which such a bound permits (--json lists them)\n"});
  return text;
}

Status write_solid_report(const std::string& path, const SpaceRun& run, Session& session) {
  const PackedTets& packed = run.packed;
  const std::string name = std::filesystem::path(display_name(run.path)).filename().string();
  const auto bound = radius_edge_bound(run.options.beta);
  const SolidReport report{
      .title = concat({"Mesh of ", name}),
      .parameters = {{"domain", name},
                     {"nodes", std::to_string(packed.mesh.points.size())},
                     {"tets", std::to_string(packed.mesh.tets.size())},
                     {"boundary faces", std::to_string(packed.mesh.facets.size())},
                     {"largest circumradius / shortest edge", decimal(run.shape.radius_edge)},
                     {"proven bound of it", bound ? decimal(*bound) : "none"},
                     {"slivers", std::to_string(run.shape.slivers.size())},
                     {"beta", shortest(run.options.beta)},
                     {"maximal", name_of(run.options.maximality)},
                     {"complete", packed.is_complete ? "yes" : "no"}},
      .mesh = &packed.mesh};
  return session.outputs().add(path, [&](TextWriter& out) { out << solid_report_html(report); });
}

// Measures the time and memory of making the mesh, too.
Status make_mesh(SpaceRun& run, Session& session) {
  const MemoryGauge memory;
  const Stopwatch meshing;
  auto packed = pack_domain3(to_pls(run.input), run.options);
  if (!packed) return in_file(packed.error(), run.path);
  run.packed = std::move(*packed);
  run.mesh = meshing.elapsed();
  run.peak_bytes = memory.peak();
  if (run.packed.was_cancelled && session.stopped() == StopReason::kInterrupted) return cancelled();
  for (const std::string& note : run.packed.notes)
    session.note(concat({display_name(run.path), ": ", note}));
  return Ok{};
}

}  // namespace

Result<int> mesh_in_space(const std::string& path, const Geometry& input, PhaseTime reading,
                          Arguments& arguments, Session& session) {
  SpaceRun run{.path = path, .input = input, .options = read_options(arguments), .read = reading};
  if (Status status = arguments.status(); !status)
    return Error{ErrorCode::kUsage, {"mesh: ", status.error().message}};
  if (Status status = add_size_in_space(arguments, input, session, run.options); !status)
    return status.error();
  constexpr double kJudged = 5, kWritten = 9;  // measured
  run.options.progress =
      packing_progress(session, session.options().output.empty() ? kJudged : kWritten);
  if (Status status = make_mesh(run, session); !status) return status.error();

  const Stopwatch writing;
  if (Status status = write_files(run, arguments, session); !status) return status.error();
  run.write = writing.elapsed();
  run.shape = shape_summary(run.packed.mesh);
  if (const auto report = arguments.value("--report"))
    if (Status status = write_solid_report(*report, run, session); !status) return status.error();
  if (Status status = session.write_json(space_json(run)); !status) return status.error();
  session.print(space_text(run));
  if (run.packed.is_complete) return kExitOk;
  session.note("stopped before the end: the mesh conforms, but is not as fine as asked for");
  return kExitLimit;
}

}  // namespace wellspaced::cli
