// Packing the solids of a domain in space whose surface is packed: PACKING's last step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"
#include "wellspaced/algorithms/packing/space/surface_packing.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// radius, slope, maximality, max_points: as in SurfaceOptions. holes: one point in each solid to
/// leave out. seeds: one point in each solid that has a number, its own in the list; the first
/// counts.
struct SolidOptions {
  BallRadius3 radius;
  double slope = 0;
  Maximality maximality = Maximality::kDelaunay;
  std::vector<Point3> holes, seeds;
  std::size_t max_points = std::size_t{1} << 26;
  Progress progress;
};

/// points: those of the surface that are in the domain, in its order, then new ones.
/// surface_point: for each which it is; kNoIndex for new ones. radius: of each point's ball.
/// tets: positive. seed_of: for each the seed of its solid; kNoIndex: none.
/// triangles, pieces: which of the surface are in the domain, by its numbers; all are faces and
///   edges of tets, with the corners that number_of names. number_of: for each point of the surface
///   its number here; kNoIndex: outside.
struct PackedSolids {
  std::vector<Point3> points;
  std::vector<Index> surface_point, number_of;
  std::vector<double> radius;
  std::vector<std::array<Index, 4>> tets;
  std::vector<Index> seed_of;
  std::vector<Index> triangles, pieces;
  std::size_t balls_packed = 0;
  bool is_complete = true, was_cancelled = false;
};

/// Packs the solids that the surface encloses, in one Delaunay triangulation of all points.
///
/// Circumcentres of tets are added as long as the ball around one is disjoint from all others and
/// the centre in no protective sphere, of whatever triangle or piece. So all of these stay faces
/// and edges of the triangulation, and no insertion reaches across a face.
///
/// Errors: kInvalidGeometry where nothing is enclosed, or a facet has no solid on either side (ids:
///   the domain's facets), or where triangles or pieces are no faces and edges of the Delaunay
///   triangulation to begin with: then beta is too small for the domain (ids: facets, or else
///   points); kUsage where a radius is not positive. Those of Delaunay3::build.
/// Cost: O(n log n) expected for n points.
/// Audit: audit_tet_mesh with the domain. See: Figure 4.3, i = 3; Theorems 4.3.4 to 4.3.6.
Result<PackedSolids> pack_solids(const PolyhedralComplex& complex, const PackedSurface& surface,
                                 const SolidOptions& options);

}  // namespace wellspaced
