// Lays chains of vertices into a triangulation, bent where rounding made them cross.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// For each segment the constrained edges that represent it.
using SegmentEdges = std::vector<std::vector<std::array<Index, 2>>>;

/// Makes the pieces of chains constrained edges; of two pieces that cross, bends one through an end
/// of the other, as snap rounding does.
///
/// delaunay: triangulates the segments' ends and all that the chains pass; without constraints.
/// chains: for each segment the vertices that should lie on it, from its start to its end, some of
/// them rounded. A piece is bent only through a vertex within two doubles in each coordinate of all
/// the exact segments that run along the piece.
///
/// Returns the edges: for each segment they connect its ends, but in no order, and with spurs where
/// it had to be bent back.
/// Requires: delaunay.dimension() == 2; a chain begins and ends at its segment's ends.
/// progress: phase "bend".
/// Errors: kInvalidGeometry where no vertex is near enough (ids: two segments that stay crossed);
/// kCancelled. Then `delaunay` is left as far as it came.
/// Cost: that of insert_constraint for each piece and each bend, and the logarithm of their number.
Result<SegmentEdges> bend_chains(Delaunay2& delaunay, std::span<const Segment> segments,
                                 const std::vector<std::vector<Index>>& chains,
                                 const Progress& progress = {});

}  // namespace wellspaced
