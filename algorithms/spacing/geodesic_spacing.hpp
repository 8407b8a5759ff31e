// Coarsening functions in the geodesic metric: distances inside the domain (Definition 2.2.6).
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/mesh/visibility.hpp"
#include "wellspaced/algorithms/spacing/site_tree.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The coarsening function f_{g,C,P}(x) = min over all nodes q of C g(q) + d(q, x), d the length of
/// a shortest path inside the domain, around holes and slits. 1-Lipschitz in d, and the greatest
/// such function that is at most C g at the nodes. Between the Euclidean function and the one in
/// the graph metric, the latter of which bounds the search for it.
///
/// A shortest path is straight but for bends at nodes where the boundary is not convex. So bends
/// are cones as nodes are, with f for their weight, and f(x) is the nearest cone that x sees; the
/// bends' own values are found by repetition, once for each bend that a path takes in turn.
class GeodesicCoarseningFunction {
 public:
  /// graph: of the mesh. spacing: g, one value >= 0 a node. factor: C > 0.
  /// Requires: the Visibility outlives the function. Cost: O(n log n) and a query for each bend, a
  /// few times over.
  GeodesicCoarseningFunction(const Visibility& visibility, const Graph& graph,
                             std::span<const double> spacing, double factor);

  /// f at the nodes; at a node in no triangle it is that of the graph metric.
  /// Cost: a query a node, each with few lines of sight where few cones are hidden.
  std::vector<double> at_nodes() const;

  /// f(x) for a point x in the closed triangle `at` (see TriangleLocator).
  double operator()(Point2 x, Index at) const;

 private:
  template <class Sees>
  double lowest_seen(Point2 x, double bound, Sees sees) const;
  double at_node(Index v) const;
  std::vector<Index> bends() const;
  void settle_bends();

  const Visibility& visibility_;
  std::vector<double> graph_values_;
  SiteTree cones_;
};

/// f_{g,C,P} at the nodes. See GeodesicCoarseningFunction.
std::vector<double> geodesic_coarsened_spacing(const Visibility& visibility, const Graph& graph,
                                               std::span<const double> spacing, double factor);

}  // namespace wellspaced
