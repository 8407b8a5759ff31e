// Layer 3 of the audit: is the mesh Delaunay? Decided exactly; ties are legal.
#pragma once

#include <cstdint>
#include <vector>

#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Judges the edges by circles. An edge fails the in-circle test strictly when the far corner of
/// the triangle on one side lies strictly inside the circumcircle of the triangle on the other.
/// In a mesh that is embedded and covers what its segments bound, local tests suffice: it is the
/// constrained Delaunay triangulation if no unconstrained edge fails (Lee and Lin 1986). Checks:
///   constrained_delaunay  no interior edge without a segment fails
///   delaunay              no interior edge fails, segments or not
///   gabriel               no corner of an edge's triangles lies strictly inside the circle that
///                         has the edge for a diameter
///   boundary_gabriel      the same for boundary edges and segments alone: none is encroached
///   circumcentres_inside  the circumcentre of every triangle lies in the mesh, in sight: the path
///                         along the bisector of the longest edge does not leave it
/// Edges of triangles that are not counter-clockwise are left out. Measures:
///   circumcentres_undecided, the triangles whose path was not followed to its end because all
///   paths together took more than 32 steps a triangle (only if any).
/// Requires: audit_syntax passed; half_edges and orientation are of this mesh.
/// Cost: linear. See: Definition 2.1.1.
void audit_delaunay(const TriangleMesh& mesh, const HalfEdges& half_edges,
                    const std::vector<std::int8_t>& orientation, Report& report);

}  // namespace wellspaced::audit
