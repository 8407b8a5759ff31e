// The Voronoi cell of a vertex, cut off at a box.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced {

/// A convex polyhedron.
///
/// facets: each with its corners counter-clockwise seen from outside, and the vertex on its other
/// side; kNoIndex where the box cuts the cell off.
struct VoronoiCell3 {
  struct Facet {
    Index neighbor = kNoIndex;
    std::vector<Index> corners;
  };
  std::vector<Point3> vertices;
  std::vector<Facet> facets;
  double volume = 0;
};

/// The points of `box` that are no farther from vertex v than from any other vertex.
///
/// Which vertices have a facet in common with v is decided exactly: ties give no facets without
/// area, and equal corners are one. Where the corners lie, and what the box leaves, is computed in
/// floating point, always inside the box: facets and edges about as small as rounding may be
/// missing or doubled, with no harm to the volume.
/// Returns: an empty cell if v's does not meet the box in a volume.
/// Requires: delaunay.dimension() == 3; v is a vertex, no duplicate. Coordinates beyond 2^200 in
///   magnitude, or neighbours nearer than 2^-200, over- or underflow: then the cell is meaningless.
/// Cost: quadratic in the number of facets.
/// See: section 3.5.
VoronoiCell3 voronoi_cell(const Delaunay3& delaunay, Index v, const Box3& box);

}  // namespace wellspaced
