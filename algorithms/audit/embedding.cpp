#include "wellspaced/algorithms/audit/embedding.hpp"

#include <numeric>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/check_lists.hpp"
#include "wellspaced/algorithms/audit/triangle_overlap.hpp"
#include "wellspaced/algorithms/audit/winding.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// The sum of the boundaries of all triangles that are not flat, turned counter-clockwise, less the
// edges that cancel because two triangles of the same orientation share them.
std::vector<ChainEdge> boundary_chain(const TriangleMesh& mesh, const HalfEdges& half_edges,
                                      const std::vector<std::int8_t>& orientation) {
  std::vector<ChainEdge> chain;
  for (Index h = 0; h < half_edges.twin.size(); ++h) {
    const int sign = orientation[h / 3];
    const Index twin = half_edges.twin[h];
    if (sign == 0 || (twin != kNoIndex && orientation[twin / 3] == sign)) continue;
    Index from = origin(mesh.triangles, h), to = target(mesh.triangles, h);
    if (sign < 0) std::swap(from, to);
    chain.push_back({mesh.points[from], mesh.points[to], from, to});
  }
  return chain;
}

// Lists pairs of triangles that overlap.
class OverlapSearch {
 public:
  OverlapSearch(const TriangleMesh& mesh, const std::vector<std::int8_t>& orientation)
      : mesh_(mesh), orientation_(orientation), boxes_(boxes_of(mesh)), tree_(boxes_) {}

  void run(Check& check) {
    std::uint64_t budget = 1000000 + 64 * std::uint64_t{mesh_.triangles.size()};
    for (Index t = 0; t < mesh_.triangles.size() && budget > 0; ++t)
      if (orientation_[t] != 0) list_overlaps_of(t, budget, check);
    if (check.pass()) ++check.violations;  // the budget was too small to find one
  }

 private:
  static std::vector<Box<2>> boxes_of(const TriangleMesh& mesh) {
    std::vector<Box<2>> boxes;
    boxes.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
      const Corners c = corners_of(mesh.points, t);
      boxes.push_back(box_of(c[0], c[1], c[2]));
    }
    return boxes;
  }

  void list_overlaps_of(Index t, std::uint64_t& budget, Check& check) {
    const Corners corners = corners_at(t);
    tree_.search([&](const Box<2>& box) { return overlap(box, boxes_[t]); },
                 [&](Index u) {
                   if (u <= t || orientation_[u] == 0 || !overlap(boxes_[u], boxes_[t]))
                     return true;
                   if (interiors_overlap(corners, corners_at(u))) check.violate({t, u});
                   return --budget > 0;
                 });
  }

  Corners corners_at(Index t) const {
    return counter_clockwise(corners_of(mesh_.points, mesh_.triangles[t]), orientation_[t]);
  }

  const TriangleMesh& mesh_;
  const std::vector<std::int8_t>& orientation_;
  std::vector<Box<2>> boxes_;
  BoxTree<2> tree_;
};

// The nodes that can coincide with another: in a mesh without overlap or unused nodes, those on the
// boundary. The triangles around each other one fill a neighbourhood of it.
std::vector<Index> nodes_on_boundary(const TriangleMesh& mesh, const HalfEdges& half_edges) {
  std::vector<std::uint8_t> is_on_boundary(mesh.points.size(), 0);
  for (Index h = 0; h < half_edges.twin.size(); ++h)
    if (half_edges.twin[h] == kNoIndex)
      is_on_boundary[origin(mesh.triangles, h)] = is_on_boundary[target(mesh.triangles, h)] = 1;
  std::vector<Index> nodes;
  for (Index v = 0; v < is_on_boundary.size(); ++v)
    if (is_on_boundary[v] != 0) nodes.push_back(v);
  return nodes;
}

std::vector<Index> all_nodes(const TriangleMesh& mesh) {
  std::vector<Index> nodes(mesh.points.size());
  std::iota(nodes.begin(), nodes.end(), Index{0});
  return nodes;
}

std::uint64_t count_coincident(const TriangleMesh& mesh, std::vector<Index> nodes) {
  const auto& p = mesh.points;
  sort(nodes,
       [&](Index i, Index j) { return p[i].x < p[j].x || (p[i].x == p[j].x && p[i].y < p[j].y); });
  std::uint64_t count = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) count += p[nodes[i - 1]] == p[nodes[i]];
  return count;
}

}  // namespace

std::vector<std::int8_t> orientations(const TriangleMesh& mesh) {
  std::vector<std::int8_t> signs;
  signs.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    signs.push_back(static_cast<std::int8_t>(
        orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])));
  return signs;
}

bool is_clockwise(const TriangleMesh& mesh) {
  return !mesh.triangles.empty() && all_of(mesh.triangles, [&](const auto& t) {
    return orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) < 0;
  });
}

void audit_embedding(const TriangleMesh& mesh, const HalfEdges& half_edges,
                     const std::vector<std::int8_t>& orientation, Report& report) {
  check_orientations(report, Item::kTriangle, orientation);
  const WindingVerdict verdict = cover_at_most_once(boundary_chain(mesh, half_edges, orientation));
  Check& check = report.add_required_check("no_overlap", Item::kTrianglePair);
  if (!verdict.at_most_once) OverlapSearch(mesh, orientation).run(check);
  Check& hanging = report.add_required_check("no_hanging_node", Item::kNode);
  for (const Index v : verdict.hanging_nodes) hanging.violate({v});
  const bool inner_differ = verdict.at_most_once && report.check("no_unused_node")->pass();
  report.add_measure(
      "coincident_nodes",
      static_cast<double>(count_coincident(
          mesh, inner_differ ? nodes_on_boundary(mesh, half_edges) : all_nodes(mesh))));
}

}  // namespace wellspaced::audit
