// The boundary of a domain, cut into pieces: what points are packed within.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A piece of a segment of the domain, which becomes an edge of the mesh.
struct BoundaryPiece {
  Index a = 0, b = 0;        ///< points
  Index segment = kNoIndex;  ///< whose piece it is; kNoIndex: the chord that cuts off a corner
  bool is_fixed = false;     ///< no further point may be put on it
};

/// points: those of the domain first, then those put on segments.
/// segments: the domain's, whole; pieces: what they are cut into.
/// sharp: the points at which two segments meet at less than 60 degrees, ascending. Segments that
///   end there are split at powers of two from it: on concentric shells, so that the pieces of one
///   do not split those of the other without end.
struct PackedBoundary {
  std::vector<Point2> points;
  std::vector<Segment> segments;
  std::vector<BoundaryPiece> pieces;
  std::vector<Index> sharp;
};

}  // namespace wellspaced
