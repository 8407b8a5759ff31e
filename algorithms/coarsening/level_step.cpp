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

// ONE_LEVEL_COARSEN on its way from phase to phase.
class LevelStep {
 public:
  LevelStep(const SourceMesh& source, const StepRequest& request, const CoarseningOptions& options,
            const Tell& tell)
      : source_(source),
        request_(request),
        options_(options),
        tell_(tell),
        boundary_(source.skeleton.boundary),
        points_(source.level.mesh.points),
        search_(source.skeleton.graph) {}

  Result<CoarseningStep> run();

 private:
  // Each returns false when told to stop.
  bool coarsen_spacing();
  bool select_boundary(NodeSelection& selection);
  bool select_interior(const ContractedBoundary& contracted, NodeSelection& selection);

  ContractedBoundary contract(NodeSelection& selection);
  void protect(std::span<const ContractedEdge> edges, NodeSelection& selection);
  Result<CoarseningStep> triangulate(std::vector<Index> selected,
                                     std::span<const ContractedEdge> edges);

  const SourceMesh& source_;
  const StepRequest& request_;
  const CoarseningOptions& options_;
  const Tell& tell_;
  const Boundary& boundary_;
  std::span<const Point2> points_;
  LocalSearch search_;
  std::vector<double> f_;  // the coarsened spacing; none where it is MIS-based
  std::vector<std::uint64_t> keys_;
  CoarseningWork work_;
  std::size_t reinstated_ = 0, dropped_outside_ = 0;
};

bool LevelStep::coarsen_spacing() {
  if (!is_mis_based(options_))
    f_ = coarsened(source_, request_.factor, options_, within("spacing", tell_));
  if (!tell_("spacing")) return false;
  if (counts_paths(options_))
    measure_paths(source_.skeleton.graph, source_.level.spacing, request_.factor, f_, work_);
  return true;
}

// Special points whatever they conflict with, then the boundary, a maximal set.
bool LevelStep::select_boundary(NodeSelection& selection) {
  const NodeSelection::KeepGoing keep_going = [&] { return tell_("boundary"); };
  return selection.force(source_.level.mesh.fixed, keep_going) &&
         selection.force(request_.forced, keep_going) &&
         selection.select(boundary_.nodes, keys_, keep_going);
}

ContractedBoundary LevelStep::contract(NodeSelection& selection) {
  const std::size_t chosen = selection.selected().size();
  ContractedBoundary contracted = contract_and_repair(boundary_, points_, selection, request_.areas,
                                                      [&] { return tell_("boundary"); });
  reinstated_ = selection.selected().size() - chosen;
  return contracted;
}

void LevelStep::protect(std::span<const ContractedEdge> edges, NodeSelection& selection) {
  const Progress progress = within("boundary", tell_);
  if (options_.count_work) work_.edge_protection = inspect_edges(search_, points_, edges, progress);
  protect_edges({points_, boundary_.on_boundary, edges, zone_of(options_)}, search_, selection,
                progress);
}

bool LevelStep::select_interior(const ContractedBoundary& contracted, NodeSelection& selection) {
  const std::vector<Index> interior = interior_nodes(boundary_);
  dropped_outside_ =
      drop_nodes_outside(contracted, points_, interior, within("select", tell_), selection);
  return selection.select(interior, keys_, [&] { return tell_("select"); });
}

Result<CoarseningStep> LevelStep::triangulate(std::vector<Index> selected,
                                              std::span<const ContractedEdge> edges) {
  const std::vector<Index> number = numbering(selected, points_.size());
  CoarseningStep step{inherit(source_.level, std::move(selected), number), std::nullopt};
  if (options_.count_work) step.work = work_;
  Level& level = step.level;
  level.reinstated = reinstated_;
  level.dropped_outside = dropped_outside_;
  auto triangulation =
      triangulate_domain(level.mesh.points, constrained_edges(boundary_, edges, number), {},
                         within("triangulate", tell_));
  if (!triangulation) return triangulation.error();
  level.mesh.triangles = std::move(triangulation->triangles);
  level.mesh.segments = std::move(triangulation->segments);
  level.spacing = is_mis_based(options_) ? mesh_spacing(level.mesh) : restricted(f_, level.parent);
  return step;
}

Result<CoarseningStep> LevelStep::run() {
  if (!tell_("spacing") || !coarsen_spacing()) return cancelled();

  if (!tell_("boundary")) return cancelled();
  keys_ = order_keys(source_.level, f_, request_.level, options_);
  NodeSelection selection(static_cast<Index>(points_.size()), boundary_.twins,
                          conflict_rule(source_, search_, f_, options_),
                          search_counter(search_, f_, options_, work_.selection));
  if (!select_boundary(selection)) return cancelled();
  const ContractedBoundary contracted = contract(selection);
  protect(contracted.edges(), selection);

  if (!tell_("select") || !select_interior(contracted, selection)) return cancelled();

  if (!tell_("triangulate")) return cancelled();
  return triangulate(selection.selected(), contracted.edges());
}

}  // namespace

Result<CoarseningStep> coarsen_level(const SourceMesh& source, const StepRequest& request,
                                     const CoarseningOptions& options, const Tell& tell) {
  return LevelStep(source, request, options, tell).run();
}

}  // namespace wellspaced
