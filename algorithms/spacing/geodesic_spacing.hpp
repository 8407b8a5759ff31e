// Coarsening functions in the geodesic metric: distances inside the domain (Definition 2.2.6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/algorithms/mesh/visibility.hpp"
#include "wellspaced/algorithms/spacing/site_tree.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The coarsening function f_{g,C,P}(x) = min over all nodes q of C g(q) + d(q, x), d the length of
/// a shortest path inside the domain, around holes and slits. 1-Lipschitz in d, and the greatest
/// such function that is at most C g at the nodes. Between the Euclidean function and the one in
/// the graph metric, the latter of which bounds the search for it.
///
/// A shortest path is straight but for bends at nodes where the boundary is not convex. So bends
/// are cones as nodes are, with f for their weight. Dijkstra's algorithm takes the cones by weight,
/// and spreads each as far as it is seen and may be the lowest.
class GeodesicCoarseningFunction {
 public:
  /// graph: of the mesh. spacing: g, one value >= 0 a node. factor: C > 0.
  /// progress: phase "spacing", in nodes seen; how many there will be is not known.
  /// Requires: the Visibility outlives the function.
  /// Cost: O(k log k), k >= n: for each cone the triangles where it comes out lowest, by what is
  /// known when its turn comes, and those around them.
  GeodesicCoarseningFunction(const Visibility& visibility, const Graph& graph,
                             std::span<const double> spacing, double factor,
                             const Progress& progress = {});

  /// f at the nodes; at a node in no triangle it is that of the graph metric.
  const std::vector<double>& at_nodes() const { return values_; }

  /// f(x) for a point x in the closed triangle `at` (see TriangleLocator).
  /// Cost: a query of the cones, with a line of sight to each that would be lower.
  double operator()(Point2 x, Index at) const;

 private:
  std::vector<std::uint8_t> bends() const;
  void spread_cones(std::span<const std::uint8_t> is_bend, ProgressMeter& meter);
  std::vector<double> weights_of_sources(std::span<const std::uint8_t> is_bend) const;

  const Visibility& visibility_;
  std::vector<double> own_;     // C g
  std::vector<double> values_;  // f, at most what the graph metric gives
  SiteTree cones_;
};

/// f_{g,C,P} at the nodes. See GeodesicCoarseningFunction.
std::vector<double> geodesic_coarsened_spacing(const Visibility& visibility, const Graph& graph,
                                               std::span<const double> spacing, double factor,
                                               const Progress& progress = {});

}  // namespace wellspaced
