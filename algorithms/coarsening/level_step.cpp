#include "wellspaced/algorithms/coarsening/level_step.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"
#include "wellspaced/algorithms/coarsening/edge_protection.hpp"
#include "wellspaced/algorithms/coarsening/level_triangulation.hpp"
#include "wellspaced/algorithms/coarsening/node_order.hpp"
#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/algorithms/coarsening/visible_conflicts.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/local_search.hpp"
#include "wellspaced/kernel/shortest_paths.hpp"

namespace wellspaced {
namespace {

using Tell = std::function<bool(std::string_view)>;

// The questions of a part of a phase are those of the phase. Requires: `tell` outlives it.
Progress within(std::string_view phase, const Tell& tell) {
  return [&tell, phase](auto, auto, auto) { return tell(phase); };
}

bool is_mis_based(const CoarseningOptions& options) {
  return options.method == CoarseningMethod::kMis;
}

// Whether shortest paths of the graph gave the nodes their spacing, and their conflicts.
bool counts_paths(const CoarseningOptions& options) {
  return options.count_work && options.method == CoarseningMethod::kFunction &&
         options.metric == SpacingMetric::kGraph;
}

void measure_paths(const Graph& graph, std::vector<double> start, double factor,
                   std::span<const double> f, CoarseningWork& work) {
  for (double& value : start) value *= factor;
  const ShortestPathTree tree = shortest_path_tree(graph, start, f);
  double sum = 0;
  for (const Index depth : tree.depth) {
    work.path_depth_max = std::max(work.path_depth_max, depth);
    sum += depth;
  }
  if (!tree.depth.empty()) work.path_depth_mean = sum / static_cast<double>(tree.depth.size());
}

ConflictRule conflict_rule(const SourceMesh& source, LocalSearch& search, std::span<const double> f,
                           const CoarseningOptions& options) {
  const Graph& graph = source.skeleton.graph;
  if (is_mis_based(options)) return neighbor_conflicts(graph);
  return source.visibility ? visible_conflicts(*source.visibility, graph, f, options.beta)
                           : function_conflicts(search, f, options.beta);
}

// Counts the nodes that a search of radius 2 f / beta inspects from every node considered.
NodeSelection::Considered search_counter(LocalSearch& search, std::span<const double> f,
                                         const CoarseningOptions& options, SearchCount& count) {
  if (!counts_paths(options)) return {};
  return [&search, &count, f, beta = options.beta](Index node) {
    const double radius = 2 * f[node] / beta;
    const auto within = [=](Index, double d) { return d <= radius; };
    search.run(std::array{node}, within);
    count.add(search.include_frontier().size());
  };
}

ProtectiveZone zone_of(const CoarseningOptions& options) {
  using Shape = ProtectiveZone::Shape;
  return {uses_visibility(options) ? Shape::kRectangle : Shape::kLens, protection_ratio(options)};
}

std::vector<Index> interior_nodes(const Boundary& boundary) {
  std::vector<Index> nodes;
  for (Index v = 0; v < boundary.on_boundary.size(); ++v)
    if (!boundary.on_boundary[v]) nodes.push_back(v);
  return nodes;
}

// Returns how many.
std::size_t drop_nodes_outside(const ContractedBoundary& contracted, std::span<const Point2> points,
                               std::span<const Index> nodes, const Progress& progress,
                               NodeSelection& selection) {
  std::size_t dropped = 0;
  if (!contracted.moves_anything()) return dropped;
  ProgressMeter meter(progress, "select", nodes.size());
  for (const Index v : nodes) {
    if (!meter.step()) break;
    if (!selection.is_free(v) || !contracted.leaves_outside(points[v])) continue;
    selection.invalidate(v);
    ++dropped;
  }
  return dropped;
}

// For each node of the finer level its number in the new one, or kNoIndex.
std::vector<Index> numbering(std::span<const Index> parent, std::size_t finer_nodes) {
  std::vector<Index> number(finer_nodes, kNoIndex);
  for (Index v = 0; v < parent.size(); ++v) number[parent[v]] = v;
  return number;
}

// The parts of the finer level that its nodes `parent` take with them.
Level inherit(const Level& finer, std::vector<Index> parent, std::span<const Index> number) {
  Level level;
  level.parent = std::move(parent);
  for (const Index v : level.parent) {
    level.origin.push_back(finer.origin[v]);
    level.mesh.points.push_back(finer.mesh.points[v]);
    if (!finer.mesh.point_markers.empty())
      level.mesh.point_markers.push_back(finer.mesh.point_markers[v]);
  }
  for (const Index v : finer.mesh.fixed) level.mesh.fixed.push_back(number[v]);
  return level;
}

std::vector<double> restricted(std::span<const double> values, std::span<const Index> nodes) {
  std::vector<double> result;
  for (const Index v : nodes) result.push_back(values[v]);
  return result;
}

std::vector<std::uint64_t> order_keys(const Level& finer, std::span<const double> f,
                                      std::size_t level, const CoarseningOptions& options) {
  if (options.order == SelectionOrder::kRandom)
    return random_keys(finer.origin, static_cast<std::uint32_t>(level), options.seed);
  if (options.priority) return priority_keys(restricted(*options.priority, finer.origin));
  return priority_keys(is_mis_based(options) ? std::vector<double>(finer.origin.size(), 0)
                                             : std::vector<double>(f.begin(), f.end()));
}

}  // namespace

Result<CoarseningStep> coarsen_level(const SourceMesh& source, const StepRequest& request,
                                     const CoarseningOptions& options, const Tell& tell) {
  if (!tell("spacing")) return cancelled();
  const Level& finer = source.level;
  const std::span<const Point2> points = finer.mesh.points;
  const Graph& graph = source.skeleton.graph;
  const Boundary& boundary = source.skeleton.boundary;
  CoarseningWork work;
  std::vector<double> f;
  if (!is_mis_based(options))
    f = coarsened(source, request.factor, options, within("spacing", tell));
  if (!tell("spacing")) return cancelled();
  if (counts_paths(options)) measure_paths(graph, finer.spacing, request.factor, f, work);

  if (!tell("boundary")) return cancelled();
  const std::vector<std::uint64_t> keys = order_keys(finer, f, request.level, options);
  LocalSearch search(graph);
  NodeSelection selection(graph.nodes(), boundary.twins, conflict_rule(source, search, f, options),
                          search_counter(search, f, options, work.selection));
  const NodeSelection::KeepGoing keep_going = [&] { return tell("boundary"); };
  if (!selection.force(finer.mesh.fixed, keep_going)) return cancelled();
  if (!selection.force(request.forced, keep_going)) return cancelled();
  if (!selection.select(boundary.nodes, keys, keep_going)) return cancelled();
  const std::size_t chosen = selection.selected().size();
  const ContractedBoundary contracted =
      contract_and_repair(boundary, points, selection, request.areas, keep_going);
  const std::size_t reinstated = selection.selected().size() - chosen;
  const ProtectiveZone zone = zone_of(options);
  if (options.count_work)
    work.edge_protection =
        inspect_edges(search, points, contracted.edges(), within("boundary", tell));
  protect_edges(search, points, contracted.edges(), boundary.on_boundary, zone, selection,
                within("boundary", tell));

  if (!tell("select")) return cancelled();
  const std::vector<Index> interior = interior_nodes(boundary);
  const std::size_t dropped =
      drop_nodes_outside(contracted, points, interior, within("select", tell), selection);
  if (!selection.select(interior, keys, [&] { return tell("select"); })) return cancelled();

  if (!tell("triangulate")) return cancelled();
  std::vector<Index> parent = selection.selected();
  const std::vector<Index> number = numbering(parent, graph.nodes());
  CoarseningStep step{inherit(finer, std::move(parent), number), std::nullopt};
  if (options.count_work) step.work = work;
  step.level.reinstated = reinstated;
  step.level.dropped_outside = dropped;

  auto triangulation = triangulate_domain(step.level.mesh.points,
                                          constrained_edges(boundary, contracted.edges(), number),
                                          {}, within("triangulate", tell));
  if (!triangulation) return triangulation.error();
  step.level.mesh.triangles = std::move(triangulation->triangles);
  step.level.mesh.segments = std::move(triangulation->segments);
  step.level.spacing = is_mis_based(options) ? mesh_spacing(mesh_graph(step.level.mesh))
                                             : restricted(f, step.level.parent);
  return step;
}

}  // namespace wellspaced
