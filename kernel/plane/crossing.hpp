// Exact statements about points where segments cross, which need not be doubles.
//
// A crossing is kept as the two segments that make it. All decisions are made on these, in integers
// (exact_predicates.hpp), for every finite double: three segments through one point give equal
// crossings, whichever two of them are taken. Only round_crossing leaves the exact world.
#pragma once

#include <array>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// How two closed segments meet.
enum class SegmentRelation {
  kDisjoint,  ///< in no point
  kTouch,     ///< in one point, an end of one or both
  kCross,     ///< in one point inner to both
  kOverlap    ///< in more than one point
};

/// How segment ab meets segment cd.
/// Degenerate: a segment whose ends coincide is a point, and at most touches.
SegmentRelation relate_segments(Point2 a, Point2 b, Point2 c, Point2 d);

/// The point that segments ab and cd share.
/// Requires: exactly one; so the segments are not parallel, though they may touch only.
struct Crossing {
  Point2 a, b, c, d;
};

/// The sign of orient2d(p, q, crossing): positive when the crossing lies to the left of the line
/// from p to q.
int orient2d(Point2 p, Point2 q, const Crossing& crossing);

/// The order by x, then by y: -1, 0 (the same point) or 1.
int compare_xy(const Crossing& p, const Crossing& q);
int compare_xy(const Crossing& p, Point2 q);

/// The doubles next to a crossing, each coordinate within 2 ulp of the exact one.
///
/// points[0 .. count - 1]: the nearest double point first (each coordinate rounded to nearest, ties
///   to even), then by the sum of the ranks of the two coordinates; a coordinate's ranks go from
///   the nearest double outward. One ulp is the distance between the doubles on either side of the
///   exact coordinate.
/// exact: the crossing is points[0].
struct RoundedCrossing {
  bool exact = false;
  int count = 0;
  std::array<Point2, 25> points;
};

/// Rounds a crossing. The nearest point always exists: it lies in the box of either segment.
/// Cost: about ten exact comparisons.
RoundedCrossing round_crossing(const Crossing& crossing);

}  // namespace wellspaced
