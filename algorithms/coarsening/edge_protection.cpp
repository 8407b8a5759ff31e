#include "wellspaced/algorithms/coarsening/edge_protection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

// An edge with its length, to measure in units of which no product over- or underflows.
struct MeasuredEdge {
  Point2 a, b;
  double length = 0;

  // Whether a point that is near enough to the line is in the zone of that shape.
  bool has_abreast(Point2 p, ProtectiveZone::Shape shape) const {
    return shape == ProtectiveZone::Shape::kLens ? has_in_diametral_circle(p)
                                                 : has_between_perpendiculars(p);
  }
  bool has_in_diametral_circle(Point2 p) const {
    const double ax = (a.x - p.x) / length, ay = (a.y - p.y) / length;
    const double bx = (b.x - p.x) / length, by = (b.y - p.y) / length;
    return ax * bx + ay * by < 0;
  }
  bool has_between_perpendiculars(Point2 p) const {
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    return ux * (p.x - a.x) + uy * (p.y - a.y) > 0 && ux * (p.x - b.x) + uy * (p.y - b.y) < 0;
  }
  double distance_of_line_from(Point2 p) const {
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    return std::fabs(ux * (p.y - a.y) - uy * (p.x - a.x));
  }
};

}  // namespace

void protect_edges(LocalSearch& search, std::span<const Point2> points,
                   std::span<const ContractedEdge> edges, std::span<const std::uint8_t> on_boundary,
                   const ProtectiveZone& zone, NodeSelection& selection) {
  for (const ContractedEdge& edge : edges) {
    const Point2 a = points[edge.a], b = points[edge.b];
    const MeasuredEdge measured{a, b, distance(a, b)};
    for (const Index v : search.run(std::array{edge.a, edge.b},
                                    [&](Index, double d) { return d <= measured.length; })) {
      const bool close = measured.has_abreast(points[v], zone.shape) &&
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
