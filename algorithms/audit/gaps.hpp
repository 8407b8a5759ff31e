// How large the gaps between points are, by the measure of a spacing function: brackets, proven.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/boundary_pieces.hpp"
#include "wellspaced/algorithms/audit/spacing_tree.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// A gap at x (Definitions 2.3.1, 2.3.2 and 3.1.2) is a ball around some c with x on its surface
/// and no point of the set inside, c and x seeing each other inside the domain. Its parameter is |x
/// - c| / f(x). The bracket holds the largest parameter of all gaps of a kind.
///
/// lower: the parameter of a gap that exists: the ball around `centre` with `at` on its surface.
/// upper: no gap has a larger one.
template <std::size_t D>
struct GapBracket {
  double lower = 0, upper = 0;
  Vec<D> centre{}, at{};
};

/// A point set with its spacing function in a domain.
///
/// delaunay: the Delaunay triangulation of the points, any of several.
/// tolerance: brackets are narrowed until upper <= (1 + tolerance) lower, or the budget is spent.
/// progress: phase "audit", in steps of the search; how many there will be is not known.
template <std::size_t D>
struct SpacedPoints {
  std::span<const Vec<D>> places;
  const SpacingTree<D>& spacing;
  std::span<const std::array<Index, D + 1>> delaunay;
  const BoundaryPieces<D>& boundary;
  double tolerance = 0.05;
  Progress progress = {};
};

/// Interior gaps: centres anywhere in the domain.
///
/// Why a finite search suffices. Let d(c) be the distance of c from the nearest point. On the way
/// from c to the surface of a ball of radius r <= d(c) the quotient r / (f_q + |x - q|) only grows,
/// for every q, and is largest towards q; so the gaps around c have parameters up to
/// G(c) = d / (f - d) at c, and that one if x can be seen. On a line inside the Voronoi cell of p,
/// |c - p| / (f_q + |c - q| - |c - p|) falls, then rises, because |c - q| >= |c - p| there; so G is
/// largest at ends of lines: at Voronoi vertices in the domain, or on its boundary. The vertices
/// are circumcentres of Delaunay simplices, looked at one by one, with bounds on how far rounding
/// has moved them. The boundary is searched by halving it: in a ball of radius e around c,
/// G <= (d + e) / min f over the ball of radius d + 2e; and in a part of it that one or two Voronoi
/// cells cover, G is largest at corners of their shares of it.
/// G counts x that are hidden, for a centre close by may see them. So the upper end is too high
/// where f is small because of points that the domain hides from its largest gaps, as across
/// narrow fjords of a coast.
/// Cost: O(n log n) and the search of the boundary.
template <std::size_t D>
GapBracket<D> interior_gap(const SpacedPoints<D>& points);

/// Boundary-face gaps: centres and x on one face of the domain, a piece of its boundary; empty of
/// points on that face, whatever lies beside it. Found by halving the boundary: on a face that is
/// one triangle the places x, each with the farthest centre from which no corner is nearer; on
/// others the centres, where an x beside the face is not told from one on it. The gap of the lower
/// end lies in one triangle of the boundary.
GapBracket<3> face_gap(const SpacedPoints<3>& points);

/// Boundary-segment gaps: centres and x on one segment, empty of points on it. The segments are
/// given edge by edge, as the points divide them.
template <std::size_t D>
GapBracket<D> segment_gap(const SpacedPoints<D>& points,
                          std::span<const std::array<Index, 2>> edges);

}  // namespace wellspaced::audit
