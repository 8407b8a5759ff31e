#include "wellspaced/algorithms/audit/topology.hpp"

#include "wellspaced/kernel/check_points.hpp"

#include "wellspaced/algorithms/audit/check_lists.hpp"

namespace wellspaced::audit {
namespace {

bool valid(const Segment& s, std::size_t nodes) { return s.a < nodes && s.b < nodes && s.a != s.b; }

bool audit_node_data(const TriangleMesh& mesh, Report& report) {
  Check& check = report.add_required_check("valid_node_data", Item::kNode);
  if (!mesh.point_markers.empty() && mesh.point_markers.size() != mesh.points.size())
    ++check.violations;
  for (const Index v : mesh.fixed)
    if (v >= mesh.points.size()) check.violate({v});
  return check.pass();
}

std::uint64_t count_boundary_loops(const HalfEdges& half_edges) {
  std::vector<bool> marked(half_edges.twin.size());
  std::uint64_t loops = 0;
  for (Index h = 0; h < marked.size(); ++h) {
    if (half_edges.twin[h] != kNoIndex || marked[h]) continue;
    ++loops;
    for (Index g = h; !marked[g]; g = half_edges.next_on_boundary(g)) marked[g] = true;
  }
  return loops;
}

std::uint64_t count_boundary_edges(const HalfEdges& half_edges) {
  std::uint64_t count = 0;
  for (const Index twin : half_edges.twin) count += twin == kNoIndex;
  return count;
}

void audit_nodes(const std::vector<std::uint8_t>& fans, Report& report) {
  Check& manifold = report.add_check("manifold_nodes", Item::kNode);
  for (Index v = 0; v < fans.size(); ++v)
    if (fans[v] > 1) manifold.violate({v});
  Check& unused = report.add_check("no_unused_node", Item::kNode);
  for (Index v = 0; v < fans.size(); ++v)
    if (fans[v] == 0) unused.violate({v});
}

void audit_segments(const TriangleMesh& mesh, const HalfEdges& half_edges, Report& report) {
  Check& repeated = report.add_check("no_duplicate_segment", Item::kSegment);
  for (const Index s : half_edges.duplicate_segments) repeated.violate({s});
  Check& markers = report.add_required_check("one_marker_per_edge", Item::kSegment);
  for (const Index s : half_edges.conflicting_segments) markers.violate({s});
  Check& edges = report.add_required_check("segments_are_edges", Item::kSegment);
  for (Index s = 0; s < mesh.segments.size(); ++s)
    if (half_edges.segment_edge[s] == kNoIndex) edges.violate({s});
  if (mesh.segments.empty()) return;
  Check& boundary = report.add_check("boundary_has_segments", Item::kEdge);
  for (Index h = 0; h < half_edges.twin.size(); ++h)
    if (half_edges.twin[h] == kNoIndex && half_edges.constrained[h] == 0)
      boundary.violate({origin(mesh.triangles, h), target(mesh.triangles, h)});
}

struct Counts {
  std::uint64_t nodes = 0, fans = 0, boundary_edges = 0, components = 0, loops = 0;
};

void audit_euler(const TriangleMesh& mesh, const HalfEdges& half_edges, const Counts& counts,
                 Report& report) {
  const auto faces = static_cast<std::int64_t>(mesh.triangles.size());
  const auto sides = 3 * faces, rims = static_cast<std::int64_t>(counts.boundary_edges);
  const auto characteristic = static_cast<std::int64_t>(counts.fans) - (sides + rims) / 2 + faces;
  const auto expected = static_cast<std::int64_t>(2 * counts.components - counts.loops);
  Check& check = report.add_required_check("euler", Item::kNone);
  check.violations = static_cast<std::uint64_t>(std::abs(expected - characteristic)) / 2;
  check.value = static_cast<double>(characteristic);
  report.add_measure("euler_characteristic", static_cast<double>(counts.nodes) -
                                                 static_cast<double>(half_edges.edges) +
                                                 static_cast<double>(faces));
}

void add_measures(const TriangleMesh& mesh, const HalfEdges& half_edges, const Counts& counts,
                  Report& report) {
  report.add_measure("nodes", static_cast<double>(mesh.points.size()));
  report.add_measure("triangles", static_cast<double>(mesh.triangles.size()));
  report.add_measure("edges", static_cast<double>(half_edges.edges));
  report.add_measure("segments", static_cast<double>(mesh.segments.size()));
  report.add_measure("boundary_edges", static_cast<double>(counts.boundary_edges));
  report.add_measure("components", static_cast<double>(counts.components));
  report.add_measure("boundary_loops", static_cast<double>(counts.loops));
  report.add_measure("holes",
                     static_cast<double>(counts.loops) - static_cast<double>(counts.components));
}

}  // namespace

bool audit_syntax(const TriangleMesh& mesh, Report& report) {
  const std::size_t nodes = mesh.points.size();
  const auto& t = mesh.triangles;
  bool ok = check_each(report, "valid_indices", Item::kTriangle, t.size(),
                       [&](Index i) { return in_range(t[i], nodes); });
  ok &= check_each(report, "distinct_corners", Item::kTriangle, t.size(),
                   [&](Index i) { return distinct(t[i]); });
  ok &= check_each(report, "finite_coordinates", Item::kNode, nodes,
                   [&](Index i) { return is_finite(mesh.points[i]); });
  ok &= check_each(report, "valid_segments", Item::kSegment, mesh.segments.size(),
                   [&](Index i) { return valid(mesh.segments[i], nodes); });
  return audit_node_data(mesh, report) && ok;
}

void audit_topology(const TriangleMesh& mesh, const HalfEdges& half_edges, Report& report) {
  list_violations(report, "no_duplicate_triangle", Item::kTriangle, half_edges.duplicate_triangles)
      .required = true;
  list_violations(report, "manifold_edges", Item::kEdge, half_edges.crowded_edges).required = true;
  list_violations(report, "consistent_orientation", Item::kEdge, half_edges.disagreeing_edges)
      .required = true;
  Counts counts;
  const std::vector<std::uint8_t> fans =
      count_fans(mesh.triangles, half_edges, mesh.points.size(), counts.fans);
  for (const std::uint8_t count : fans) counts.nodes += count > 0;
  counts.boundary_edges = count_boundary_edges(half_edges);
  counts.components = count_components(half_edges);
  counts.loops = count_boundary_loops(half_edges);
  audit_nodes(fans, report);
  audit_euler(mesh, half_edges, counts, report);
  audit_segments(mesh, half_edges, report);
  add_measures(mesh, half_edges, counts, report);
}

}  // namespace wellspaced::audit
