#include "wellspaced/io/cli/coarsen_run.hpp"

#include <filesystem>

#include "wellspaced/io/formats/hierarchy_files.hpp"
#include "wellspaced/io/report/level_table.hpp"
#include "wellspaced/io/report/report.hpp"
#include "wellspaced/io/report/selection_table.hpp"
#include "wellspaced/io/report/solver_table.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

std::string title(const CoarsenRun& run) {
  const CoarseningOptions& options = run.options;
  if (options.method == CoarseningMethod::kRefinement)
    return concat({"refinement: angle ", options.angle_deg, ", beta ", options.beta, ", seed ",
                   options.seed});
  const bool mis = options.method == CoarseningMethod::kMis;
  std::string text = mis ? "MIS" : std::string(name_of(options.method));
  if (mis || options.method == CoarseningMethod::kFunction) text += "-based";
  if (options.scheme != CoarseningScheme::kFineToCoarse)
    text.append(", ").append(name_of(options.scheme));
  if (options.metric != SpacingMetric::kGraph)
    text.append(", ").append(name_of(options.metric)).append(" metric");
  text += ": ";
  if (!mis) append(text, {"beta ", options.beta, ", C ", options.factor, ", "});
  return concat({text, "R ", protection_ratio(options), ", seed ", options.seed});
}

void write_optional(JsonWriter& json, std::string_view name, const std::optional<double>& value) {
  json.key(name);
  value ? json.value(*value) : json.null();
}

void write_optional(JsonWriter& json, std::string_view name,
                    const std::optional<MeanAndMax>& value) {
  json.key(name);
  if (!value) {
    json.null();
    return;
  }
  json.begin_object().field("mean", value->mean).field("max", value->max).end_object();
}

// Counts are null where nothing was measured.
void write_count(JsonWriter& json, std::string_view name, bool measured, std::size_t count) {
  json.key(name);
  measured ? json.value(count) : json.null();
}

void write_angles(JsonWriter& json, const AngleStatistics& angles) {
  const bool measured = angles.max_deg.has_value();
  json.key("angles").begin_object();
  write_optional(json, "interior_min", angles.interior_min_deg);
  write_optional(json, "boundary_min", angles.boundary_min_deg);
  write_optional(json, "max", angles.max_deg);
  write_count(json, "interior_le_10", measured, angles.interior_le_10);
  write_count(json, "boundary_le_10", measured, angles.boundary_le_10);
  json.end_object();
}

void write_seconds(JsonWriter& json, const PhaseClock::Seconds& seconds) {
  json.key("seconds").begin_object();
  double total = 0;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    json.field(PhaseClock::kPhases[i], seconds[i]);
    total += seconds[i];
  }
  json.field("total", total).end_object();
}

// Whether every node of level k is a node of the level before, in its place.
bool is_node_nested(const Hierarchy& hierarchy, std::size_t k) {
  if (k == 0) return true;
  const std::vector<Point2>& finer = hierarchy.levels[k - 1].mesh.points;
  const Level& level = hierarchy.levels[k];
  for (std::size_t v = 0; v < level.parent.size(); ++v)
    if (level.parent[v] >= finer.size() || finer[level.parent[v]] != level.mesh.points[v])
      return false;
  return level.parent.size() == level.mesh.points.size();
}

void write_selection(JsonWriter& json, const SelectionCheck& check) {
  json.key("selection").begin_object();
  json.field("conflicts", check.conflicts).field("conflict_max", check.conflict_max);
  json.field("uncovered", check.uncovered).field("uncovered_max", check.uncovered_max);
  json.end_object();
}

