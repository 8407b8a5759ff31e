// A size function in space from values at the points of a background mesh.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/packing/space/far_points.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced {

/// Interpolates sizes linearly over the Delaunay tets of the points. First each value is lowered to
/// the smallest of value + slope * length over all paths along Delaunay edges. Beyond the hull of
/// the points sizes grow with the distance by about the slope.
/// Copies are independent, but one copy must not be asked from two threads at once: it remembers
/// where it was asked last.
class BackgroundSize3 {
 public:
  /// values: one a point, positive and finite; of points that coincide the smallest counts.
  /// slope: positive.
  /// Errors: kUsage for another number of values, a value that is not positive and finite (ids: the
  /// points), or without points; those of Delaunay3::build, also where the points are spread over
  /// nearly the whole range of doubles.
  /// Cost: O(n log n) expected for points in space of bounded density ratio.
  static Result<BackgroundSize3> build(std::span<const Point3> points,
                                       std::span<const double> values, double slope);

  /// The size at x: positive. Requires: x is finite. Cost: O(1) expected near the last place.
  double operator()(Point3 x);

  /// By how much the size grows at most per unit of length inside the hull of the points: more than
  /// the slope that was asked for where it changes across a flat tet. Cost: linear.
  double steepest() const;

  /// Whether x is inside the hull of the points, or on it. Requires: x is finite.
  bool covers(Point3 x) const;

 private:
  BackgroundSize3(Delaunay3 delaunay, std::vector<double> sizes)
      : delaunay_(std::move(delaunay)), sizes_(std::move(sizes)) {}

  bool is_far(Index v) const { return v >= sizes_.size() - kFarPoints; }

  Delaunay3 delaunay_;  // the far points come last
  std::vector<double> sizes_;
  Index last_ = 0;
};

}  // namespace wellspaced
