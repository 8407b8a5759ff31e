#include "wellspaced/algorithms/audit/tet_topology.hpp"

#include <algorithm>
#include <cstdlib>

#include "wellspaced/algorithms/audit/check_lists.hpp"
#include "wellspaced/algorithms/audit/components.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

std::uint64_t count_used_nodes(const TetMesh& mesh, Report& report) {
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const Index v : tet) used[v] = 1;
  Check& check = report.add_check("no_unused_node", Item::kNode);
  for (Index v = 0; v < used.size(); ++v)
    if (used[v] == 0) check.violate({v});
  return mesh.points.size() - check.violations;
}

// Which segments are edges of tets: sorted, they are looked for among all edges between their ends.
void audit_segments(const TetMesh& mesh, Report& report) {
  Check& check = report.add_required_check("segments_are_edges", Item::kSegment);
  if (mesh.segments.empty()) return;
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::uint8_t> at_end(mesh.points.size(), 0);
  for (const Segment& s : mesh.segments) at_end[s.a] = at_end[s.b] = 1;
  for (const auto& tet : mesh.tets)
    for (int i = 0; i < 3; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (at_end[tet[i]] != 0 && at_end[tet[j]] != 0)
          edges.push_back({std::min(tet[i], tet[j]), std::max(tet[i], tet[j])});
  sort(edges);
  for (Index s = 0; s < mesh.segments.size(); ++s) {
    const auto [a, b] = std::minmax(mesh.segments[s].a, mesh.segments[s].b);
    if (!std::binary_search(edges.begin(), edges.end(), std::array{a, b})) check.violate({s});
  }
}

void audit_facets(const TetMesh& mesh, const TetFaces& faces, Report& report) {
  list_violations(report, "no_duplicate_facet", Item::kFacet, faces.duplicate_facets);
  list_violations(report, "one_marker_per_facet", Item::kFacet, faces.conflicting_facets).required =
      true;
  Check& check = report.add_required_check("facets_are_faces", Item::kFacet);
  for (Index i = 0; i < mesh.facets.size(); ++i)
    if (faces.facet_face[i] == kNoIndex) check.violate({i});
  if (mesh.facets.empty()) return;
  Check& boundary = report.add_check("boundary_has_facets", Item::kFace);
  for (Index f = 0; f < faces.twin.size(); ++f) {
    if (faces.twin[f] != kNoIndex || faces.constrained[f] != 0) continue;
    const Face nodes = face_nodes(mesh.tets, f);
    boundary.violate({nodes[0], nodes[1], nodes[2]});
  }
}

struct BoundaryFigures {
  std::uint64_t components = 0;
  bool manifold = false;
  std::int64_t characteristic = 0;  // if manifold
};

BoundaryFigures audit_boundary(const TetMesh& mesh, const BoundarySurface& surface,
                               Report& report) {
  const auto nodes = static_cast<Index>(mesh.points.size());
  const HalfEdges half_edges = pair_half_edges(surface.triangles, {}, nodes);
  Check& edges = report.add_check("manifold_boundary_edges", Item::kEdge);
  edges.ids = half_edges.crowded_edges;
  edges.ids.insert(edges.ids.end(), half_edges.disagreeing_edges.begin(),
                   half_edges.disagreeing_edges.end());
  edges.violations = edges.ids.size() / 2;
  const bool edges_pass = edges.pass();
  std::uint64_t fans = 0;
  const auto fans_at = count_fans(surface.triangles, half_edges, nodes, fans);
  Check& manifold = report.add_check("manifold_boundary_nodes", Item::kNode);
  for (Index v = 0; v < nodes; ++v)
    if (fans_at[v] > 1) manifold.violate({v});
  const auto faces = static_cast<std::int64_t>(surface.triangles.size());
  return {count_components(half_edges), edges_pass && manifold.pass(),
          static_cast<std::int64_t>(fans) - faces / 2};
}

void audit_euler(std::int64_t characteristic, const BoundaryFigures& boundary, Report& report) {
  report.add_measure("euler_characteristic", static_cast<double>(characteristic));
  if (!boundary.manifold) return;
  Check& check = report.add_required_check("euler", Item::kNone);
  check.value = static_cast<double>(characteristic);
  check.violations =
      static_cast<std::uint64_t>(std::abs(2 * characteristic - boundary.characteristic));
  report.add_measure("boundary_genus", static_cast<double>(boundary.components) -
                                           static_cast<double>(boundary.characteristic) / 2);
}

}  // namespace

