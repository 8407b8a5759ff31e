#include "wellspaced/algorithms/coarsening/edge_protection.hpp"

#include <array>

#include "wellspaced/algorithms/coarsening/measured_edge.hpp"

namespace wellspaced {
namespace {

bool is_in_zone(const MeasuredEdge& edge, Point2 p, const ProtectiveZone& zone) {
  const bool is_abreast = zone.shape == ProtectiveZone::Shape::kLens
                              ? edge.has_in_diametral_circle(p)
                              : edge.has_between_perpendiculars(p);
  return is_abreast && edge.distance_of_line_from(p) < zone.ratio * edge.length;
}

}  // namespace

void protect_edges(const ProtectedEdges& around, LocalSearch& search, NodeSelection& selection,
                   const Progress& progress) {
  ProgressMeter meter(progress, "boundary", 0);
  for (const ContractedEdge& edge : around.edges) {
    const MeasuredEdge measured{around.points[edge.a], around.points[edge.b]};
    const auto reached = search.run(std::array{edge.a, edge.b},
                                    [&](Index, double d) { return d <= measured.length; });
    if (!meter.step(reached.size())) return;
    for (const Index v : reached)
      if (!around.on_boundary[v] && is_in_zone(measured, around.points[v], around.zone))
        selection.invalidate(v);
  }
}

SearchCount inspect_edges(LocalSearch& search, std::span<const Point2> points,
                          std::span<const ContractedEdge> edges, const Progress& progress) {
  ProgressMeter meter(progress, "boundary", 0);
  std::vector<std::size_t> inspected(points.size());
  for (const ContractedEdge& edge : edges) {
    const MeasuredEdge measured{points[edge.a], points[edge.b]};
    const auto within = [&](Index v, double) {
      return v == edge.a || v == edge.b || measured.has_in_diametral_circle(points[v]);
    };
    for (const Index end : {edge.a, edge.b}) {
      const std::size_t reached = search.run(std::array{end}, within).size();
      inspected[end] += reached;
      meter.step(reached);
    }
    if (meter.stopped()) break;
  }
  SearchCount count;
  for (const std::size_t nodes : inspected)
    if (nodes > 0) count.add(nodes);
  return count;
}

}  // namespace wellspaced
