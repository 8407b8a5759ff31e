#include "wellspaced/algorithms/coarsening/edge_protection.hpp"

#include <array>

#include "wellspaced/algorithms/coarsening/measured_edge.hpp"

namespace wellspaced {
namespace {

// Whether a point that is near enough to the edge's line is in its zone.
bool is_abreast(const MeasuredEdge& edge, Point2 p, ProtectiveZone::Shape shape) {
  return shape == ProtectiveZone::Shape::kLens ? edge.has_in_diametral_circle(p)
                                               : edge.has_between_perpendiculars(p);
}

}  // namespace

void protect_edges(LocalSearch& search, std::span<const Point2> points,
                   std::span<const ContractedEdge> edges, std::span<const std::uint8_t> on_boundary,
                   const ProtectiveZone& zone, NodeSelection& selection, const Progress& progress) {
  ProgressMeter meter(progress, "boundary", 0);
  for (const ContractedEdge& edge : edges) {
    const MeasuredEdge measured{points[edge.a], points[edge.b]};
    const auto reached = search.run(std::array{edge.a, edge.b},
                                    [&](Index, double d) { return d <= measured.length; });
    if (!meter.step(reached.size())) return;
    for (const Index v : reached) {
      const bool close = is_abreast(measured, points[v], zone.shape) &&
                         measured.distance_of_line_from(points[v]) < zone.ratio * measured.length;
      if (close && !on_boundary[v]) selection.invalidate(v);
    }
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
