// Packing points in the interior of a domain whose boundary is packed: PACKING's last step.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "wellspaced/algorithms/packing/packed_boundary.hpp"
#include "wellspaced/algorithms/packing/segment_packing.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// When a packing counts as maximal.
enum class Maximality {
  kDelaunay,  ///< no circumcentre of a triangle can be added
  kFull       ///< no point at all can be added
};

/// Where in a triangle with room for it a ball is put.
enum class BallPlacement {
  kCircumcentre,  ///< in the middle of the gap: few points
  kKissing,  ///< touching the balls of the shortest edge, if it fits: more points, tightly packed
  kGeneric   ///< a little beside the middle, by chance, so that no four points lie on one circle
};

/// What the domain is at some place.
struct Zone {
  bool is_inside = true;
  double attribute = 0;
  double max_area = std::numeric_limits<double>::infinity();  ///< of its triangles
};

/// radius: of the point-balls. slope: it grows by at most this much per unit of length; infinite if
///   nothing is known.
/// zone_at: called once with a point of each region that segments enclose.
/// smallest_angle_deg: triangles with smaller angles are cut, too, by points nearer together than
///   their balls; 0: none are. Up to 20.7 this is proven to end with no such triangle where the
///   boundary's angles are at least 60 degrees; it always ends, and up to 30 it seldom leaves one.
/// is_far: whether a point is at least a distance, > 0, from what balls must keep twice their
///   radius away from; empty: there is no such thing.
/// max_points: where to stop. progress: phases "start", where stopping is an error, and "pack",
///   where it leaves a packing that is not maximal; done: points.
struct InteriorOptions {
  BallRadius radius;
  std::function<bool(Point2, double)> is_far;
  double slope = std::numeric_limits<double>::infinity();
  std::function<Zone(Point2)> zone_at;
  double smallest_angle_deg = 25;
  Maximality maximality = Maximality::kDelaunay;
  BallPlacement placement = BallPlacement::kCircumcentre;
  std::size_t max_points = std::size_t{1} << 26;
  Progress progress;
};

/// mesh: points, those of the boundary first, in its order; the triangles inside; and the pieces of
///   the domain's segments at them, segment by segment, each from its start.
/// boundary_point: for each mesh point which point of the boundary it is; kNoIndex for new ones.
/// radius: of each mesh point's ball. attributes: of each triangle's zone.
/// balls_packed: how many interior points have a ball of their own; the others cut bad triangles.
/// is_complete: false if max_points or the progress callback put an end to it (was_cancelled).
struct PackedInterior {
  TriangleMesh mesh;
  std::vector<Index> boundary_point;
  std::vector<double> radius;
  std::vector<double> attributes;
  std::size_t balls_packed = 0;
  bool is_complete = true;
  bool was_cancelled = false;
};

/// Packs the interior.
///
/// First circumcentres are added to the constrained Delaunay triangulation of the boundary as long
/// as the ball around one is disjoint from all others, and the centre outside the diametral circles
/// of the pieces (the protective circles). Then triangles with an angle too small are cut, by the
/// point nearest to their shortest edge that makes no bad triangle with it (the off-centre of
/// Uengoer); where that would lie in a protective circle, the piece is split instead.
///
/// Errors: kInvalidGeometry where pieces cross; those of Delaunay2::build; kCancelled at the start.
/// Requires: radius and zone_at are set.
/// Cost: O(n log n) expected for n points, and a radius for each of them and for some triangles.
/// See: Figure 4.3, i = 2; section 4.5.
Result<PackedInterior> pack_interior(const PackedBoundary& boundary,
                                     const InteriorOptions& options);

}  // namespace wellspaced
