#include "wellspaced/algorithms/audit/tet_audit.hpp"

#include "wellspaced/algorithms/audit/tet_delaunay.hpp"
#include "wellspaced/algorithms/audit/tet_embedding.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/algorithms/audit/tet_shape.hpp"
#include "wellspaced/algorithms/audit/tet_topology.hpp"

namespace wellspaced::audit {

Report audit_tet_mesh(const TetMesh& mesh) {
  Report report;
  if (!audit_tet_syntax(mesh, report)) return report;
  const TetFaces faces =
      pair_tet_faces(mesh.tets, mesh.facets, static_cast<Index>(mesh.points.size()));
  audit_tet_topology(mesh, faces, report);
  const std::vector<std::int8_t> orientation = tet_orientations(mesh);
  audit_tet_embedding(mesh, faces, orientation, report);
  audit_tet_delaunay(mesh, faces, orientation, report);
  audit_tet_shape(mesh, report);
  return report;
}

}  // namespace wellspaced::audit
