// wellspaced coarsen: from one fine mesh to a sequence of ever coarser ones.
#include "wellspaced/algorithms/coarsening/coarsen.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/transfer/solver_levels.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/process.hpp"
#include "wellspaced/io/cli/stopwatch.hpp"
#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/hierarchy_files.hpp"
#include "wellspaced/io/report/level_table.hpp"
#include "wellspaced/io/report/report.hpp"
#include "wellspaced/io/report/selection_table.hpp"
#include "wellspaced/io/report/solver_table.hpp"
#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/graph.hpp"

namespace wellspaced::cli {
namespace {

enum class Profile { kThesis, kMultigrid, kQuality };
enum class Statistics { kNone, kBasic, kFull };

struct CoarsenRequest {
  CoarseningOptions options;  // what all methods share
  std::vector<CoarseningMethod> methods;
  std::optional<double> beta, factor;  // given ones; otherwise each method has its own
  std::optional<CoarseningScheme> scheme;
  std::optional<SpacingMetric> metric;
  Statistics statistics = Statistics::kBasic;
  bool multigrid = false;   // the profile
  bool for_solver = false;  // whether to prepare what a solver needs
  std::vector<const MatrixFormat*> matrices;
};

// Where the time of a sequence went, by level and phase. It listens to the progress of coarsen().
class PhaseClock {
 public:
  static constexpr std::array<std::string_view, 4> kPhases = {"spacing", "boundary", "select",
                                                              "triangulate"};
  using Seconds = std::array<double, kPhases.size()>;

  void enter(std::string_view phase) {
    const double now = wall_seconds();
    levels_.back()[phase_] += now - last_;
    last_ = now;
    const auto found = std::ranges::find(kPhases, phase);
    if (found == kPhases.end()) return;  // before the first level
    const auto entered = static_cast<std::size_t>(found - kPhases.begin());
    if (entered < phase_ || levels_.size() == 1) levels_.emplace_back();
    phase_ = entered;
  }
  void stop() { enter(kPhases[phase_]); }

  double total() const { return last_ - start_; }
  /// Level 0: what came before the first phase.
  Seconds level(std::size_t k) const { return k < levels_.size() ? levels_[k] : Seconds{}; }

