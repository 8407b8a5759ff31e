// Proves that triangles do not overlap, by the winding number of their common boundary.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// An edge of the boundary chain, with its triangle on its left.
struct ChainEdge {
  Point2 from, to;
  Index from_node = 0, to_node = 0;
};

/// at_most_once: no point is covered twice.
/// hanging_nodes: nodes in the interior of a chain edge. Complete if at_most_once.
struct WindingVerdict {
  bool at_most_once = true;
  std::vector<Index> hanging_nodes;
};

/// Decides, exactly, whether triangles overlap, from their boundary chain alone.
///
/// The claim. Take any set of triangles, each counter-clockwise. The number d(x) of triangles that
/// contain a point x on none of their edges is the winding number about x of the sum of their
/// boundaries, because each triangle's boundary winds once about its inside and not at all about
/// its outside, and winding numbers add. Pairs of edges that cancel, (u, v) and (v, u), may be left
/// out of the sum. So the interiors are pairwise disjoint if and only if the winding number of what
/// is left, the chain, is at most 1 everywhere. Nothing is assumed about how the triangles hang
/// together: several components, slits, sheets, gluing at a node, spirals are all covered.
///
/// The proof on the instance. A line sweeps the plane in lexicographic order of points (so no edge
/// is vertical), keeping the chain edges that it meets in their order, coincident ones in a bundle,
/// and with each bundle the winding number above it. Neighbours on the line are tested for a
/// proper crossing when they become neighbours. If no test fails, the order kept is right until the
/// end (Shamos and Hoey 1976), every face of the arrangement was a gap just after the event at its
/// lexicographically first point, and the winding numbers of all gaps were checked. If two chain
/// edges do cross properly at x, the triangles on their left both contain a half disc about x, and
/// two half discs on different lines overlap. So the verdict is right either way.
///
/// Requires: finite coordinates; no edge with from == to; the chain is a sum of boundaries of
/// counter-clockwise triangles less cancelling pairs.
/// Cost: O(n log n) for n chain edges; a chain edge with k hanging nodes counts k + 1 times.
WindingVerdict cover_at_most_once(std::span<const ChainEdge> chain);

}  // namespace wellspaced::audit
