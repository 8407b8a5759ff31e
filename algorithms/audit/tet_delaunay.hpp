// Layer 3 of the audit in space: is the mesh Delaunay? Decided exactly; ties are legal.
#pragma once

#include <cstdint>
#include <vector>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// Judges the faces by spheres. A face fails the in-sphere test strictly when the far corner of the
/// tet on one side lies strictly inside the circumsphere of the tet on the other. Checks:
///   constrained_delaunay  no interior face that is no facet fails: Delaunay region by region
///   delaunay              no interior face fails, facets or not
///   gabriel               no corner of a face's tets lies strictly inside the smallest sphere
///                         through the corners of the face
///   boundary_gabriel      the same for boundary faces and facets alone: none is encroached
///   circumcentres_inside  from every tet its circumcentre can be walked to: always across a face
///                         beyond which it lies, never out of the mesh
/// Faces of tets that are not positive are left out. Measures: circumcentres_undecided, the tets
///   whose walk was given up because all walks together took more than 32 steps a tet (if any).
/// progress: phase "audit".
/// Requires: audit_tet_syntax passed; faces and orientation are of this mesh.
/// Cost: linear. See: Definition 2.1.1 and section 4.3.
void audit_tet_delaunay(const TetMesh& mesh, const TetFaces& faces,
                        const std::vector<std::int8_t>& orientation, const Progress& progress,
                        Report& report);

}  // namespace wellspaced::audit