 private:
  double start_ = wall_seconds(), last_ = start_;
  std::size_t phase_ = 0;
  std::vector<Seconds> levels_{1};
};

// One method's sequence and what was measured of it.
struct Run {
  CoarseningOptions options;
  Hierarchy hierarchy;
  std::vector<LevelStatistics> statistics;
  std::vector<SelectionCheck> selection;  // of levels 1 and up, by refinement
  std::optional<SolverHierarchy> solver;
  PhaseClock clock;
  std::uint64_t peak_bytes = 0;
};

// ---- The request

constexpr std::array kMethods = {CoarseningMethod::kFunction,  CoarseningMethod::kMis,
                                 CoarseningMethod::kThreshold, CoarseningMethod::kQuasiUniform,
                                 CoarseningMethod::kQuadtree,  CoarseningMethod::kRefinement};

// One method, or several separated by commas.
std::vector<CoarseningMethod> read_methods(Arguments& arguments, const std::string& otherwise) {
  const std::string text = arguments.text("--method", otherwise);
  std::vector<CoarseningMethod> methods;
  for (const std::string& name : words_of(text)) {
    const auto found = std::ranges::find(kMethods, name, [](auto m) { return name_of(m); });
    if (found != kMethods.end() && std::ranges::count(methods, *found) == 0) {
      methods.push_back(*found);
      continue;
    }
    arguments.refuse("--method",
                     in_quotes(text) +
                         " should be function, mis, threshold, quasi-uniform, quadtree or " +
                         "refinement, or several of them, each once, separated by commas");
    break;
  }
  return methods;
}

// The profile where none is named: that of solvers, unless a choice of the thesis' is made.
Profile read_profile(Arguments& arguments) {
  const bool chooses = std::ranges::any_of(
      std::array{"--method", "--scheme", "--metric", "--beta", "--factor", "--protect"},
      [&](const char* name) { return arguments.has(name); });
  const bool sizes =
      arguments.has("--targets") || arguments.has("--ratio") || arguments.has("--angle");
  const Profile otherwise = chooses ? Profile::kThesis
                            : sizes ? Profile::kQuality
                                    : Profile::kMultigrid;
  return static_cast<Profile>(arguments.choice("--profile", static_cast<int>(otherwise),
                                               {"thesis", "multigrid", "quality"}));
}

// Numbers of nodes separated by commas; none where none are given.
std::vector<std::size_t> read_targets(Arguments& arguments) {
  std::vector<std::size_t> targets;
  if (!arguments.has("--targets")) return targets;
  const std::string list = arguments.text("--targets", "");
  for (const std::string& word : words_of(list)) {
    const char* const end = word.data() + word.size();
    std::uint64_t nodes = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, nodes);
    if (error != std::errc() || stop != end) {
      arguments.refuse("--targets", in_quotes(list) + " should be numbers separated by commas");
      return {};
    }
    targets.push_back(nodes);
  }
  return targets;
}

std::vector<const MatrixFormat*> read_matrix_formats(Arguments& arguments,
                                                     const std::string& otherwise) {
  std::vector<const MatrixFormat*> formats;
  const std::string list = arguments.text("--transfers", otherwise);
  if (list == "none") return formats;
  for (const std::string& name : words_of(list)) {
    const MatrixFormat* format = find_matrix_format(name);
    if (format == nullptr) {
      arguments.refuse("--transfers", in_quotes(name) + " should be mtx, petsc, npz or none");
      return {};
    }
    if (std::ranges::find(formats, format) == formats.end()) formats.push_back(format);
  }
  return formats;
}

// No option may be given that says nothing to any of the methods.
void refuse_idle_options(Arguments& arguments, std::span<const CoarseningMethod> methods) {
  const auto refinements = std::ranges::count(methods, CoarseningMethod::kRefinement);
  if (refinements == std::ssize(methods))
    for (const char* name : {"--factor", "--protect", "--order"})
      if (arguments.has(name)) arguments.refuse(name, "is not for levels of --profile quality");
  if (refinements == 0)
    for (const char* name : {"--targets", "--ratio", "--angle"})
      if (arguments.has(name)) arguments.refuse(name, "is for levels of --profile quality alone");
}

CoarsenRequest read_request(Arguments& arguments, std::uint64_t seed) {
  CoarsenRequest request;
  const Profile profile = read_profile(arguments);
  request.multigrid = profile == Profile::kMultigrid;
  if (request.multigrid) request.options = multigrid_profile();
  request.matrices = read_matrix_formats(arguments, request.multigrid ? "npz" : "none");
  request.for_solver = request.multigrid || !request.matrices.empty();
  CoarseningOptions& options = request.options;
  if (arguments.has("--scheme"))
    request.scheme = static_cast<CoarseningScheme>(
        arguments.choice("--scheme", 0, {"fine-to-coarse", "from-finest", "coarse-to-fine"}));
  if (arguments.has("--metric"))
    request.metric = static_cast<SpacingMetric>(
        arguments.choice("--metric", 0, {"graph", "euclidean", "geodesic"}));
  options.order = static_cast<SelectionOrder>(
      arguments.choice("--order", request.multigrid ? 1 : 0, {"random", "priority"}));
  options.limit_by_boundary = arguments.has("--boundary-lfs");
  options.limit_by_special_points = arguments.has("--special-lfs");
  request.methods =
      read_methods(arguments, profile == Profile::kQuality ? "refinement" : "function");
  refuse_idle_options(arguments, request.methods);
  options.targets = read_targets(arguments);
  options.ratio = arguments.number("--ratio", options.ratio, more_than(1));
  options.angle_deg = arguments.number("--angle", options.angle_deg, between(0, 30));
  request.statistics =
      static_cast<Statistics>(arguments.choice("--stats", 1, {"none", "basic", "full"}));
  options.count_work = request.statistics == Statistics::kFull;
  if (arguments.has("--beta")) request.beta = arguments.number("--beta", 0, more_than(1));
  if (arguments.has("--factor")) request.factor = arguments.number("--factor", 0, more_than(1));
  if (arguments.has("--protect")) options.protect = arguments.number("--protect", 0, at_least(0));
  options.max_levels = static_cast<std::size_t>(
      arguments.integer("--levels", std::int64_t{1} << 40, between(0, 0x1p40)));
  options.until_nodes = static_cast<std::size_t>(arguments.integer(
      "--until", static_cast<std::int64_t>(options.until_nodes), between(0, 0x1p40)));
  if (arguments.has("--keep-boundary"))
    options.keep_boundary = arguments.number("--keep-boundary", 0, at_least(0));
  options.seed = seed;
  return request;
}

Result<std::vector<Index>> read_fixed_points(const std::string& path, std::size_t nodes) {
  const auto text = read_input(path);
  if (!text) return text.error();
  Scanner scanner(*text, display_name(path));
  std::vector<Index> fixed;
  while (scanner.next_line()) {
    while (scanner.ok() && scanner.more()) {
      const std::int64_t node = scanner.integer("fixed point");
      if (node < 0 || static_cast<std::uint64_t>(node) >= nodes)
        scanner.fail(ErrorCode::kInvalidGeometry,
                     "fixed point " + std::to_string(node) + " is out of range: the mesh has " +
                         std::to_string(nodes) + " nodes, numbered from 0");
      fixed.push_back(static_cast<Index>(node));
    }
  }
  if (!scanner.ok()) return scanner.error();
  return fixed;
}

Result<std::vector<double>> read_spacing(const std::string& path, std::size_t nodes) {
  const auto text = read_input(path);
  if (!text) return text.error();
  Scanner scanner(*text, display_name(path));
  std::vector<double> values;
  while (scanner.next_line() && values.size() < nodes)
    values.push_back(scanner.number("a spacing"));
  if (!scanner.ok()) return scanner.error();
  return values;
}

// ---- The run

LevelStatistics sizes_of(const TriangleMesh& mesh) {
  LevelStatistics sizes;
  sizes.nodes = mesh.points.size();
  sizes.triangles = mesh.triangles.size();
  sizes.boundary_edges = mesh.segments.size();
  return sizes;
}

std::vector<LevelStatistics> measure(const Hierarchy& hierarchy, Statistics detail,
                                     const Progress& progress) {
  if (detail == Statistics::kFull) return hierarchy_statistics(hierarchy, progress);
  std::vector<LevelStatistics> rows;
  for (const Level& level : hierarchy.levels)
    rows.push_back(detail == Statistics::kNone ? sizes_of(level.mesh)
                                               : mesh_statistics(level.mesh));
  return rows;
}

CoarseningOptions options_of(const CoarsenRequest& request, CoarseningMethod method) {
  const bool of_profile = request.multigrid && method == CoarseningMethod::kFunction;
  const CoarseningOptions usual = of_profile ? multigrid_profile() : theorem_options(method);
  CoarseningOptions options = request.options;
  options.method = method;
  options.beta = request.beta.value_or(usual.beta);
  options.factor = request.factor.value_or(usual.factor);
  options.scheme = request.scheme.value_or(usual.scheme);
  options.metric = request.metric.value_or(usual.metric);
  if (method != CoarseningMethod::kRefinement) options.targets.clear();
  return options;
}

std::vector<SelectionCheck> check_selections(const Hierarchy& hierarchy, double beta) {
  const Graph graph = mesh_graph(hierarchy.levels[0].mesh);
  std::vector<SelectionCheck> checks;
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k)
    checks.push_back(check_selection(graph, hierarchy.levels[k], beta));
  return checks;
}

