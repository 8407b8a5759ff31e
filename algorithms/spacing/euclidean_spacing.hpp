// Coarsening functions in the Euclidean metric (Definition 5.3.2).
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/spacing/site_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The coarsening function f_{g,C,P}(x) = min over all q in P of C g(q) + |q - x|: a lower envelope
/// of cones, 1-Lipschitz, and the greatest such function that is at most C g on P.
/// See: Lemmas 5.4.1 to 5.4.4.
class EuclideanCoarseningFunction {
 public:
  /// spacing: g, one value >= 0 a point; infinite where g says nothing. factor: C > 0.
  /// progress: phase "spacing", in points.
  /// Requires: finite points, at most kMaxOrderedPoints.
  /// Cost: O(n log n), and the queries, one a point, of the cones that are lowest at their own
  /// apex: the others are the lowest nowhere.
  EuclideanCoarseningFunction(std::span<const Point2> points, std::span<const double> spacing,
                              double factor, const Progress& progress = {});

  /// f(x). The cone is chosen exactly, its value within 3 units in the last place. Infinite where
  /// no cone has a finite value. Cost: that of SiteTree::nearest: O(log n) where few cones are
  /// nearly as low as the lowest, as on meshes; all n at worst, as at the centre of a circle of
  /// them.
  double operator()(Point2 x) const;

  /// The point q that f(x) comes from; kNoIndex where f(x) is infinite.
  Index source(Point2 x) const { return tree_.nearest(x); }

  /// f at the points of P.
  const std::vector<double>& at_points() const { return values_; }

 private:
  std::vector<double> values_;  // f at the points of P
  SiteTree tree_;               // of the cones that are lowest at their own apex
};

/// f_{g,C,P} at the points of P. See EuclideanCoarseningFunction.
std::vector<double> euclidean_coarsened_spacing(std::span<const Point2> points,
                                                std::span<const double> spacing, double factor,
                                                const Progress& progress = {});

}  // namespace wellspaced
