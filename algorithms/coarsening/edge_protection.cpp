#include "wellspaced/algorithms/coarsening/edge_protection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wellspaced/algorithms/coarsening/measured_edge.hpp"
#include "wellspaced/kernel/distance.hpp"

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
                   const ProtectiveZone& zone, NodeSelection& selection) {
  for (const ContractedEdge& edge : edges) {
    const MeasuredEdge measured{points[edge.a], points[edge.b]};
    for (const Index v : search.run(std::array{edge.a, edge.b},
                                    [&](Index, double d) { return d <= measured.length; })) {
      const bool close = is_abreast(measured, points[v], zone.shape) &&
                         measured.distance_of_line_from(points[v]) < zone.ratio * measured.length;
      if (close && !on_boundary[v]) selection.invalidate(v);
    }
  }
}

SearchCount inspect_edges(LocalSearch& search, std::span<const Point2> points,
                          std::span<const ContractedEdge> edges, double ratio,
                          const NodeSelection& selection) {
  SearchCount count;
  for (const ContractedEdge& edge : edges) {
    const Point2 a = points[edge.a], b = points[edge.b];
    const Point2 middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
    const double radius = std::sqrt(0.25 + ratio * ratio) * distance(a, b);
    search.run(std::array{edge.a, edge.b},
               [&](Index v, double) { return distance(points[v], middle) <= radius; });
    count.add(static_cast<std::size_t>(std::ranges::count_if(
        search.include_frontier(), [&](Index v) { return !selection.is_selected(v); })));
  }
  return count;
}

}  // namespace wellspaced