// Of the level that has drifted most, if one has by more than 2% of its area.
void warn_of_drift(const SolverHierarchy& solver, Session& session) {
  constexpr double kMuch = 0.02;
  double most = kMuch;
  std::size_t worst = 0;
  for (std::size_t k = 1; k < solver.levels.size(); ++k) {
    const double drift = std::fabs(solver.levels[k].area_kept - 1);
    if (drift <= most) continue;
    most = drift;
    worst = k;
  }
  if (worst == 0) return;
  session.note("the domain of level " + std::to_string(worst) + " has " +
               decimal(100 * solver.levels[worst].area_kept, 1) +
               "% of its area; --keep-boundary 0.02 keeps it within 2%");
}

// Of the levels that have too few nodes for the angles sought.
void warn_of_angles(const Run& run, Session& session) {
  const std::size_t needed = run.hierarchy.nodes_for_angles;
  if (run.hierarchy.levels.back().mesh.points.size() >= needed) return;
  session.note("levels of fewer than about " + std::to_string(needed) +
               " nodes cannot keep angles of " + shortest(run.options.angle_deg) +
               " degrees on this mesh: its special points ask for so many");
}

// Where that is cut short, what there is of it is dropped, and the run is incomplete.
Status prepare_for_solver(Session& session, Run& run) {
  auto solver = wellspaced::prepare_for_solver(run.hierarchy, session.progress());
  run.hierarchy.complete = solver.ok();
  if (!solver && solver.error().code != ErrorCode::kCancelled) return solver.error();
  if (!solver) return Ok{};
  run.solver = std::move(*solver);
  warn_of_drift(*run.solver, session);
  return Ok{};
}

