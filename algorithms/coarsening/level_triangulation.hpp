// The triangles of a level: a constrained Delaunay triangulation inside a directed boundary.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// An edge that the triangulation must have. kDomain: the domain lies on its left, and not on its
/// right. kInner: what lies on its sides does not depend on it.
struct ConstrainedEdge {
  enum class Kind : std::uint8_t { kDomain, kInner };
  Index a = 0, b = 0;
  int marker = 0;
  Kind kind = Kind::kDomain;
};

struct DomainTriangulation {
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise
  std::vector<Segment> segments;                ///< the constrained edges, in the given order
};

/// The constrained Delaunay triangulation of points inside the domain that the edges bound.
///
/// A triangle is inside when the kDomain edges wind around it: outside of everything the winding
/// number is 0, and it rises by 1 from the right of an edge to its left. So holes stay out, and
/// edges that are there in both directions, as where a hole has closed, separate nothing.
/// Points with equal coordinates (the two lips of a slit) are triangulated as one; each triangle
/// then gets the point that the edges of its own side name.
/// Requires: edge ends are valid; the kDomain edges form closed curves.
/// Returns: an edge that passes through a further point appears in pieces. Points outside are in
///   no triangle. Fewer than 3 points, or collinear ones: no triangles.
/// Errors: those of Delaunay2::build; kInvalidGeometry where edges cross (ids: their ends).
/// along_curve: the point numbers in order along a curve, if the caller has them so; else empty. To
///   make one for the finest level and hand it down takes longer than to sort each level.
/// progress: phase "triangulate", where along_curve is empty.
/// Cost: O(n log n) expected; in practice linear, and without a sort if along_curve is given.
/// See: section 8.2 step 4, CHOICES 16.
Result<DomainTriangulation> triangulate_domain(std::span<const Point2> points,
                                               std::span<const ConstrainedEdge> edges,
                                               std::span<const Index> along_curve = {},
                                               const Progress& progress = {});

}  // namespace wellspaced
