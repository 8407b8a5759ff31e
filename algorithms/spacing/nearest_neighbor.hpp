// The nearest neighbour function NN of a point set (Definition 2.2.4).
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/spacing/site_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// NN: at a point of the set its distance from the nearest other one; anywhere else the radius of
/// the smallest ball around the place that holds two of them. 1-Lipschitz, and the set is 2-spaced
/// by it (Lemma 2.4.2).
///
/// Neighbours are found exactly, whatever mesh the points belong to. Points at one place, as on the
/// two lips of a slit, count as one.
/// Degenerate: infinite where the set has fewer than two places.
class NearestNeighborFunction {
 public:
  /// Requires: finite points, at most kMaxOrderedPoints. Cost: O(n log n).
  explicit NearestNeighborFunction(std::span<const Point2> points);

  /// NN(x). Cost: as SiteTree's.
  double operator()(Point2 x) const;

  /// The nearest point to point v that lies elsewhere, the lowest of several; kNoIndex if none.
  Index neighbor_of(Index v) const;

  /// NN at the points of the set. progress: phase "spacing", in points.
  std::vector<double> at_points(const Progress& progress = {}) const;

 private:
  Index nearest_elsewhere(Point2 x, Point2 excluded) const;

  SiteTree tree_;
};

/// NN at the points of the set. See NearestNeighborFunction.
std::vector<double> nearest_neighbor_spacing(std::span<const Point2> points,
                                             const Progress& progress = {});

}  // namespace wellspaced