Result<Run> run_method(const TriangleMesh& mesh, const CoarsenRequest& request,
                       CoarseningMethod method, Session& session) {
  Run run;
  run.options = options_of(request, method);
  reset_peak_resident();
  const std::uint64_t before = resident_bytes();
  run.clock = PhaseClock();
  run.options.progress = [&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    run.clock.enter(phase);
    return session.progress()(phase, done, total);
  };
  auto hierarchy = coarsen(mesh, run.options);
  run.clock.stop();
  const std::uint64_t peak = peak_resident_bytes();
  run.peak_bytes = peak > before ? peak - before : 0;
  run.options.progress = {};
  if (!hierarchy) return hierarchy.error();
  run.hierarchy = std::move(*hierarchy);
  warn_of_angles(run, session);
  // At a limit there is no time left but for the levels themselves.
  const Statistics detail = run.hierarchy.complete ? request.statistics : Statistics::kNone;
  run.statistics = measure(run.hierarchy, detail, session.progress());
  if (method == CoarseningMethod::kRefinement && detail != Statistics::kNone)
    run.selection = check_selections(run.hierarchy, run.options.beta);
  if (request.for_solver && run.hierarchy.complete)
    if (Status status = prepare_for_solver(session, run); !status) return status.error();
  return run;
}

// ---- What is said about it

