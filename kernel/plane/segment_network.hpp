// Who crosses whom: the vertices on each segment of a planar straight-line graph, and all
// crossings.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Two segments that cross at a point that is no input point and inner to both. A piece of a
/// segment runs from one vertex on it to the next; `piece` counts them from the segment's start.
struct SegmentCrossing {
  std::array<Index, 2> segment;  ///< ascending
  std::array<Index, 2> piece;
  friend bool operator==(const SegmentCrossing&, const SegmentCrossing&) = default;
  friend bool operator<(const SegmentCrossing& x, const SegmentCrossing& y) {
    return x.segment < y.segment || (x.segment == y.segment && x.piece < y.piece);
  }
};

/// paths: for each segment the vertices on it, from its start to its end; one for a segment without
/// length. crossings: every pair once, ascending.
struct SegmentNetwork {
  std::vector<std::vector<Index>> paths;
  std::vector<SegmentCrossing> crossings;
};

/// Finds all vertices on all segments and all crossings, exactly.
///
/// Requires: the points span a plane (Delaunay2::dimension() == 2) and segment ends are points.
/// progress: phase "cross".
/// Errors: those of Delaunay2::build; kCancelled.
/// Cost: in rounds, each of which triangulates the points with a maximal set of the remaining
/// segments that cross none of each other; as many rounds as segments at the worst.
Result<SegmentNetwork> segment_network(std::span<const Point2> points,
                                       std::span<const Segment> segments,
                                       const Progress& progress = {});

}  // namespace wellspaced
