// wellspaced coarsen: from one fine mesh to a sequence of ever coarser ones.
#include "wellspaced/algorithms/coarsening/coarsen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/io/cli/coarsen_request.hpp"
#include "wellspaced/io/cli/coarsen_run.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/cli/stopwatch.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/hierarchy_files.hpp"
#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/memory.hpp"

namespace wellspaced::cli {
namespace {

LevelStatistics sizes_of(const TriangleMesh& mesh) {
  LevelStatistics sizes;
  sizes.nodes = mesh.points.size();
  sizes.triangles = mesh.triangles.size();
  sizes.boundary_edges = mesh.segments.size();
  return sizes;
}

std::vector<LevelStatistics> measure(const Hierarchy& hierarchy, StatisticsDetail detail,
                                     const Progress& progress) {
  if (detail == StatisticsDetail::kFull) return hierarchy_statistics(hierarchy, progress);
  std::vector<LevelStatistics> rows;
  for (const Level& level : hierarchy.levels)
    rows.push_back(detail == StatisticsDetail::kNone ? sizes_of(level.mesh)
                                                     : mesh_statistics(level.mesh));
  return rows;
}

// Nothing where that is cut short.
std::vector<SelectionCheck> check_selections(const Hierarchy& hierarchy, double beta,
                                             const Progress& progress) {
  const Graph graph = mesh_graph(hierarchy.levels[0].mesh);
  std::vector<SelectionCheck> checks;
  ProgressParts parts(progress, "measure", hierarchy.levels.size());
  for (std::size_t k = 1; k < hierarchy.levels.size() && parts.go_on(k); ++k)
    checks.push_back(check_selection(graph, hierarchy.levels[k], beta, parts.part(k)));
  if (parts.stopped()) checks.clear();
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
  session.note(concat({"the domain of level ", worst, " has ",
                       decimal(100 * solver.levels[worst].area_kept, 1),
                       "% of its area; --keep-boundary 0.02 keeps it within 2%"}));
}

// Of the levels that have too few nodes for the angles sought.
void warn_of_angles(const CoarsenRun& run, Session& session) {
  const std::size_t needed = run.hierarchy.nodes_for_angles;
  if (run.hierarchy.levels.back().mesh.points.size() >= needed) return;
  session.note(
      concat({"levels of fewer than about ", needed, " nodes cannot keep angles of ",
              run.options.angle_deg, " degrees on this mesh: its special points ask for so many"}));
}

// Where that is cut short, or needs more memory than there is, what there is of it is dropped: the
// levels stay.
Status prepare_for_solver(Session& session, CoarsenRun& run) {
  auto solver = within_memory(
      [&] { return wellspaced::prepare_for_solver(run.hierarchy, session.progress()); });
  const bool limited = !solver && (solver.error().code == ErrorCode::kCancelled ||
                                   solver.error().code == ErrorCode::kLimit);
  if (limited) run.hierarchy.complete = false;
  if (!solver) return limited ? Status(Ok{}) : solver.error();
  run.solver = std::move(*solver);
  warn_of_drift(*run.solver, session);
  return Ok{};
}

Result<CoarsenRun> run_method(const TriangleMesh& mesh, const CoarsenRequest& request,
                              CoarseningMethod method, Session& session) {
  CoarsenRun run;
  run.options = options_of(request, method);
  const MemoryGauge memory;
  run.clock = PhaseClock();
  run.options.progress = [&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    run.clock.enter(phase);
    return session.progress()(phase, done, total);
  };
  auto hierarchy = coarsen(mesh, run.options);
  run.clock.stop();
  run.peak_bytes = memory.peak();
  run.options.progress = {};
  if (!hierarchy) return hierarchy.error();
  run.hierarchy = std::move(*hierarchy);
  warn_of_angles(run, session);
  // At a limit there is no time left but for the levels themselves.
  const StatisticsDetail detail =
      run.hierarchy.complete ? request.statistics : StatisticsDetail::kNone;
  run.statistics = measure(run.hierarchy, detail, session.progress());
  if (method == CoarseningMethod::kRefinement && detail != StatisticsDetail::kNone)
    run.selection = check_selections(run.hierarchy, run.options.beta, session.progress());
  if (request.for_solver && run.hierarchy.complete)
    if (Status status = prepare_for_solver(session, run); !status) return status.error();
  if (session.stopped())
    run.hierarchy.complete = false;  // if not levels, something else is missing
  return run;
}

Status write_files(std::span<const CoarsenRun> runs, const HierarchyFormat& common,
                   Session& session) {
  if (session.options().output.empty()) return Ok{};
  HierarchyFormat format = common;
  if (!session.options().format.empty()) format.format = session.options().format;
  for (const CoarsenRun& run : runs) {
    format.solver = run.solver ? &*run.solver : nullptr;
    std::string directory = session.options().output;
    if (runs.size() > 1) directory.append("/").append(name_of(run.options.method));
    const Status written =
        write_hierarchy(session.outputs(), directory, run.hierarchy, run.options, format);
    if (!written) return written;
  }
  return Ok{};
}

// What the options name files of: special points, spacing.
Status read_node_files(const Arguments& arguments, std::size_t nodes, CoarseningOptions& options) {
  if (const auto path = arguments.value("--fixed")) {
    auto fixed = read_fixed_points(*path, nodes);
    if (!fixed) return fixed.error();
    options.fixed = std::move(*fixed);
  }
  if (const auto path = arguments.value("--spacing")) {
    auto spacing = read_spacing(*path, nodes);
    if (!spacing) return spacing.error();
    options.spacing = std::move(*spacing);
  }
  return Ok{};
}

Result<int> run_coarsen(Arguments& arguments, Session& session) {
  CoarsenRequest request = read_coarsen_request(arguments, session.options().seed);
  if (Status status = arguments.status(); !status)
    return Error{ErrorCode::kUsage, {"coarsen: ", status.error().message}};
  if (session.options().output == "-")
    return Error{ErrorCode::kUsage, "coarsen: -o names a directory, not the standard output"};
  const Stopwatch reading;
  const auto geometry = read_mesh(arguments.operands()[0], session.reading());
  if (!geometry) return geometry.error();
  if (!session.options().output.empty())  // to write the levels takes about as long
    session.leave_time_to_write(reading.elapsed().wall);
  for (const std::string& note : geometry->notes) session.note(note);
  if (Status status = read_node_files(arguments, geometry->mesh.points.size(), request.options);
      !status)
    return status.error();

  std::vector<CoarsenRun> runs;
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
  if (Status status = write_run_summary(runs, session); !status) return status.error();
  const bool complete =
      std::ranges::all_of(runs, [](const CoarsenRun& r) { return r.hierarchy.complete; });
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
