// Layer 2 of the audit in space: do the tetrahedra tile a part of space? Decided exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The orientation of each tet: 1 positive, -1 negative, 0 flat.
std::vector<std::int8_t> tet_orientations(const TetMesh& mesh);

/// Whether there are tets and all are negative: a mesh written the other way round.
/// Requires: indices in range.
bool is_negative(const TetMesh& mesh);

/// Judges whether the tets lie side by side. Checks, all required:
///   no_inverted          every tet is positive or flat
///   no_flat              no tet has its corners in one plane
///   no_overlap           no two tets have an interior point in common. It is proven for the mesh
///                        as a whole by winding numbers (solid_winding.hpp); if the proof fails,
///                        the overlapping pairs are searched for, and violations is a lower bound
///                        where they are too many to be found
///   no_improper_contact  boundary faces meet in common corners or edges only: no node lies inside
///                        a boundary face or edge, no edges cross (pairs of tets). Flat tets aside
/// Measures: coincident_nodes, the nodes less the distinct places they lie at.
/// Requires: audit_tet_syntax passed; faces and orientation are of this mesh.
/// Cost: O(n) and O(b log b) for b boundary faces; O(n log n + pairs) more if the proof fails.
void audit_tet_embedding(const TetMesh& mesh, const TetFaces& faces,
                         const std::vector<std::int8_t>& orientation, Report& report);

}  // namespace wellspaced::audit
