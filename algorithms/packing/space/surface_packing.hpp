// Packing the segments and facets of a domain in space: PACKING's steps 1 and 2.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "wellspaced/algorithms/packing/interior_packing.hpp"
#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The radius of the point-ball at a point in space: positive.
using BallRadius3 = std::function<double(Point3)>;

/// points: those of the complex, in order, then those on segments, then those inside facets.
/// radius: of the ball around each; 0 for a point of the complex that is no vertex.
/// pieces: what each segment is cut into, one after the other. triangles: those of each facet, one
///   facet after the other. first_piece, first_triangle: where those of each start, and the end.
/// on_facet: for each facet the points on it, its edges included, ascending.
struct PackedSurface {
  std::vector<Point3> points;
  std::vector<double> radius;
  std::vector<std::array<Index, 2>> pieces;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> first_piece, first_triangle;
  std::vector<std::vector<Index>> on_facet;
  std::size_t segment_points = 0, facet_points = 0;
};

/// radius: of the balls. slope: it grows by at most this much per unit of length.
/// maximality: of facets; segments are packed so that nothing can be added.
/// max_points: the most points there may be. progress: phase "surface".
struct SurfaceOptions {
  BallRadius3 radius;
  double slope = 0;
  Maximality maximality = Maximality::kDelaunay;
  std::size_t max_points = std::size_t{1} << 26;
  Progress progress;
};

/// Packs each segment (pack_segment), then each facet in its own plane: circumcentres, each moved a
/// little by chance, are added as long as the ball around one is disjoint from the others, the
/// centre in no protective circle of a segment's piece, and a ball of twice the radius meets no
/// segment of the facet (Definition 4.3.3, corrected). The triangles are Delaunay in the facet's
/// own coordinates, and no four points of a facet lie nearly on one circle with none inside.
/// Errors: kUsage where a radius is not positive; kLimit beyond max_points; kCancelled; those of
/// pack_interior.
/// Cost: O(n log n) expected for n points, a few radii for each. See: Figure 4.3, i = 1 and 2.
Result<PackedSurface> pack_surface(const PolyhedralComplex& complex, const SurfaceOptions& options);

}  // namespace wellspaced
