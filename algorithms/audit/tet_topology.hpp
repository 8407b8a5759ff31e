// Layer 1 of the audit in space: is this a tetrahedral mesh at all, and what is its shape?
#pragma once

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Judges what every other check takes for granted. Checks, all required, as for triangle meshes
/// (topology.hpp): valid_indices, distinct_corners (tets), finite_coordinates, valid_facets (three
/// different nodes that exist), valid_segments, valid_node_data.
/// Returns: whether all pass; if not, nothing else can be judged.
/// Cost: linear.
bool audit_tet_syntax(const TetMesh& mesh, Report& report);

/// Judges how the tets are joined. Checks:
///   no_duplicate_tet         (required) no two tets have the same four nodes
///   manifold_faces           (required) at most two tets share a face
///   consistent_orientation   (required) two tets on a face run round it in opposite directions
///   manifold_boundary_edges  every edge of the boundary has two boundary faces; where bodies touch
///                            along an edge it has more, so this is no fault by itself
///   manifold_boundary_nodes  the boundary faces around a node form one fan
///   euler                    (required) V - E + F - T is half that of the boundary, as it is for
///                            every 3-manifold; judged only if the two before pass
///   no_unused_node           every node is in a tet
///   no_duplicate_facet       no two facets on one face
///   one_marker_per_facet     (required) facets on one face have the same marker
///   facets_are_faces         (required) every facet is a face of a tet
///   boundary_has_facets      every face with a tet on one side only is a facet; not judged for a
///                            mesh without facets
///   segments_are_edges       (required) every segment is an edge of a tet
/// Measures: nodes, tets, faces, edges, facets, boundary_faces, components, boundary_components,
///   cavities (boundary components less components), euler_characteristic, and boundary_genus, the
///   handles of the boundary, if that is a manifold.
/// Requires: audit_tet_syntax passed; faces is of this mesh.
/// Cost: linear for bounded degrees, O(n log n) always.
void audit_tet_topology(const TetMesh& mesh, const TetFaces& faces, Report& report);

/// The boundary faces of a mesh as triangles, counter-clockwise seen from outside positive tets,
/// and the faces that they are.
struct BoundarySurface {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> faces;
};
BoundarySurface boundary_surface(const TetMesh& mesh, const TetFaces& faces);

}  // namespace wellspaced::audit
