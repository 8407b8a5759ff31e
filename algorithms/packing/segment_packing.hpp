// Packing points on segments: the one-dimensional step of PACKING.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The radius of the point-ball at a point of the domain: positive.
using BallRadius = std::function<double(Point2)>;

/// The part of segment ab between two fractions of its way.
struct SegmentPart {
  Point2 a, b;
  double from = 0, to = 1;

  double length() const;
  /// The point at the fraction t, rounded to doubles beside the segment; a and b themselves.
  Point2 at(double t) const;
  /// The same but for the rounding of two sums, in no time.
  Point2 beside(double t) const;
};

/// The points to put on a part of a segment, in order, so that all point-balls on it are disjoint,
/// those of its ends too where these are, and none fits around the middle of a gap.
///
/// They are spread evenly, in units of the radius, about 2.4 radii apart.
/// Errors: kUsage where the radius is not positive or not a number; kLimit for more than
///   `most_points`.
/// Requires: a != b, 0 <= from < to <= 1. Cost: linear in the points.
/// See: Figure 4.3, i = 1.
Result<std::vector<Point2>> pack_segment(const SegmentPart& part, const BallRadius& radius,
                                         std::size_t most_points);

}  // namespace wellspaced
