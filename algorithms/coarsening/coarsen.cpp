#include "wellspaced/algorithms/coarsening/coarsen.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "wellspaced/algorithms/coarsening/boundary_description.hpp"
#include "wellspaced/algorithms/coarsening/coarsening_arguments.hpp"
#include "wellspaced/algorithms/coarsening/quadtree_sequence.hpp"
#include "wellspaced/algorithms/coarsening/quality/refinement_sequence.hpp"
#include "wellspaced/algorithms/coarsening/schemes.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/algorithms/coarsening/source_mesh.hpp"
#include "wellspaced/algorithms/coarsening/special_points.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

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
  const auto go_on = [&] { return report(prepare, "prepare", 0, 0); };
  if (!go_on()) return cancelled();
  Skeleton skeleton = uses_graph(options) ? skeleton_of(mesh) : skeleton_without_graph(mesh);
  if (!go_on()) return cancelled();
  mesh.fixed = special_points(mesh, skeleton, options);
  complete_segments(mesh, skeleton.boundary);
  if (!go_on()) return cancelled();
  if (options.method == CoarseningMethod::kQuadtree) {
    Level finest = finest_level(std::move(mesh), skeleton.graph, options, prepare);
    Boundary boundary = std::move(skeleton.boundary);
    skeleton = {};  // large, and of no more use
    return coarsen_by_quadtree(std::move(finest), std::move(boundary), options);
  }
  const auto limit = spacing_limit(mesh, options, prepare);
  if (!limit) return limit.error();
  if (!go_on()) return cancelled();
  Level finest = finest_level(std::move(mesh), skeleton.graph, options, prepare);
  if (!go_on()) return cancelled();
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
  if (const Status status = check_coarsening_mesh(mesh); !status) return status.error();
  if (const Status status = check_coarsening_options(options, mesh.points.size()); !status)
    return status.error();

  const std::size_t nodes = mesh.points.size();
  auto hierarchy = make_hierarchy(std::move(mesh), options);
  if (hierarchy && hierarchy->complete)
    hierarchy->complete = report(options.progress, "finish", nodes, nodes);
  return hierarchy;
}

}  // namespace wellspaced
