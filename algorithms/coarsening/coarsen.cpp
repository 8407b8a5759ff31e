#include "wellspaced/algorithms/coarsening/coarsen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "wellspaced/algorithms/coarsening/boundary_description.hpp"
#include "wellspaced/algorithms/coarsening/quadtree_sequence.hpp"
#include "wellspaced/algorithms/coarsening/quality/refinement_sequence.hpp"
#include "wellspaced/algorithms/coarsening/schemes.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/algorithms/coarsening/source_mesh.hpp"
#include "wellspaced/algorithms/coarsening/special_points.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr Index kMaxNodes = Index{1} << 28;

// ---- The arguments

// Whether the distance of any two points is a double.
bool has_lengths(std::span<const Point2> points) {
  const Box2 box = Box2::around(points);
  return std::isfinite(distance(box.low, box.high));
}

Status check_mesh(const TriangleMesh& mesh) {
  const std::size_t nodes = mesh.points.size();
  if (nodes > kMaxNodes) return Error{ErrorCode::kLimit, "more than 2^28 nodes", {}};
  for (Index v = 0; v < nodes; ++v)
    if (!is_finite(mesh.points[v]))
      return Error{
          ErrorCode::kInvalidGeometry, {"node ", v, " has a coordinate that is not finite"}, {v}};
  if (nodes > 0 && !has_lengths(mesh.points))
    return Error{ErrorCode::kInvalidGeometry,
                 "the mesh is wider than the largest double; scale it down",
                 {}};
  const auto out_of_range = [=](Index v) { return v >= nodes; };
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (std::ranges::any_of(mesh.triangles[t], out_of_range))
      return Error{
          ErrorCode::kInvalidGeometry, {"triangle ", t, " names a node that does not exist"}, {t}};
  for (Index s = 0; s < mesh.segments.size(); ++s)
    if (out_of_range(mesh.segments[s].a) || out_of_range(mesh.segments[s].b))
      return Error{
          ErrorCode::kInvalidGeometry, {"segment ", s, " names a node that does not exist"}, {s}};
  return Ok{};
}

Error usage(std::string message) { return {ErrorCode::kUsage, std::move(message), {}}; }

Status check_values(const std::string& name, const std::optional<std::vector<double>>& values,
                    std::size_t nodes) {
  if (!values) return Ok{};
  if (values->size() != nodes)
    return usage(concat(
        {"there must be one ", name, " for each of the ", nodes, " nodes, not ", values->size()}));
  for (Index v = 0; v < nodes; ++v)
    if (!std::isfinite((*values)[v]))
      return Error{ErrorCode::kUsage, {"the ", name, " of node ", v, " is not finite"}, {v}};
  return Ok{};
}

Status check_refinement(const CoarseningOptions& options, std::size_t nodes) {
  if (options.method != CoarseningMethod::kRefinement) {
    if (options.targets.empty()) return Ok{};
    return usage("the sizes of levels can be given to refinement alone (--profile quality)");
  }
  if (options.scheme != CoarseningScheme::kCoarseToFine ||
      options.metric != SpacingMetric::kGraph || options.limit_by_boundary ||
      options.limit_by_special_points || options.keep_boundary || options.priority)
    return usage(
        "levels by refinement are made coarse to fine, in the graph metric, in an order of their "
        "own, without regard to the boundary's feature size or the area");
  if (!(options.ratio > 1) || !std::isfinite(options.ratio))
    return usage("the ratio of the levels' nodes must be a finite number greater than 1");
  if (!(options.angle_deg > 0) || !(options.angle_deg <= 30))
    return usage("the angle must be more than 0 and at most 30 degrees");
  for (const std::size_t target : options.targets)
    if (target == 0 || target >= nodes)
      return usage(concat({"a level must have at least 1 node and less than the input's ", nodes,
                           ", not ", target}));
  return Ok{};
}

