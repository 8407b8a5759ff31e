// Points placed on a segment.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The point of segment ab at the fraction `t` of its way: one coordinate is rounded freely, the
/// other is the double nearest to the segment there. So it lies within half a unit in the last
/// place of the segment, wherever that runs.
/// Requires: a != b, 0 <= t <= 1, an extent that is a double.
/// Cost: a few exact comparisons.
Point2 point_on_segment(Point2 a, Point2 b, double t);

}  // namespace wellspaced
