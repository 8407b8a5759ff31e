#include "wellspaced/algorithms/audit/tet_audit.hpp"

#include <span>

#include "wellspaced/algorithms/audit/local_order.hpp"
#include "wellspaced/algorithms/audit/tet_delaunay.hpp"
#include "wellspaced/algorithms/audit/tet_embedding.hpp"
#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/algorithms/audit/tet_shape.hpp"
#include "wellspaced/algorithms/audit/tet_topology.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

void audit_in_local_order(const TetMesh& mesh, const TetAuditOptions& options, Report& report) {
  ProgressParts parts(options.progress, "audit", 7);
  const auto go_on = [&](std::uint64_t done) { return report.complete = parts.go_on(done); };
  if (!go_on(1)) return;
  const TetFaces faces =
      pair_tet_faces(mesh.tets, mesh.facets, static_cast<Index>(mesh.points.size()));
  if (!go_on(2)) return;
  audit_tet_topology(mesh, faces, report);
  if (!go_on(3)) return;
  const std::vector<std::int8_t> orientation = tet_orientations(mesh);
  audit_tet_embedding(mesh, faces, orientation, report);
  if (!go_on(4)) return;
  if (options.domain != nullptr)
    audit_tet_domain(mesh, faces, {*options.domain, options.allowance, parts.part(4)}, report);
  if (!go_on(5)) return;
  audit_tet_delaunay(mesh, faces, orientation, parts.part(5), report);
  if (!go_on(6)) return;
  audit_tet_shape(mesh, parts.part(6), report);
  report.complete = !parts.stopped();
}

// Turns local ids into given ones. Edges and faces stay in the order of their places.
void restore_numbers(Check& check, const TetLocalOrder& order) {
  const bool by_node =
      check.item == Item::kNode || check.item == Item::kEdge || check.item == Item::kFace;
  const bool by_tet = check.item == Item::kTet || check.item == Item::kTetPair;
  if (!by_node && !by_tet) return;
  const std::vector<Index>& given = by_node ? order.given_node : order.given_tet;
  for (Index& id : check.ids) id = given[id];
  if (ids_per(check.item) == 1) sort(check.ids);
  if (check.item == Item::kTetPair) sort_pairs(check.ids);
}

}  // namespace

Report audit_tet_mesh(const TetMesh& mesh, const TetAuditOptions& options) {
  Report report;
  report.complete = wellspaced::report(options.progress, "audit", 0, 1);
  if (!report.complete || !audit_tet_syntax(mesh, report)) return report;
  const std::size_t syntax = report.checks.size();
  const TetLocalOrder order = local_order(mesh);
  audit_in_local_order(order.mesh, options, report);
  for (Check& check : std::span(report.checks).subspan(syntax)) restore_numbers(check, order);
  for (Worst& worst : report.worst)
    for (Index& id : worst.ids) id = order.given_tet[id];
  return report;
}

}  // namespace wellspaced::audit