BoundarySurface boundary_surface(const TetMesh& mesh, const TetFaces& faces) {
  BoundarySurface surface;
  for (Index f = 0; f < faces.twin.size(); ++f) {
    if (faces.twin[f] != kNoIndex) continue;
    surface.triangles.push_back(face_nodes(mesh.tets, f));
    surface.faces.push_back(f);
  }
  return surface;
}

bool audit_tet_syntax(const TetMesh& mesh, Report& report) {
  const std::size_t nodes = mesh.points.size();
  bool ok = check_each(report, "valid_indices", Item::kTet, mesh.tets.size(),
                       [&](Index t) { return in_range(mesh.tets[t], nodes); });
  ok &= check_each(report, "distinct_corners", Item::kTet, mesh.tets.size(),
                   [&](Index t) { return distinct(mesh.tets[t]); });
  ok &= check_each(report, "finite_coordinates", Item::kNode, nodes,
                   [&](Index v) { return is_finite(mesh.points[v]); });
  ok &= check_each(report, "valid_facets", Item::kFacet, mesh.facets.size(), [&](Index i) {
    return in_range(mesh.facets[i].points, nodes) && distinct(mesh.facets[i].points);
  });
  ok &= check_each(report, "valid_segments", Item::kSegment, mesh.segments.size(), [&](Index i) {
    const std::array ends{mesh.segments[i].a, mesh.segments[i].b};
    return in_range(ends, nodes) && distinct(ends);
  });
  Check& data = report.add_required_check("valid_node_data", Item::kNode);
  if (!mesh.point_markers.empty() && mesh.point_markers.size() != nodes) ++data.violations;
  return data.pass() && ok;
}

void audit_tet_topology(const TetMesh& mesh, const TetFaces& faces, Report& report) {
  list_violations(report, "no_duplicate_tet", Item::kTet, faces.duplicate_tets).required = true;
  list_violations(report, "manifold_faces", Item::kFace, faces.crowded_faces).required = true;
  list_violations(report, "consistent_orientation", Item::kFace, faces.disagreeing_faces).required =
      true;
  const BoundarySurface surface = boundary_surface(mesh, faces);
  const BoundaryFigures boundary = audit_boundary(mesh, surface, report);
  const std::uint64_t nodes = count_used_nodes(mesh, report);
  const std::uint64_t edges = count_tet_edges(mesh.tets, static_cast<Index>(mesh.points.size()));
  audit_euler(static_cast<std::int64_t>(nodes - edges + faces.faces - mesh.tets.size()), boundary,
              report);
  audit_facets(mesh, faces, report);
  audit_segments(mesh, report);
  const std::uint64_t components = count_components<4>(faces.twin);
  const std::pair<std::string_view, std::uint64_t> counts[] = {
      {"nodes", mesh.points.size()},  {"tets", mesh.tets.size()},
      {"faces", faces.faces},         {"edges", edges},
      {"facets", mesh.facets.size()}, {"boundary_faces", surface.triangles.size()},
      {"components", components},     {"boundary_components", boundary.components}};
  for (const auto& [name, count] : counts) report.add_measure(name, static_cast<double>(count));
  report.add_measure("cavities",
                     static_cast<double>(boundary.components) - static_cast<double>(components));
}

}  // namespace wellspaced::audit
