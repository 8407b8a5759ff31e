#include "wellspaced/algorithms/coarsening/coarsening_arguments.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

constexpr Index kMaxNodes = Index{1} << 28;

// Whether the distance of any two points is a double.
bool has_lengths(std::span<const Point2> points) {
  const Box2 box = Box2::around(points);
  return std::isfinite(distance(box.low, box.high));
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

Status check_numbers(const CoarseningOptions& options) {
  if (!(options.beta > 1) || !std::isfinite(options.beta))
    return usage("beta must be a finite number greater than 1");
  if (!(options.factor > 1) || !std::isfinite(options.factor))
    return usage("the coarsening factor must be a finite number greater than 1");
  if (options.protect && !(*options.protect >= 0 && std::isfinite(*options.protect)))
    return usage("the protection ratio must be a finite number, 0 or more");
  if (options.keep_boundary && !(*options.keep_boundary >= 0))
    return usage("the drift of the boundary must be a number, 0 or more");
  return Ok{};
}

Status check_method(const CoarseningOptions& options) {
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
  return Ok{};
}

Status check_positive(const std::optional<std::vector<double>>& spacing) {
  if (!spacing) return Ok{};
  for (Index v = 0; v < spacing->size(); ++v)
    if (!((*spacing)[v] > 0))
      return Error{ErrorCode::kUsage, {"the spacing of node ", v, " must be greater than 0"}, {v}};
  return Ok{};
}

Status check_special_points(const CoarseningOptions& options, std::size_t nodes) {
  if (!options.fixed) return Ok{};
  for (const Index v : *options.fixed)
    if (v >= nodes)
      return Error{
          ErrorCode::kUsage,
          {"fixed point ", v, " is out of range: the mesh has ", nodes, " nodes, numbered from 0"},
          {v}};
  return Ok{};
}

}  // namespace

Status check_coarsening_mesh(const TriangleMesh& mesh) {
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

Status check_coarsening_options(const CoarseningOptions& options, std::size_t nodes) {
  for (const Status& status :
       {check_numbers(options), check_method(options), check_refinement(options, nodes),
        check_values("spacing", options.spacing, nodes),
        check_values("priority", options.priority, nodes), check_positive(options.spacing),
        check_special_points(options, nodes)})
    if (!status) return status;
  return Ok{};
}

}  // namespace wellspaced