std::string title(const Run& run) {
  const CoarseningOptions& options = run.options;
  if (options.method == CoarseningMethod::kRefinement)
    return "refinement: angle " + shortest(options.angle_deg) + ", beta " + shortest(options.beta) +
           ", seed " + std::to_string(options.seed);
  const bool mis = options.method == CoarseningMethod::kMis;
  std::string text = mis ? "MIS" : std::string(name_of(options.method));
  if (mis || options.method == CoarseningMethod::kFunction) text += "-based";
  if (options.scheme != CoarseningScheme::kFineToCoarse)
    text.append(", ").append(name_of(options.scheme));
  if (options.metric != SpacingMetric::kGraph)
    text.append(", ").append(name_of(options.metric)).append(" metric");
  text += ": ";
  if (!mis) text += "beta " + shortest(options.beta) + ", C " + shortest(options.factor) + ", ";
  return text + "R " + shortest(protection_ratio(options)) + ", seed " +
         std::to_string(options.seed);
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

void write_level(JsonWriter& json, const Run& run, std::size_t k) {
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

void write_run(JsonWriter& json, const Run& run) {
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

// One method: its object. Several: an object with a list of theirs.
Status write_summary(std::span<const Run> runs, Session& session) {
  JsonWriter json;
  if (runs.size() == 1) {
    write_run(json, runs[0]);
  } else {
    json.begin_object().key("runs").begin_array();
    for (const Run& run : runs) write_run(json, run);
    json.end_array().end_object();
  }
  return session.write_json(json);
}

Status write_files(std::span<const Run> runs, const HierarchyFormat& common, Session& session) {
  if (session.options().output.empty()) return Ok{};
  HierarchyFormat format = common;
  if (!session.options().format.empty()) format.format = session.options().format;
  for (const Run& run : runs) {
    format.solver = run.solver ? &*run.solver : nullptr;
    std::string directory = session.options().output;
    if (runs.size() > 1) directory.append("/").append(name_of(run.options.method));
    const Status written =
        write_hierarchy(session.outputs(), directory, run.hierarchy, run.options, format);
    if (!written) return written;
  }
  return Ok{};
}

void print_tables(std::span<const Run> runs, Session& session) {
  std::vector<LevelTable> tables;
  for (const Run& run : runs) tables.push_back({title(run), run.statistics});
  session.print(level_tables(tables));
  for (const Run& run : runs) {
    if (run.solver) session.print(solver_table(*run.solver));
    if (!run.selection.empty()) session.print(selection_table(run.selection));
  }
}

ReportMethod report_method(const Run& run) {
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

Status write_report(const std::string& path, const std::string& input, std::span<const Run> runs,
                    Session& session) {
  const std::string name = std::filesystem::path(display_name(input)).filename().string();
  const LevelStatistics& finest = runs[0].statistics[0];
  HtmlReport report{.title = "Coarsening of " + name,
                    .parameters = {{"file", name},
                                   {"nodes", std::to_string(finest.nodes)},
                                   {"triangles", std::to_string(finest.triangles)},
                                   {"boundary edges", std::to_string(finest.boundary_edges)}},
                    .methods = {}};
  for (const Run& run : runs) report.methods.push_back(report_method(run));
  return session.outputs().add(path, [&](TextWriter& out) { out << report_html(report); });
}

Result<int> run_coarsen(Arguments& arguments, Session& session) {
  CoarsenRequest request = read_request(arguments, session.options().seed);
  if (Status status = arguments.status(); !status)
    return Error{ErrorCode::kUsage, "coarsen: " + status.error().message, {}};
  if (session.options().output == "-")
    return Error{ErrorCode::kUsage, "coarsen: -o names a directory, not the standard output", {}};
  const Stopwatch reading;
  const auto geometry = read_mesh(arguments.operands()[0], session.reading());
  if (!geometry) return geometry.error();
  if (!session.options().output.empty())  // to write the levels takes about as long
    session.leave_time_to_write(reading.elapsed().wall);
  for (const std::string& note : geometry->notes) session.note(note);
  if (const auto path = arguments.value("--fixed")) {
    auto fixed = read_fixed_points(*path, geometry->mesh.points.size());
    if (!fixed) return fixed.error();
    request.options.fixed = std::move(*fixed);
  }
  if (const auto path = arguments.value("--spacing")) {
    auto spacing = read_spacing(*path, geometry->mesh.points.size());
    if (!spacing) return spacing.error();
    request.options.spacing = std::move(*spacing);
  }

  std::vector<Run> runs;
  for (const CoarseningMethod method : request.methods) {
    auto result = run_method(geometry->mesh, request, method, session);
    if (!result) return result.error();
    runs.push_back(std::move(*result));
  }
  print_tables(runs, session);
  const HierarchyFormat format{.index_base = geometry->index_base, .matrices = request.matrices};
  if (Status status = write_files(runs, format, session); !status) return status.error();
  if (const auto path = arguments.value("--report"))
    if (Status status = write_report(*path, arguments.operands()[0], runs, session); !status)
      return status.error();
  if (Status status = write_summary(runs, session); !status) return status.error();
  const bool complete =
      std::ranges::all_of(runs, [](const Run& r) { return r.hierarchy.complete; });
  if (complete) return kExitOk;
  session.note("stopped before the end: the levels finished by then are marked incomplete");
  return kExitLimit;
}

constexpr std::array kCoarsenOptions = {
    Option{
        "--profile", "NAME",
        "where what is not given comes from: multigrid: beta 4, C 2, down to 600 nodes "
        "(default); thesis: beta 25, C 8 (default if a method, scheme, metric, beta, factor or R "
        "is given); quality: levels of given sizes that keep their angles"},
    Option{"--targets", "N1,N2,...", "profile quality: the nodes of the levels after the input"},
    Option{"--ratio", "X", "profile quality: nodes from level to level (3), if no --targets"},
    Option{"--angle", "DEG", "profile quality: the smallest angle sought, up to 30 (22)"},
    Option{"--method", "NAME,...",
           "function (default), mis, threshold, quasi-uniform, quadtree, refinement (that of the "
           "profile quality); several: side by side"},
    Option{"--scheme", "NAME",
           "fine-to-coarse: each level out of the one before (default); from-finest: out of the "
           "input; coarse-to-fine: out of the input, nested"},
    Option{"--metric", "NAME",
           "distances: graph (along edges), euclidean, geodesic (inside the domain)"},
    Option{"--beta", "X",
           "spacing constant, more than 1 (25; threshold: 16, quasi-uniform and quadtree: 2)"},
    Option{"--factor", "X",
           "growth of the spacing from level to level, more than 1 (8; threshold: 24, "
           "quasi-uniform: 3, quadtree: 2, the next power of 2 is taken)"},
    Option{"--protect", "R", "distance that nodes keep from boundary edges (0.2; mis: 0.15)"},
    Option{"--order", "NAME",
           "of nodes within a level: random, by --seed; priority: largest spacing first (default "
           "of the profile multigrid)"},
    Option{"--boundary-lfs", "", "keep the boundary: spacing at most its local feature size"},
    Option{"--special-lfs", "", "space nodes near special points as these are spaced: angles stay"},
    Option{"--spacing", "FILE", "the spacing of the input, one value a node; then it is coarsened"},
    Option{"--fixed", "FILE", "0-based numbers of the nodes to keep in all levels"},
    Option{"--levels", "K", "at most K levels beside the input"},
    Option{"--until", "NODES", "no further level once one has at most NODES nodes"},
    Option{"--keep-boundary", "DRIFT",
           "keep the area of each level within this part of the finest's, e.g. 0.02"},
    Option{"--transfers", "LIST",
           "matrices from each level to the finer one: mtx, petsc, npz or none (default npz "
           "with the profile multigrid, else none)"},
    Option{"--report", "FILE.html", "pictures, charts and tables of the levels as one web page"},
    Option{"--stats", "none|basic|full", "what to measure (default basic: counts and angles)"},
};

}  // namespace

extern const Command kCoarsen;
const Command kCoarsen = {
    .name = "coarsen",
    .operands = "MESH",
    .summary = "coarsen a mesh into a sequence of ever coarser, nested meshes",
    .least_operands = 1,
    .most_operands = 1,
    .options = kCoarsenOptions,
    .run = run_coarsen};

}  // namespace wellspaced::cli
