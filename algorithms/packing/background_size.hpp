// A size function from values at the points of a background mesh.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Interpolates sizes linearly over the Delaunay triangles of the points. First each value is
/// lowered to the smallest of value + distance over all points, so that from point to point it
/// grows by at most 1 per unit of length; beyond the hull it is this smallest sum itself.
/// Copies are independent, but one copy must not be asked from two threads at once: it remembers
/// where it was asked last.
class BackgroundSize {
 public:
  /// values: one a point, positive and finite.
  /// Errors: kUsage for another number of values or a value that is not positive and finite (ids:
  /// the points), or without points; those of Delaunay2::build.
  /// Cost: O(n log n).
  static Result<BackgroundSize> build(std::span<const Point2> points,
                                      std::span<const double> values);

  /// The size at x: positive. Cost: O(1) expected near the last place, else O(sqrt n).
  double operator()(Point2 x);

 private:
  BackgroundSize(Delaunay2 delaunay, EuclideanCoarseningFunction envelope)
      : delaunay_(std::move(delaunay)), envelope_(std::move(envelope)) {}

  Delaunay2 delaunay_;
  EuclideanCoarseningFunction envelope_;
  std::vector<double> sizes_;
  Index last_ = 0;
};

}  // namespace wellspaced
