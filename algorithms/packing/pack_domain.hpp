// PACKING in the plane: a well-spaced conforming mesh of a domain.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wellspaced/algorithms/packing/corner_shells.hpp"
#include "wellspaced/algorithms/packing/interior_packing.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// How far apart nodes should be at a point: positive; it should grow by at most 1 per unit of
/// length, or the angles suffer, nothing else.
using SizeFunction = std::function<double(Point2)>;

/// What becomes of corners below 60 degrees.
enum class SharpCorners {
  kRefuse,  ///< an error that lists them
  kMesh     ///< meshed as well as it goes
};

/// beta: the point-ball of a node p has the radius lfs(p) / beta, lfs the local feature size; at
///   least 2. From 3 + 2 sqrt 2 on the thesis bounds the angles for any domain without sharp
///   corners; the larger, the better the angles and the more the nodes.
/// size: lowers the spacing: balls are no larger than size / 2, so where it is constant nodes are
///   at least that far apart and at most about 1.7 times as far. Empty: not lowered.
/// smallest_angle_deg, maximality, placement, max_points: as in InteriorOptions.
/// progress: phases "prepare" and "start", where stopping is an error, and "pack", where it leaves
///   a mesh that is valid, but not as fine as asked for; done: points.
struct PackingOptions {
  double beta = 2;
  SizeFunction size;
  double smallest_angle_deg = 25;
  Maximality maximality = Maximality::kDelaunay;
  BallPlacement placement = BallPlacement::kCircumcentre;
  SharpCorners sharp_corners = SharpCorners::kRefuse;
  HoleRule holes = HoleRule::kParity;
  CrossingRule crossings = CrossingRule::kRefuse;
  std::size_t max_points = std::size_t{1} << 26;
  Progress progress;
};

/// mesh: the domain's points first, those that are in it, then new ones; segments with the markers
///   of the domain's, whose pieces they are; points on a segment have its marker, too, if the
///   domain has point markers.
/// domain_point: for each node, which point of the domain it is; kNoIndex for new ones.
/// attributes: of the region that each triangle is in; empty for a domain without regions.
/// radius: for each node that of a ball, lfs / beta or size / 2; see packed_spacing.
/// sharp_corners: those below 60 degrees, in the domain's points. without_guarantee: the triangles
///   with an angle below smallest_angle_deg.
/// is_complete, was_cancelled: as in PackedInterior; an incomplete mesh is valid all the same.
/// notes: what a user should know of the domain, one line each.
struct PackedMesh {
  TriangleMesh mesh;
  std::vector<Index> domain_point;
  std::vector<double> attributes;
  std::vector<double> radius;
  std::vector<Corner> sharp_corners;
  std::vector<Index> without_guarantee;
  std::size_t segment_points = 0, balls_packed = 0;
  bool is_complete = true, was_cancelled = false;
  std::vector<std::string> notes;
};

/// Meshes a domain by increasing dimension: its vertices, then each segment, then the interior,
/// each packed with balls until no more fit (pack_segment, pack_interior).
///
/// Corners below 30 degrees are cut off by a shell around their apex: the triangle behind it keeps
/// the small angle, and what is left of the domain has none. At corners below 60 segments are split
/// at powers of two from the apex.
///
/// Errors: kUsage for an option out of its range, or a size that is not positive; kInvalidGeometry
///   for a domain without area (ids: points), segments that enclose nothing (ids: their loose
///   ends), that cross (ids: pairs of segments), or meet at less than 60 degrees (ids: the apices,
///   unless sharp_corners is kMesh), with features closer together than doubles can tell (ids: the
///   ends of the segment there), or so small that triangles would be flat; those of triangulate; kLimit where the boundary alone needs
///   more than max_points; kCancelled before the interior is packed.
/// Cost: O(n log n) expected for n nodes and domain features.
/// Audit: embedding, constrained Delaunay, conformity, angles.
/// See: chapter 4; Definition 2.2.5.
Result<PackedMesh> pack_domain(const Pslg& domain, const PackingOptions& options = {});

/// The spacing function of a packed mesh: for each node a value f of a 1-Lipschitz function by
/// which the nodes are beta-spaced: beta times the ball's radius, or half of beta times the
/// distance of the nearest node where a triangle was cut or thin walls hide one, then lowered to be
/// 1-Lipschitz.
/// progress: phase "spacing".
/// Cost: O(n log n).
/// Audit: beta-spacing, gaps.
std::vector<double> packed_spacing(const PackedMesh& packed, double beta,
                                   const Progress& progress = {});

}  // namespace wellspaced