Status check_options(const CoarseningOptions& options, std::size_t nodes) {
  if (!(options.beta > 1) || !std::isfinite(options.beta))
    return usage("beta must be a finite number greater than 1");
  if (!(options.factor > 1) || !std::isfinite(options.factor))
    return usage("the coarsening factor must be a finite number greater than 1");
  if (options.protect && !(*options.protect >= 0 && std::isfinite(*options.protect)))
    return usage("the protection ratio must be a finite number, 0 or more");
  if (options.keep_boundary && !(*options.keep_boundary >= 0))
    return usage("the drift of the boundary must be a number, 0 or more");
  if (options.method == CoarseningMethod::kMis && options.scheme != CoarseningScheme::kFineToCoarse)
    return usage("MIS-based levels are selected from the level before: fine to coarse alone");
  if (options.method == CoarseningMethod::kMis && options.limit_by_special_points)
    return usage("MIS-based levels have no spacing that special points could limit");
  if (options.method == CoarseningMethod::kQuadtree &&
      (options.scheme != CoarseningScheme::kCoarseToFine ||
       options.metric != SpacingMetric::kEuclidean || options.limit_by_boundary ||
       options.order != SelectionOrder::kRandom))
    return usage(
        "levels by quadtree are selected coarse to fine, in the Euclidean metric and the tree's "
        "order, without regard to the boundary's local feature size");
  if (Status status = check_refinement(options, nodes); !status) return status;
  if (Status status = check_values("spacing", options.spacing, nodes); !status) return status;
  if (Status status = check_values("priority", options.priority, nodes); !status) return status;
  if (options.spacing)
    for (Index v = 0; v < nodes; ++v)
      if (!((*options.spacing)[v] > 0))
        return Error{
            ErrorCode::kUsage, {"the spacing of node ", v, " must be greater than 0"}, {v}};
  if (!options.fixed) return Ok{};
  for (const Index v : *options.fixed)
    if (v >= nodes)
      return Error{
          ErrorCode::kUsage,
          {"fixed point ", v, " is out of range: the mesh has ", nodes, " nodes, numbered from 0"},
          {v}};
  return Ok{};
}

// ---- Level 0

// The boundary edges that no segment names, after those that are.
void complete_segments(TriangleMesh& mesh, const Boundary& boundary) {
  const auto ends = [](const Segment& s) { return std::minmax(s.a, s.b); };
  const auto less = [&](const Segment& a, const Segment& b) { return ends(a) < ends(b); };
  std::vector<Segment> known = mesh.segments;
  sort(known, less);
  for (const Segment& s : boundary_segments(boundary))
    if (!std::binary_search(known.begin(), known.end(), s, less)) mesh.segments.push_back(s);
}

std::vector<Index> chosen_special_points(const TriangleMesh& mesh, const Skeleton& skeleton,
                                         const CoarseningOptions& options) {
  if (options.method != CoarseningMethod::kRefinement)
    return options.fixed ? *options.fixed : automatic_special_points(mesh, skeleton);
  return options.fixed ? completed_special_points(mesh, skeleton, *options.fixed)
                       : outline_special_points(mesh, skeleton);
}

std::vector<Index> special_points(const TriangleMesh& mesh, const Skeleton& skeleton,
                                  const CoarseningOptions& options) {
  std::vector<Index> special = chosen_special_points(mesh, skeleton, options);
  const std::vector<Index>& anchors = skeleton.boundary.anchors;
  special.insert(special.end(), anchors.begin(), anchors.end());
  for (Index v = 0; v < skeleton.corners.nodes(); ++v)
    if (skeleton.corners.at(v).empty() && !skeleton.boundary.on_boundary[v]) special.push_back(v);
  sort_unique(special);
  return special;
}

// The local feature size of B at every node, and B's vertices among the special points.
Result<std::vector<double>> keep_boundary(TriangleMesh& mesh, const CoarseningOptions& options,
                                          const Progress& progress) {
  const BoundaryDescription b = boundary_description(mesh);
  mesh.fixed.insert(mesh.fixed.end(), b.vertices.begin(), b.vertices.end());
  sort_unique(mesh.fixed);
  const auto lfs = LocalFeatureSize::build(b.graph);
  if (!lfs) return lfs.error();
  const bool plain = options.metric == SpacingMetric::kEuclidean;
  ProgressMeter meter(progress, "prepare", mesh.points.size(), 1 << 10);
  const auto lfs_at = [&](Point2 p) {
    if (!meter.step()) return 0.0;
    return plain ? lfs->at(p) : lfs->geodesic_at(p);
  };
  return sampled(lfs_at, mesh.points);
}

// A spacing f sets nodes 2 f / beta apart: at each special point as far as it is from the next one.
std::vector<double> special_point_limit(const TriangleMesh& mesh, double beta,
                                        const Progress& progress) {
  std::vector<double> limit(mesh.points.size(), std::numeric_limits<double>::infinity());
  const std::vector<double> apart = special_point_distances(mesh);
  for (std::size_t i = 0; i < apart.size(); ++i) limit[mesh.fixed[i]] = apart[i];
  return euclidean_coarsened_spacing(mesh.points, limit, beta / 2, progress);
}

