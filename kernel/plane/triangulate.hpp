// The constrained Delaunay triangulation of a planar straight-line graph, whatever its segments do.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Which triangles of the convex hull belong to the domain.
enum class HoleRule {
  kNone,    ///< all of them
  kParity,  ///< those an odd number of segments deep: the fewest that separate them from infinity
  kSeeds,   ///< those enclosed by segments, but for the regions that hold a point of Pslg::holes
  kOuter    ///< those enclosed by segments
};

/// What becomes of segments that cross in their interiors.
enum class CrossingRule {
  kSplit,  ///< the crossing becomes a vertex of both
  kRefuse  ///< an error that lists every pair
};

struct TriangulateOptions {
  HoleRule holes = HoleRule::kParity;
  CrossingRule crossings = CrossingRule::kSplit;
  Progress progress = {};  ///< phases "triangulate" (points), "constrain" (segments), where they
                           ///< cross "cross", "split" and "bend", at the end "domain"
  unsigned threads = 1;    ///< as in Delaunay2::Options
};

/// The triangulation of a planar straight-line graph.
///
/// delaunay: the triangulation of the convex hull, constrained by the segments; its points are the
/// input's, in order, then the added crossings, ascending by their exact x, then y (one that was
/// rounded onto another point is a duplicate of it). in_domain: one entry a triangle of its
/// topology, 0 for ghosts and for triangles outside the domain. segments: the constrained edges,
/// each once, a < b, ascending. The marker is that of the input segment, the largest where several
/// overlap. Below dimension 2 there is no triangle, but segments are split at the points on them
/// all the same.
struct PlanarTriangulation {
  Delaunay2 delaunay;
  std::vector<std::uint8_t> in_domain;
  std::vector<Segment> segments;
  Index added_points = 0;

  /// The triangles of the domain, counter-clockwise.
  std::vector<std::array<Index, 3>> triangles() const;
};

/// The constrained Delaunay triangulation of `graph`.
///
/// Segments may run through points, overlap, touch, repeat, have no length, and cross. All
/// decisions are exact. A crossing of segments that is no double is rounded: concurrent segments
/// share one vertex all the same, it lies within 2 units in the last place of the exact point, and
/// the result is a valid triangulation in which every input segment is a chain of edges. Where
/// rounding to the nearest doubles would break that, other doubles within 2 units are tried. Where
/// none of those tried will do, as among segments nearly along one line, crossings may share a
/// double or lie on an input point, and segments are bent: their edges still connect their ends,
/// through vertices within two doubles of the exact segment. An input point that no segment ends at
/// may then change sides. Winding never matters.
///
/// Errors: kInvalidGeometry for a coordinate that is not finite (ids: points), a segment whose end
/// is no point (ids: segments), with kRefuse for crossings (ids: the segments of each pair in
/// turn), with kSplit where segments cannot be bent apart (ids: two segments; not seen so far).
/// kLimit beyond 2^28 points, crossings included. kCancelled.
/// Cost: O(n log n) expected for n points, plus the triangles that segments cross.
/// Audit: constrained_delaunay, embedding, conformity.
Result<PlanarTriangulation> triangulate(const Pslg& graph, const TriangulateOptions& options = {});

}  // namespace wellspaced
