#include "wellspaced/algorithms/audit/mesh_audit.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "wellspaced/algorithms/audit/delaunay.hpp"
#include "wellspaced/algorithms/audit/embedding.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/local_order.hpp"
#include "wellspaced/algorithms/audit/shape.hpp"
#include "wellspaced/algorithms/audit/topology.hpp"

namespace wellspaced::audit {
namespace {

void audit_in_local_order(const TriangleMesh& mesh, Report& report) {
  const auto nodes = static_cast<Index>(mesh.points.size());
  const HalfEdges half_edges = pair_half_edges(mesh.triangles, mesh.segments, nodes);
  audit_topology(mesh, half_edges, report);
  const std::vector<std::int8_t> orientation = orientations(mesh);
  audit_embedding(mesh, half_edges, orientation, report);
  audit_delaunay(mesh, half_edges, orientation, report);
  audit_shape(mesh, half_edges, report);
}

// Sorts the violations by their ids; the first id of an edge is the lower.
void sort_edges(std::vector<Index>& ids) {
  std::vector<std::array<Index, 2>> edges;
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2)
    edges.push_back({std::min(ids[i], ids[i + 1]), std::max(ids[i], ids[i + 1])});
  std::sort(edges.begin(), edges.end());
  ids.clear();
  for (const auto& [a, b] : edges) ids.insert(ids.end(), {a, b});
}

void restore_numbers(Check& check, std::span<const Index> given) {
  if (check.item != Item::kNode && check.item != Item::kEdge) return;
  for (Index& id : check.ids) id = given[id];
  check.item == Item::kEdge ? sort_edges(check.ids) : std::sort(check.ids.begin(), check.ids.end());
}

}  // namespace

Report audit_mesh(const TriangleMesh& mesh) {
  Report report;
  if (!audit_syntax(mesh, report)) return report;
  const std::size_t syntax = report.checks.size();
  const LocalOrder order = local_order(mesh);
  audit_in_local_order(order.mesh, report);
  for (Check& check : std::span(report.checks).subspan(syntax)) restore_numbers(check, order.given);
  return report;
}

}  // namespace wellspaced::audit
