#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "wellspaced/algorithms/mesh/sight_cones.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// The nodes before and after a node on the boundary, the domain on the left. Where several curves
// meet in it they are counted.
struct BoundaryNode {
  Index before = kNoIndex, after = kNoIndex;
  unsigned curves = 0;
};

std::vector<BoundaryNode> boundary_nodes(const TriangleMesh& mesh, const TriangleLinks& links) {
  std::vector<BoundaryNode> nodes(mesh.points.size());
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    for (unsigned i = 0; i < 3; ++i) {
      if (links.neighbor(t, i) != kNoIndex) continue;
      const Index a = mesh.triangles[t][(i + 1) % 3], b = mesh.triangles[t][(i + 2) % 3];
      nodes[a].after = b;
      ++nodes[a].curves;
      nodes[b].before = a;
    }
  }
  return nodes;
}

}  // namespace

GeodesicCoarseningFunction::GeodesicCoarseningFunction(const Visibility& visibility,
                                                       const Graph& graph,
                                                       std::span<const double> spacing,
                                                       double factor, const Progress& progress)
    : visibility_(visibility),
      own_(scaled(spacing, factor)),
      values_(coarsened_spacing(graph, spacing, factor)),
      cones_({}) {
  const std::vector<std::uint8_t> is_bend = bends();
  ProgressMeter meter(progress, "spacing", 0);
  spread_cones(is_bend, meter);
  if (meter.stopped()) return;
  cones_ = SiteTree(visibility.mesh().points, weights_of_sources(is_bend));
}

double GeodesicCoarseningFunction::operator()(Point2 x, Index at) const {
  double bound = std::numeric_limits<double>::infinity();
  for (const Index v : visibility_.mesh().triangles[at])
    bound = std::min(bound, values_[v] + distance(x, visibility_.mesh().points[v]));
  const Index q = cones_.nearest(x, bound, [&](Index v) { return visibility_.sees(x, at, v); });
  return q == kNoIndex ? bound : std::min(bound, weighted_distance(cones_.site(q), x));
}

// Nodes where the domain takes up no less than a half turn, or where several curves meet.
std::vector<std::uint8_t> GeodesicCoarseningFunction::bends() const {
  const TriangleMesh& mesh = visibility_.mesh();
  const std::vector<BoundaryNode> nodes = boundary_nodes(mesh, visibility_.links());
  std::vector<std::uint8_t> is_bend(nodes.size(), 0);
  for (Index v = 0; v < nodes.size(); ++v) {
    const auto& [before, after, curves] = nodes[v];
    if (curves == 0) continue;
    is_bend[v] = curves > 1 || before == kNoIndex ||
                 orient2d(mesh.points[before], mesh.points[v], mesh.points[after]) <= 0;
  }
  return is_bend;
}

// A cone is lowest at a point behind an edge only if it is so where the line of sight crosses the
// edge: there no higher than a path from either end.
void GeodesicCoarseningFunction::spread_cones(std::span<const std::uint8_t> is_bend,
                                              ProgressMeter& meter) {
  const std::vector<Point2>& points = visibility_.mesh().points;
  std::vector<std::pair<double, Index>> queue;
  const auto push = [&](Index v) {
    queue.emplace_back(values_[v], v);
    std::push_heap(queue.begin(), queue.end(), std::greater<>());
  };
  for (Index v = 0; v < values_.size(); ++v)
    if (is_bend[v] || values_[v] == own_[v]) push(v);
  SightCones sight(visibility_);
  while (!queue.empty() && meter.step()) {
    std::pop_heap(queue.begin(), queue.end(), std::greater<>());
    const auto [weight, q] = queue.back();
    queue.pop_back();
    if (weight != values_[q]) continue;
    const auto height = [&, weight = weight, q = q](Index v) {
      return weight + distance(points[q], points[v]);
    };
    const auto may_be_lowest = [&](Index a, Index b) {
      const double length = distance(points[a], points[b]);
      return height(b) < values_[a] + length && height(a) < values_[b] + length;
    };
    sight.spread(q, may_be_lowest, [&](Index v) {
      meter.step();
      if (!(height(v) < values_[v])) return;
      values_[v] = height(v);
      if (is_bend[v]) push(v);
    });
  }
}

// What is lowest at its own node, and bends, with f for their weight: no other cone is the lowest
// anywhere by more than these are.
std::vector<double> GeodesicCoarseningFunction::weights_of_sources(
    std::span<const std::uint8_t> is_bend) const {
  std::vector<double> weights = values_;
  for (Index v = 0; v < weights.size(); ++v)
    if (!is_bend[v] && values_[v] != own_[v]) weights[v] = std::numeric_limits<double>::infinity();
  return weights;
}

std::vector<double> geodesic_coarsened_spacing(const Visibility& visibility, const Graph& graph,
                                               std::span<const double> spacing, double factor,
                                               const Progress& progress) {
  return GeodesicCoarseningFunction(visibility, graph, spacing, factor, progress).at_nodes();
}

}  // namespace wellspaced
