// Makes the crossings of segments vertices, rounded to doubles that provably keep everything valid.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/plane/segment_network.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// delaunay: the constrained Delaunay triangulation of the points and the crossings, which are
/// numbered behind them. chains: for each segment the vertices along it.
struct SplitGraph {
  Delaunay2 delaunay;
  std::vector<std::vector<Index>> chains;
};

/// Splits the segments at their crossings.
///
/// Which crossings coincide, and their order along each segment, is decided exactly. Each distinct
/// crossing becomes one point, at the doubles nearest to it where the result is then a
/// triangulation: no crossing outside the points' hull, no chains that cross, no two crossings at
/// one point. Where they do, the crossings at fault are moved to other doubles within 2 units in
/// the last place, and only if these will not do onto an input point there.
///
/// First each crossing at fault moves to its next rounding, some 25 times; then to one by chance,
/// as often and, for few points, a few thousand times.
///
/// Errors: kInvalidGeometry with the ids of two segments that cross where all these doubles lie
/// outside the hull, or that no rounding tried keeps apart: the message says which.
/// Cost: O(k log k) exact comparisons for k crossings, and a triangulation for each attempt.
Result<SplitGraph> split_at_crossings(std::span<const Point2> points,
                                      std::span<const Segment> segments,
                                      const SegmentNetwork& network);

}  // namespace wellspaced
