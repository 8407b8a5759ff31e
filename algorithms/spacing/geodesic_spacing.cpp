#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"

#include <algorithm>
#include <limits>

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
                                                       double factor)
    : visibility_(visibility),
      graph_values_(coarsened_spacing(graph, spacing, factor)),
      cones_(visibility.mesh().points, scaled(spacing, factor)) {
  settle_bends();
}

std::vector<double> GeodesicCoarseningFunction::at_nodes() const {
  std::vector<double> values(cones_.size());
  cones_.for_each_along_curve([&](Index v) { values[v] = at_node(v); });
  return values;
}

double GeodesicCoarseningFunction::operator()(Point2 x, Index at) const {
  double bound = std::numeric_limits<double>::infinity();
  for (const Index v : visibility_.mesh().triangles[at])
    bound = std::min(bound, graph_values_[v] + distance(x, visibility_.mesh().points[v]));
  return lowest_seen(x, bound, [&](Index q) { return visibility_.sees(x, at, q); });
}

// The lowest cone over x of all that x sees; `bound` if they are higher. Mostly it is the lowest of
// all, and one line of sight says so.
template <class Sees>
double GeodesicCoarseningFunction::lowest_seen(Point2 x, double bound, Sees sees) const {
  Index q = cones_.nearest(x, bound, [](Index) { return true; });
  if (q != kNoIndex && !sees(q)) q = cones_.nearest(x, bound, sees);
  return q == kNoIndex ? bound : std::min(bound, weighted_distance(cones_.site(q), x));
}

double GeodesicCoarseningFunction::at_node(Index v) const {
  return lowest_seen(visibility_.mesh().points[v], graph_values_[v],
                     [&](Index q) { return visibility_.sees(v, q); });
}

// Nodes where the domain takes up more than a half turn, or where several curves meet.
std::vector<Index> GeodesicCoarseningFunction::bends() const {
  const TriangleMesh& mesh = visibility_.mesh();
  const std::vector<BoundaryNode> nodes = boundary_nodes(mesh, visibility_.links());
  std::vector<Index> result;
  for (Index v = 0; v < nodes.size(); ++v) {
    const auto& [before, after, curves] = nodes[v];
    if (curves == 0) continue;
    if (curves > 1 || before == kNoIndex ||
        orient2d(mesh.points[before], mesh.points[v], mesh.points[after]) <= 0)
      result.push_back(v);
  }
  return result;
}

// A path takes each bend once, so there are no more rounds than bends.
void GeodesicCoarseningFunction::settle_bends() {
  const std::vector<Index> bent = bends();
  for (const Index v : bent) cones_.lower_weight(v, graph_values_[v]);
  bool lowered = true;
  for (std::size_t round = 0; lowered && round < bent.size(); ++round) {
    lowered = false;
    for (const Index v : bent) {
      const double value = at_node(v);
      if (!(value < cones_.site(v).weight)) continue;
      cones_.lower_weight(v, value);
      lowered = true;
    }
  }
}

std::vector<double> geodesic_coarsened_spacing(const Visibility& visibility, const Graph& graph,
                                               std::span<const double> spacing, double factor) {
  return GeodesicCoarseningFunction(visibility, graph, spacing, factor).at_nodes();
}

}  // namespace wellspaced
