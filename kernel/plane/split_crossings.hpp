// Makes the crossings of segments vertices, rounded to doubles that provably keep everything valid.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/bend_chains.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/plane/segment_network.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// delaunay: the constrained Delaunay triangulation of the points and the crossings, which are
/// numbered behind them. edges: those of each segment.
struct SplitGraph {
  Delaunay2 delaunay;
  SegmentEdges edges;
};

/// Splits the segments at their crossings.
///
/// Which crossings coincide, and their order along each segment, is decided exactly. Each distinct
/// crossing becomes one point within 2 units in the last place of it, and within the points' hull
/// where a double there is, such that the result is a triangulation; that is proven by building it.
///
/// First a rounding is sought that changes nothing but coordinates: no two crossings at one point,
/// none on an input point, no vertex on a segment that does not exactly lie on it. Each crossing in
/// the way moves to its next rounding, some 25 times; then to one by chance, as often and, for few
/// points, a few thousand times. Where none is found, every crossing goes to its nearest double,
/// those that meet there are one vertex, and segments that then cross are bent (bend_chains.hpp).
///
/// progress: phases "split" and "bend".
/// Errors: kInvalidGeometry with the ids of two segments that cannot be bent apart; kCancelled.
/// Cost: O(k log k) exact comparisons for k crossings, and a triangulation for each attempt.
Result<SplitGraph> split_at_crossings(std::span<const Point2> points,
                                      std::span<const Segment> segments,
                                      const SegmentNetwork& network, const Progress& progress = {});

}  // namespace wellspaced
