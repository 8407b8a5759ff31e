// How triangles and tetrahedra in space meet: exact.
#pragma once

#include <array>

#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Whether the closed segment from p to q and the closed triangle have a point in common.
/// Requires: p != q; the triangle is not flat.
bool segment_meets_triangle(Point3 p, Point3 q, const Corners3& triangle);

/// Whether two triangles have a point in common beside the corners and the edge that they share.
/// Corners are shared if they have the same number; different numbers are different places.
/// Requires: neither is flat; they do not share all three corners.
bool meet_improperly(const std::array<Point3, 3>& a, const std::array<Index, 3>& a_nodes,
                     const std::array<Point3, 3>& b, const std::array<Index, 3>& b_nodes);

/// Whether the interiors of two tets have a point in common. (If they are apart, a plane separates
/// them that contains a face of one of them, or an edge of one and a corner of the other.)
/// Requires: neither is flat. Orientation does not matter.
bool interiors_overlap(const TetCorners& a, const TetCorners& b);

}  // namespace wellspaced::audit
