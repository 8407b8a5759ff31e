#include "wellspaced/algorithms/audit/mesh_audit.hpp"

#include <span>

#include "wellspaced/algorithms/audit/delaunay.hpp"
#include "wellspaced/algorithms/audit/domain.hpp"
#include "wellspaced/algorithms/audit/embedding.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/local_order.hpp"
#include "wellspaced/algorithms/audit/shape.hpp"
#include "wellspaced/algorithms/audit/topology.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

void require_boundary_segments(const TriangleMesh& mesh, const HalfEdges& half_edges,
                               Report& report) {
  if (has_convex_boundary(mesh, half_edges)) return;
  for (Check& check : report.checks)
    if (check.name == "boundary_has_segments") check.required = true;
}

void audit_in_local_order(const TriangleMesh& mesh, const MeshAuditOptions& options,
                          Report& report) {
  const auto nodes = static_cast<Index>(mesh.points.size());
  ProgressParts parts(options.progress, "audit", 8);
  const auto go_on = [&](std::uint64_t done) { return report.complete = parts.go_on(done); };
  if (!go_on(1)) return;
  const HalfEdges half_edges = pair_half_edges(mesh.triangles, mesh.segments, nodes);
  if (!go_on(2)) return;
  audit_topology(mesh, half_edges, report);
  if (options.segments == SegmentMeaning::kWholeBoundary)
    require_boundary_segments(mesh, half_edges, report);
  if (!go_on(3)) return;
  const std::vector<std::int8_t> orientation = orientations(mesh);
  audit_embedding(mesh, half_edges, orientation, report);
  if (!go_on(4)) return;
  if (options.domain != nullptr)
    audit_domain(mesh, half_edges, {*options.domain, options.allowance, parts.part(4)}, report);
  if (!go_on(5)) return;
  if (!options.holes.empty()) audit_holes(mesh, options.holes, parts.part(5), report);
  if (!go_on(6)) return;
  audit_delaunay(mesh, half_edges, orientation, report);
  if (!go_on(7)) return;
  audit_shape(mesh, half_edges, report);
}

// Turns local ids into given ones. Edges stay in the order of their places: there may be many.
void restore_numbers(Check& check, const LocalOrder& order) {
  const bool by_node = check.item == Item::kNode || check.item == Item::kEdge;
  const bool by_triangle = check.item == Item::kTriangle || check.item == Item::kTrianglePair;
  if (!by_node && !by_triangle) return;
  const std::vector<Index>& given = by_node ? order.given_node : order.given_triangle;
  for (Index& id : check.ids) id = given[id];
  if (ids_per(check.item) == 1) sort(check.ids);
  if (check.item == Item::kTrianglePair) sort_pairs(check.ids);
}

void restore_numbers(Report& report, std::size_t first_check, const LocalOrder& order) {
  for (Check& check : std::span(report.checks).subspan(first_check)) restore_numbers(check, order);
  for (Worst& worst : report.worst)
    for (Index& id : worst.ids) id = order.given_triangle[id];
}

}  // namespace

Report audit_mesh(const TriangleMesh& mesh, const MeshAuditOptions& options) {
  Report report;
  report.complete = wellspaced::report(options.progress, "audit", 0, 1);
  if (!report.complete || !audit_syntax(mesh, report)) return report;
  const std::size_t syntax = report.checks.size();
  const LocalOrder order = local_order(mesh);
  audit_in_local_order(order.mesh, options, report);
  restore_numbers(report, syntax, order);
  return report;
}

}  // namespace wellspaced::audit