// The least of all limits on the spacing that the options ask for; empty if there are none.
Result<std::vector<double>> spacing_limit(TriangleMesh& mesh, const CoarseningOptions& options,
                                          const Progress& progress) {
  std::vector<double> limit;
  if (options.limit_by_boundary) {
    auto lfs = keep_boundary(mesh, options, progress);
    if (!lfs) return lfs.error();
    limit = std::move(*lfs);
  }
  if (!options.limit_by_special_points) return limit;
  std::vector<double> special = special_point_limit(mesh, options.beta, progress);
  for (std::size_t v = 0; v < limit.size(); ++v) special[v] = std::min(special[v], limit[v]);
  return special;
}

Level finest_level(TriangleMesh mesh, const Graph& graph, const CoarseningOptions& options,
                   const Progress& progress) {
  Level level;
  level.spacing = input_spacing(mesh, graph, options, progress);
  level.origin.resize(mesh.points.size());
  std::iota(level.origin.begin(), level.origin.end(), Index{0});
  level.mesh = std::move(mesh);
  return level;
}

// Requires: the arguments have been checked.
Result<Hierarchy> make_hierarchy(TriangleMesh mesh, const CoarseningOptions& options) {
  bool stopped = false;
  const Progress prepare = [&, nodes = mesh.points.size()](auto, auto, auto) {
    stopped = stopped || !report(options.progress, "prepare", 0, nodes);
    return !stopped;
  };
  const auto go_on = [&]() -> Status {
    if (report(prepare, "prepare", 0, 0)) return Ok{};
    return Error{ErrorCode::kCancelled, "coarsening was cancelled", {}};
  };
  if (const Status status = go_on(); !status) return status.error();
  Skeleton skeleton = uses_graph(options) ? skeleton_of(mesh) : skeleton_without_graph(mesh);
  if (const Status status = go_on(); !status) return status.error();
  mesh.fixed = special_points(mesh, skeleton, options);
  complete_segments(mesh, skeleton.boundary);
  if (const Status status = go_on(); !status) return status.error();
  if (options.method == CoarseningMethod::kQuadtree) {
    Level finest = finest_level(std::move(mesh), skeleton.graph, options, prepare);
    Boundary boundary = std::move(skeleton.boundary);
    skeleton = {};  // large, and of no more use
    return coarsen_by_quadtree(std::move(finest), std::move(boundary), options);
  }
  const auto limit = spacing_limit(mesh, options, prepare);
  if (!limit) return limit.error();
  if (const Status status = go_on(); !status) return status.error();
  Level finest = finest_level(std::move(mesh), skeleton.graph, options, prepare);
  if (const Status status = go_on(); !status) return status.error();
  if (options.method == CoarseningMethod::kRefinement)
    return coarsen_by_refinement(std::move(finest), skeleton, options);
  return build_levels(std::move(finest), std::move(skeleton), *limit, options);
}

}  // namespace

CoarseningOptions multigrid_profile() {
  CoarseningOptions options;
  options.beta = 4;
  options.factor = 2;
  options.order = SelectionOrder::kPriority;
  options.until_nodes = 600;
  return options;
}

CoarseningOptions quality_profile() { return theorem_options(CoarseningMethod::kRefinement); }

double protection_ratio(const CoarseningOptions& options) {
  return options.protect.value_or(options.method == CoarseningMethod::kMis ? 0.15 : 0.2);
}

CoarseningOptions theorem_options(CoarseningMethod method) {
  CoarseningOptions options;
  options.method = method;
  if (method == CoarseningMethod::kFunction || method == CoarseningMethod::kMis) return options;
  if (method == CoarseningMethod::kRefinement) {
    options.beta = 3.5;
    options.scheme = CoarseningScheme::kCoarseToFine;
    return options;
  }
  options.metric = SpacingMetric::kEuclidean;
  options.beta = method == CoarseningMethod::kThreshold ? 16 : 2;
  options.factor = method == CoarseningMethod::kThreshold      ? 24
                   : method == CoarseningMethod::kQuasiUniform ? 3
                                                               : 2;
  if (method == CoarseningMethod::kQuadtree) options.scheme = CoarseningScheme::kCoarseToFine;
  return options;
}

Result<Hierarchy> coarsen(TriangleMesh mesh, const CoarseningOptions& options) {
  if (const Status status = check_mesh(mesh); !status) return status.error();
  if (const Status status = check_options(options, mesh.points.size()); !status)
    return status.error();

  const std::size_t nodes = mesh.points.size();
  auto hierarchy = make_hierarchy(std::move(mesh), options);
  if (hierarchy && hierarchy->complete)
    hierarchy->complete = report(options.progress, "finish", nodes, nodes);
  return hierarchy;
}

}  // namespace wellspaced
