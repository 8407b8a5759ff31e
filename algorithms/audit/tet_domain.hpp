// Does a tetrahedral mesh conform to a polyhedral domain? Decided exactly.
#pragma once

#include "wellspaced/algorithms/audit/polyhedral_domain.hpp"
#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// allowance: how far nodes may be from their segments and facets, see below. progress: phase
/// "audit"; told to stop, the report is unfinished.
struct SolidToMeet {
  const PolyhedralDomain& domain;
  double allowance = 2;
  Progress progress = {};
};

/// Judges a mesh against the domain that it should be a mesh of. Checks, all required:
///   domain_points_are_nodes    at every point of the domain there is a node
///   domain_segments_are_edges  every segment and every edge of a polygon is a chain of mesh edges;
///                              ids count the segments, then the polygons' edges in order
///   domain_facets_are_faces    every facet is a union of mesh faces, but for those that
///                              open_facets.hpp finds to have nothing to be meshed on either side
///   boundary_on_domain         every face with a tet on one side only is part of such a union; not
///                              judged for a domain without facets
///   holes_are_open             no tet contains a hole point, inside or on its boundary; only for a
///                              domain with hole points
/// A node counts as on a line or plane if that passes through the box around the node whose half
/// sides are `allowance` units in the last place of the largest coordinates of the segment or
/// facet. For a facet whose own points are not in one plane that exactly, the allowance is doubled
/// until they are; and where the domain has a flatness, the half sides are at least that part of
/// the facet's extent. A facet whose points are all on one line is no union of faces. Measure:
/// facet_allowance, the largest such allowance. Where two nodes lie at one place, as on the two
/// sides of a crack, one of them is followed.
///
/// How a union is found. The edges of the facet have been found as chains of mesh edges. The mesh
/// faces near its plane fall into pieces that these chains separate. A piece with a rim elsewhere
/// is no part of the facet. Of the others, exactly one on either side of a bounding edge is, and on
/// both sides or none of an edge that cancels. If these conditions can be met, the pieces chosen
/// have the facet's boundary, and in a plane there is just one set that has it.
/// Requires: audit_tet_syntax passed; faces is of this mesh; indices of the domain in range.
/// Cost: O(n log n) for n tets, and the faces on the facets times the degrees of their nodes.
/// See: section 4.2.
void audit_tet_domain(const TetMesh& mesh, const TetFaces& faces, const SolidToMeet& domain,
                      Report& report);

}  // namespace wellspaced::audit
