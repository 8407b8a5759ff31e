// A domain in space, as the auditors see it.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// A facet: polygons in one plane. Their edges, those that occur twice cancelling, bound it; so a
/// hole is a further polygon, and a dangling edge a polygon of two points.
using FacetPolygons = std::vector<std::vector<Index>>;

/// A domain in space: points, segments beside the edges of facets, facets, and one point in each
/// cavity.
struct PolyhedralDomain {
  std::vector<Point3> points;
  std::vector<Segment> segments;
  std::vector<FacetPolygons> facets;
  std::vector<Point3> holes;
};

/// The domain that a piecewise linear system describes. There a polygon inside another is a hole
/// only if a hole point lies in it; otherwise its sides are dangling edges.
/// Facets with one marker in exactly one plane that share an edge with no third one are one facet,
/// as TetGen has it: the triangles of a surface say nothing about the mesh inside a flat part.
/// Requires: indices in range. Cost: O(n log n).
PolyhedralDomain domain_of(const Pls& system);

}  // namespace wellspaced::audit
