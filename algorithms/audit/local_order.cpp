#include "wellspaced/algorithms/audit/local_order.hpp"

namespace wellspaced::audit {
namespace {

void number_nodes(const TriangleMesh& mesh, LocalOrder& order) {
  order.local.assign(mesh.points.size(), kNoIndex);
  order.given.reserve(mesh.points.size());
  const auto number = [&](Index v) {
    if (order.local[v] != kNoIndex) return;
    order.local[v] = static_cast<Index>(order.given.size());
    order.given.push_back(v);
  };
  for (const auto& t : mesh.triangles)
    for (const Index v : t) number(v);
  for (Index v = 0; v < mesh.points.size(); ++v) number(v);
}

}  // namespace

LocalOrder local_order(const TriangleMesh& mesh) {
  LocalOrder order;
  number_nodes(mesh, order);
  const std::vector<Index>& local = order.local;
  order.mesh.points.reserve(mesh.points.size());
  for (const Index v : order.given) order.mesh.points.push_back(mesh.points[v]);
  order.mesh.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    order.mesh.triangles.push_back({local[a], local[b], local[c]});
  order.mesh.segments.reserve(mesh.segments.size());
  for (const Segment& s : mesh.segments)
    order.mesh.segments.push_back({local[s.a], local[s.b], s.marker});
  return order;
}

}  // namespace wellspaced::audit
