// A domain in space, as the auditors see it.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// A facet: polygons in one plane. Their edges, those that occur twice cancelling, bound it; so a
/// hole is a further polygon, and a dangling edge a polygon of two points.
using FacetPolygons = std::vector<std::vector<Index>>;

/// A domain in space: points, segments beside the edges of facets, facets, and one point in each
/// cavity. There need be no nodes at inner_points, which are ascending. flatness: how far from
/// their planes facets may be, as a part of their extent.
struct PolyhedralDomain {
  std::vector<Point3> points;
  std::vector<Segment> segments;
  std::vector<FacetPolygons> facets;
  std::vector<Point3> holes;
  std::vector<Index> inner_points;
  double flatness = 0;
};

/// The domain that a piecewise linear system describes. There a polygon inside another is a hole
/// only if a hole point lies in it; otherwise its sides are dangling edges.
/// Facets with one marker in exactly one plane that share an edge with no third one are one facet,
/// as TetGen has it: the triangles of a surface say nothing about the mesh inside a flat part; nor
/// do the points there that nothing else names, its inner_points. Coordinates that were rounded
/// call for a flatness above 0: then facets are in one plane if each pair of neighbours is, to
/// within that part of the extent of the two.
/// Requires: indices in range. Cost: O(n log n).
PolyhedralDomain domain_of(const Pls& system, double flatness = 0);

}  // namespace wellspaced::audit
