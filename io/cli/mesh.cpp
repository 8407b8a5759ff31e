// wellspaced mesh: well-spaced conforming meshes of domains.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/packing/background_size.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/hole_seeds.hpp"
#include "wellspaced/io/cli/mesh_size.hpp"
#include "wellspaced/io/cli/mesh_space.hpp"
#include "wellspaced/io/cli/packing_progress.hpp"
#include "wellspaced/io/cli/stopwatch.hpp"
#include "wellspaced/io/formats/column_file.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::array kMeshOptions = {
    Option{
        "--beta", "X",
        "balls have the radius lfs / X, at least 2 (default 2; in space more than 3, default 10)"},
    Option{"--size", "H|FILE",
           "nodes no further apart than about H; FILE: points with sizes as their attribute"},
    Option{"--angle", "DEG", "cut triangles with a smaller angle (0 to 34, default 25)"},
    Option{"--radius-edge", "RHO",
           "the same as a bound on circumradius / shortest edge; in space the least --beta that "
           "proves it (more than 2)"},
    Option{"--maximal", "delaunay|full",
           "until no circumcentre fits (default), or no point at all"},
    Option{"--max-points", "N", "stop there, with a valid mesh and exit code 5"},
    Option{"--allow-small-angles", "", "mesh domains with corners below 60 degrees, too"},
    Option{"--holes", "RULE",
           "which regions belong to the domain: parity, seeds, none, outer "
           "(default: seeds if the file lists any, else parity)"},
    Option{"--intersections", "RULE", "crossing segments: refuse (default) or split"},
    Option{"--flatness", "X",
           "in space: how far from planes and right angles counts as on them (default 1e-6)"},
    Option{"--report", "FILE.html", "in space: the mesh as a web page, to be turned and cut open"},
    Option{"--spacing", "FILE",
           "write the spacing function at the nodes, one value a line "
           "(default: beside Triangle's files, where audit finds it)"},
};

// ---- Options -------------------------------------------------------------------------------

constexpr double kMostMeshPoints = 1 << 28;

double smallest_angle(Arguments& arguments) {
  constexpr double kLargestAngle = 34;
  if (!arguments.has("--radius-edge"))
    return arguments.number("--angle", 25, between(0, kLargestAngle));
  if (arguments.has("--angle")) arguments.refuse("--radius-edge", "excludes --angle");
  const double rho = arguments.number("--radius-edge", 2, between(0.9, 1e6));
  return std::min(kLargestAngle, arccotangent_deg(std::sqrt(4 * rho * rho - 1)));
}

PackingOptions read_packing_options(Arguments& arguments, const Geometry& input) {
  constexpr std::array kRules = {HoleRule::kParity, HoleRule::kSeeds, HoleRule::kNone,
                                 HoleRule::kOuter};
  PackingOptions options;
  options.beta = arguments.number("--beta", options.beta, at_least(2));
  options.smallest_angle_deg = smallest_angle(arguments);
  options.maximality = maximality_of(arguments);
  options.max_points = static_cast<std::size_t>(
      arguments.integer("--max-points", 1 << 26, between(1, kMostMeshPoints)));
  if (arguments.has("--allow-small-angles")) options.sharp_corners = SharpCorners::kMesh;
  const std::size_t usual = input.mesh.segments.empty() ? 2 : input.holes.empty() ? 0 : 1;
  options.holes = kRules[arguments.choice("--holes", usual, {"parity", "seeds", "none", "outer"})];
  options.crossings = arguments.choice("--intersections", 0, {"refuse", "split"}) == 0
                          ? CrossingRule::kRefuse
                          : CrossingRule::kSplit;
  return options;
}

Status add_size(const Arguments& arguments, Session& session, PackingOptions& options) {
  const auto wanted = read_size(2, arguments, session);
  if (!wanted) return wanted.error();
  if (wanted->constant > 0) options.size = [size = wanted->constant](Point2) { return size; };
  if (wanted->sizes.empty()) return Ok{};
  auto size = BackgroundSize::build(wanted->background.mesh.points, wanted->sizes);
  if (!size) return in_file(size.error(), std::string(*arguments.value("--size")));
  options.size = std::move(*size);
  return Ok{};
}

// ---- Output --------------------------------------------------------------------------------

Geometry packed_geometry(const PackedMesh& packed, const Geometry& input) {
  Geometry geometry = to_geometry(packed.mesh, input.index_base);
  geometry.holes = input.holes;
  geometry.regions = input.regions;
  if (!packed.is_complete) geometry.remark = kIncompleteMesh;
  if (!packed.attributes.empty()) geometry.cell_attributes = {1, packed.attributes};
  return geometry;
}

Status write_mesh_files(const PackedMesh& packed, const Geometry& input,
                        const PackingOptions& options, const Arguments& arguments,
                        Session& session) {
  const CommonOptions& common = session.options();
  if (const auto path = spacing_file(arguments, common)) {
    const Progress progress = session.writing();
    ProgressParts parts(progress, "write", 1);
    const std::vector<double> spacing = packed_spacing(packed, options.beta, parts.part(0));
    if (parts.stopped()) return cancelled();
    const Status written = write_spacing(session.outputs(), *path, spacing, {false, options.beta});
    if (!written) return written.error();
  }
  if (common.output.empty()) return Ok{};
  Geometry geometry = packed_geometry(packed, input);
  leave_out_filled_holes(display_name(arguments.operands()[0]), options.holes, session, geometry);
  if (writes_triangle_files(common.output, common.format))
    return write_triangle_set(session.outputs(), common.output, geometry, EmptyFiles::kWrite);
  return write_geometry(session.outputs(), common.output, common.format, geometry);
}

