#include "wellspaced/algorithms/coarsening/coarsen.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "wellspaced/algorithms/coarsening/level_step.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/algorithms/coarsening/special_points.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/sort_unique.hpp"

namespace wellspaced {
namespace {

constexpr Index kMaxNodes = Index{1} << 28;

// ---- The arguments

Status check_mesh(const TriangleMesh& mesh) {
  const std::size_t nodes = mesh.points.size();
  if (nodes > kMaxNodes) return Error{ErrorCode::kLimit, "more than 2^28 nodes", {}};
  for (Index v = 0; v < nodes; ++v)
    if (!is_finite(mesh.points[v]))
      return Error{ErrorCode::kInvalidGeometry,
                   "node " + std::to_string(v) + " has a coordinate that is not finite",
                   {v}};
  const auto out_of_range = [=](Index v) { return v >= nodes; };
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (std::ranges::any_of(mesh.triangles[t], out_of_range))
      return Error{ErrorCode::kInvalidGeometry,
                   "triangle " + std::to_string(t) + " names a node that does not exist",
                   {t}};
  for (Index s = 0; s < mesh.segments.size(); ++s)
    if (out_of_range(mesh.segments[s].a) || out_of_range(mesh.segments[s].b))
      return Error{ErrorCode::kInvalidGeometry,
                   "segment " + std::to_string(s) + " names a node that does not exist",
                   {s}};
  return Ok{};
}

Error usage(std::string message) { return {ErrorCode::kUsage, std::move(message), {}}; }

Status check_options(const CoarseningOptions& options, std::size_t nodes) {
  if (!(options.beta > 1) || !std::isfinite(options.beta))
    return usage("beta must be a finite number greater than 1");
  if (!(options.factor > 1) || !std::isfinite(options.factor))
    return usage("the coarsening factor must be a finite number greater than 1");
  if (options.protect && !(*options.protect >= 0 && std::isfinite(*options.protect)))
    return usage("the protection ratio must be a finite number, 0 or more");
  if (!options.fixed) return Ok{};
  for (const Index v : *options.fixed)
    if (v >= nodes)
      return Error{ErrorCode::kUsage,
                   "fixed point " + std::to_string(v) + " is out of range: the mesh has " +
                       std::to_string(nodes) + " nodes, numbered from 0",
                   {v}};
  return Ok{};
}

// ---- Level 0

// The boundary edges that no segment names, after those that are.
void complete_segments(TriangleMesh& mesh, const Boundary& boundary) {
  const auto ends = [](const Segment& s) { return std::minmax(s.a, s.b); };
  const auto less = [&](const Segment& a, const Segment& b) { return ends(a) < ends(b); };
  std::vector<Segment> known = mesh.segments;
  std::sort(known.begin(), known.end(), less);
  for (const Segment& s : boundary_segments(boundary))
    if (!std::binary_search(known.begin(), known.end(), s, less)) mesh.segments.push_back(s);
}

std::vector<Index> special_points(const TriangleMesh& mesh, const Skeleton& skeleton,
                                  const CoarseningOptions& options) {
  std::vector<Index> special =
      options.fixed ? *options.fixed : automatic_special_points(mesh, skeleton);
  const std::vector<Index>& anchors = skeleton.boundary.anchors;
  special.insert(special.end(), anchors.begin(), anchors.end());
  for (Index v = 0; v < skeleton.graph.nodes(); ++v)
    if (skeleton.graph.arcs_of(v).empty()) special.push_back(v);
  sort_unique(special);
  return special;
}

Level finest_level(TriangleMesh mesh, const Skeleton& skeleton, const CoarseningOptions& options) {
  mesh.fixed = special_points(mesh, skeleton, options);
  complete_segments(mesh, skeleton.boundary);
  Level level;
  level.spacing = mesh_spacing(skeleton.graph);
  level.origin.resize(mesh.points.size());
  std::iota(level.origin.begin(), level.origin.end(), Index{0});
  level.mesh = std::move(mesh);
  return level;
}

}  // namespace

double protection_ratio(const CoarseningOptions& options) {
  return options.protect.value_or(options.method == CoarseningMethod::kFunction ? 0.2 : 0.15);
}

Result<Hierarchy> coarsen(TriangleMesh mesh, const CoarseningOptions& options) {
  if (const Status status = check_mesh(mesh); !status) return status.error();
  if (const Status status = check_options(options, mesh.points.size()); !status)
    return status.error();

  const std::size_t input_nodes = mesh.points.size();
  Skeleton skeleton = skeleton_of(mesh);
  Hierarchy hierarchy;
  hierarchy.levels.push_back(finest_level(std::move(mesh), skeleton, options));
  while (hierarchy.levels.size() <= options.max_levels) {
    Level& finer = hierarchy.levels.back();
    const std::size_t nodes = finer.mesh.points.size();
    if (nodes <= options.until_nodes) break;
    const auto tell = [&](std::string_view phase) {
      return report(options.progress, phase, input_nodes - nodes, input_nodes);
    };
    if (!tell("spacing")) {
      hierarchy.complete = false;
      break;
    }
    if (hierarchy.levels.size() > 1) skeleton = skeleton_of(finer.mesh);
    auto step = coarsen_level(finer, skeleton, hierarchy.levels.size(), options, tell);
    hierarchy.complete = step.ok() || step.error().code != ErrorCode::kCancelled;
    if (!hierarchy.complete) break;
    if (!step) return step.error();
    if (step->level.mesh.points.size() == nodes) break;
    finer.work = step->work;
    hierarchy.levels.push_back(std::move(step->level));
  }
  return hierarchy;
}

}  // namespace wellspaced
