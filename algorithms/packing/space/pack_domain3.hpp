// PACKING in space: a well-spaced conforming tetrahedral mesh of a domain.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "wellspaced/algorithms/packing/coplanar_facets.hpp"
#include "wellspaced/algorithms/packing/interior_packing.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// How far apart nodes should be at a point: positive.
using SizeFunction3 = std::function<double(Point3)>;

/// beta: the point-ball of a node p has the radius lfs(p) / beta, lfs the local feature size; more
///   than 3. The larger, the better the tets and the more the nodes.
/// size: lowers the spacing: balls are no larger than size / 2. Empty: not lowered.
/// size_slope: the size grows by at most this much per unit of length; infinite if nothing is
///   known. Only up to 2 / beta is there a guarantee.
/// maximality: until no circumcentre, or no point at all, can be added to a facet or solid.
/// flatness: the tolerance for planes and right angles; 0 to 0.001.
/// max_points: where to stop.
/// progress: first phases "flatten", "check", "surface" and "triangulate", where stopping is an
///   error; then "pack", where it leaves a mesh that conforms, but is not as fine as asked for;
///   done: points.
struct PackingOptions3 {
  double beta = 10;
  SizeFunction3 size;
  double size_slope = std::numeric_limits<double>::infinity();
  Maximality maximality = Maximality::kDelaunay;
  double flatness = kFlatness;
  std::size_t max_points = std::size_t{1} << 26;
  Progress progress;
};

/// The bound of Theorem 4.3.7 on circumradius / shortest edge: 2 beta / (beta - 7 - 2 sqrt 2). None
/// where beta is not above 7 + 2 sqrt 2.
std::optional<double> radius_edge_bound(double beta);

/// The smallest beta whose bound is at most rho; none unless rho > 2.
std::optional<double> beta_for_radius_edge(double rho);

/// mesh: the domain's points first, those that are in it, then new ones. facets: the triangles that
///   the domain's facets are cut into, with their markers; segments: what its segments and the
///   edges of its facets are cut into, with the markers of segments.
/// domain_point: for each node, which point of the domain it is; kNoIndex for new ones.
/// facet_of: for each mesh facet the facet of the domain, the lowest of those that were merged.
/// domain_segments: the segments of the domain and the edges of its facets, each once, by points of
///   the domain, ascending. segment_of: for each mesh segment which of them.
/// region_of: for each tet the domain's region in whose solid it is; kNoIndex: none.
/// radius: for each node that of its ball.
/// is_complete, was_cancelled: false and true where max_points or the progress callback put an end
///   to it; an incomplete mesh conforms all the same.
/// notes: what a user should know of the domain, one line each.
struct PackedTets {
  TetMesh mesh;
  std::vector<Index> domain_point, facet_of, segment_of, region_of;
  std::vector<Segment> domain_segments;
  std::vector<double> radius;
  std::size_t segment_points = 0, facet_points = 0, balls_packed = 0;
  bool is_complete = true, was_cancelled = false;
  std::vector<std::string> notes;
};

/// Meshes a piecewise linear system by increasing dimension: its points, then each segment, each
/// facet in its plane, and the solids, each packed with balls until no circumcentre, or no place at
/// all, has room for one.
///
/// The mesh is Delaunay, all facets and segments are unions of its faces and edges, and every
/// circumcentre lies in its solid. Circumradius / shortest edge is at most radius_edge_bound(beta),
/// usually far below; that permits slivers, flat tets with edges of like length. Nothing is split
/// into convex parts (PolyhedralComplex), and the solids are those that the facets enclose, but for
/// the holes.
///
/// Errors: kUsage for an option out of its range, or a size that is not positive; kInvalidGeometry
///   for what is no domain: see build_complex, find_rule_violations and pack_solids; or if beta is
///   too small for facets to come out; kLimit where the surface alone needs more than max_points;
///   kCancelled if it was cancelled before the surface was packed.
/// Cost: O(n log n) expected for n nodes and polytopes.
/// Audit: audit_tet_mesh with the domain: conformity, constrained_delaunay, boundary_gabriel,
///   circumcentres_inside, radius_edge; audit_spacing by beta * radius: beta_spaced.
/// See: chapter 4.
Result<PackedTets> pack_domain3(const Pls& domain, const PackingOptions3& options = {});

/// The number of nodes by the integral of 1 / radius^3 over the mesh, that taken from the values at
/// the corners of each tet: the constant of Theorem 4.4.1, times beta^3 if no size is given.
/// Degenerate: 0 for a mesh without tets.
double nodes_by_integral(const PackedTets& packed);

}  // namespace wellspaced