double corner_angle(const Corner& corner, const std::vector<Point2>& points) {
  return arccotangent_deg(
      corner_cotangent(points[corner.apex], points[corner.right], points[corner.left]));
}

// Corners name points of the domain, which need not be nodes if crossings were split.
void corner_fields(JsonWriter& json, const PackedMesh& packed, const Geometry& input) {
  json.key("sharp_corners").begin_array();
  const std::size_t count = input.mesh.points.size();
  for (const Corner& corner : packed.sharp_corners) {
    if (std::max({corner.apex, corner.right, corner.left}) >= count) continue;
    json.begin_object().field("point", corner.apex + input.index_base);
    json.field("angle", corner_angle(corner, input.mesh.points)).end_object();
  }
  json.end_array();
}

void optional_angle(JsonWriter& json, const char* name, std::optional<double> angle) {
  json.key(name);
  if (angle) {
    json.value(*angle);
  } else {
    json.null();
  }
}

// See packing_progress(); measured.
double node_cost(const Arguments& arguments, const CommonOptions& common) {
  if (spacing_file(arguments, common)) return 3.5;
  return common.output.empty() ? 0.5 : 2;
}

struct MeshRun {
  PackingOptions options;
  PhaseTime read, mesh, write;
  std::uint64_t peak_bytes = 0;
};

JsonWriter mesh_json(const PackedMesh& packed, const Geometry& input, const MeshRun& run) {
  const AngleStatistics angles = angle_statistics(packed.mesh);
  JsonWriter json;
  json.begin_object().key("input").begin_object();
  json.field("points", input.mesh.points.size()).field("segments", input.mesh.segments.size());
  json.end_object().field("complete", packed.is_complete);
  json.field("nodes", packed.mesh.points.size());
  json.field("triangles", packed.mesh.triangles.size());
  json.field("boundary_edges", packed.mesh.segments.size());
  json.field("balls_packed", packed.balls_packed);
  json.field("beta", run.options.beta).field("smallest_angle", run.options.smallest_angle_deg);
  json.field("maximal", name_of(run.options.maximality));
  json.key("angles").begin_object();
  optional_angle(json, "interior_min", angles.interior_min_deg);
  optional_angle(json, "boundary_min", angles.boundary_min_deg);
  json.end_object();
  corner_fields(json, packed, input);
  json.key("without_guarantee").begin_array();
  for (const Index t : packed.without_guarantee) json.value(t + input.index_base);
  json.end_array().key("seconds").begin_object();
  json.field("read", run.read.wall).field("mesh", run.mesh.wall).field("write", run.write.wall);
  json.end_object().field("peak_bytes", run.peak_bytes).end_object();
  return json;
}

std::string mesh_text(const PackedMesh& packed) {
  std::string text = concat({packed.mesh.points.size(), " nodes, ", packed.mesh.triangles.size(),
                             " triangles, ", packed.mesh.segments.size(), " boundary edges\n"});
  if (!packed.without_guarantee.empty())
    append(text, {packed.without_guarantee.size(),
                  packed.without_guarantee.size() == 1 ? " triangle has" : " triangles have",
                  " an angle below the one wanted (--json lists them)\n"});
  return text;
}

Result<int> run_mesh(Arguments& arguments, Session& session) {
  const std::string& path = arguments.operands()[0];
  MeshRun run;
  const Stopwatch reading;
  const auto input = read_geometry(path, session.reading(Siblings::kIgnored));
  if (!input) return input.error();
  run.read = reading.elapsed();
  if (input->dimension == 3) return mesh_in_space(path, *input, run.read, arguments, session);
  for (const char* name : {"--flatness", "--report"})
    if (arguments.has(name)) arguments.refuse(name, "is for domains in space");
  run.options = read_packing_options(arguments, *input);
  if (Status status = arguments.status(); !status)
    return Error{ErrorCode::kUsage, {"mesh: ", status.error().message}};
  if (Status status = add_size(arguments, session, run.options); !status) return status.error();
  run.options.progress = packing_progress(session, node_cost(arguments, session.options()));

  const MemoryGauge memory;
  const Stopwatch meshing;
  const auto packed = pack_domain(to_pslg(*input), run.options);
  if (!packed) return in_file(packed.error(), path);
  run.mesh = meshing.elapsed();
  run.peak_bytes = memory.peak();
  if (packed->was_cancelled && session.stopped() == StopReason::kInterrupted) return cancelled();
  for (const std::string& note : packed->notes)
    session.note(concat({display_name(path), ": ", note}));

  const Stopwatch writing;
  const Status written = write_mesh_files(*packed, *input, run.options, arguments, session);
  if (!written) return written.error();
  run.write = writing.elapsed();
  if (Status status = session.write_json(mesh_json(*packed, *input, run)); !status)
    return status.error();
  session.print(mesh_text(*packed));
  if (packed->is_complete) return kExitOk;
  session.note("stopped before the end: the mesh is valid, but not as fine as asked for");
  return kExitLimit;
}

}  // namespace

extern const Command kMesh;
const Command kMesh = {
    .name = "mesh",
    .operands = "DOMAIN",
    .summary = "make a well-spaced conforming mesh of a domain, in the plane or in space",
    .least_operands = 1,
    .most_operands = 1,
    .options = kMeshOptions,
    .run = run_mesh};

}  // namespace wellspaced::cli