void write_level(JsonWriter& json, const CoarsenRun& run, std::size_t k) {
  const LevelStatistics& statistics = run.statistics[k];
  const Level& level = run.hierarchy.levels[k];
  json.begin_object().field("level", k).field("nodes", statistics.nodes);
  json.field("triangles", statistics.triangles);
  json.field("boundary_edges", statistics.boundary_edges);
  write_angles(json, statistics.angles);
  write_optional(json, "intersection", statistics.intersection);
  write_optional(json, "path_depth", statistics.path_depth);
  write_optional(json, "search", statistics.search);
  write_optional(json, "edge_search", statistics.edge_search);
  json.field("node_nested", is_node_nested(run.hierarchy, k));
  json.field("reinstated", level.reinstated).field("dropped_outside", level.dropped_outside);
  if (run.solver) {
    json.key("solver").begin_object();
    describe_solver_level(json, run.solver->levels[k]);
    json.end_object();
  }
  if (k > 0 && k <= run.selection.size()) write_selection(json, run.selection[k - 1]);
  write_seconds(json, run.clock.level(level.step));
  json.end_object();
}

void write_run(JsonWriter& json, const CoarsenRun& run) {
  const TriangleMesh& input = run.hierarchy.levels[0].mesh;
  json.begin_object().key("input").begin_object();
  json.field("nodes", input.points.size()).field("triangles", input.triangles.size()).end_object();
  describe_coarsening(json, run.options);
  json.field("complete", run.hierarchy.complete).key("levels").begin_array();
  for (std::size_t k = 0; k < run.hierarchy.levels.size(); ++k) write_level(json, run, k);
  json.end_array();
  if (run.solver) {
    json.field("grid_complexity", run.solver->grid_complexity);
    json.field("operator_complexity", run.solver->operator_complexity);
  }
  json.field("seconds_total", run.clock.total());
  json.field("peak_bytes", run.peak_bytes).end_object();
}

ReportMethod report_method(const CoarsenRun& run) {
  ReportMethod method{std::string(name_of(run.options.method)), {}, {}};
  if (run.options.method != CoarseningMethod::kMis)
    method.parameters = {{"spacing constant β", shortest(run.options.beta)},
                         {"growth factor C", shortest(run.options.factor)}};
  method.parameters.emplace_back("edge protection R", shortest(protection_ratio(run.options)));
  method.parameters.emplace_back("seed", std::to_string(run.options.seed));
  for (std::size_t k = 0; k < run.hierarchy.levels.size(); ++k) {
    const Level& level = run.hierarchy.levels[k];
    method.levels.push_back({&level.mesh, level.origin, run.statistics[k]});
  }
  return method;
}

}  // namespace

void print_tables(std::span<const CoarsenRun> runs, Session& session) {
  std::vector<LevelTable> tables;
  for (const CoarsenRun& run : runs) tables.push_back({title(run), run.statistics});
  session.print(level_tables(tables));
  for (const CoarsenRun& run : runs) {
    if (run.solver) session.print(solver_table(*run.solver));
    if (!run.selection.empty()) session.print(selection_table(run.selection));
  }
}

Status write_run_summary(std::span<const CoarsenRun> runs, Session& session) {
  JsonWriter json;
  if (runs.size() == 1) {
    write_run(json, runs[0]);
  } else {
    json.begin_object().key("runs").begin_array();
    for (const CoarsenRun& run : runs) write_run(json, run);
    json.end_array().end_object();
  }
  return session.write_json(json);
}

Status write_report(const std::string& path, const std::string& input,
                    std::span<const CoarsenRun> runs, Session& session) {
  const std::string name = std::filesystem::path(display_name(input)).filename().string();
  const LevelStatistics& finest = runs[0].statistics[0];
  HtmlReport report{.title = concat({"Coarsening of ", name}),
                    .parameters = {{"file", name},
                                   {"nodes", std::to_string(finest.nodes)},
                                   {"triangles", std::to_string(finest.triangles)},
                                   {"boundary edges", std::to_string(finest.boundary_edges)}},
                    .methods = {}};
  for (const CoarsenRun& run : runs) report.methods.push_back(report_method(run));
  return session.outputs().add(path, [&](TextWriter& out) { out << report_html(report); });
}

}  // namespace wellspaced::cli
