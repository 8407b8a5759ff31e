#include "wellspaced/algorithms/coarsening/edge_protection.hpp"

#include <array>
#include <cmath>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/local_search.hpp"

namespace wellspaced {
namespace {

bool in_diametral_circle(Point2 p, Point2 a, Point2 b) {
  return (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) < 0;
}

// |edge| times the distance from p to the line through a and b.
double twice_area(Point2 p, Point2 a, Point2 b) {
  return std::fabs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
}

}  // namespace

SearchCount protect_edges(const Graph& graph, std::span<const Point2> points,
                          std::span<const ContractedEdge> edges,
                          std::span<const std::uint8_t> on_boundary, double ratio,
                          NodeSelection& selection) {
  SearchCount count;
  LocalSearch search(graph);
  for (const ContractedEdge& edge : edges) {
    const Point2 a = points[edge.a], b = points[edge.b];
    const double length = distance(a, b);
    const double reach = length * std::sqrt(0.25 + ratio * ratio);
    std::size_t within_reach = 0;
    search.run(
        std::array{edge.a, edge.b}, [](Index, double) { return true; },
        [&](Index v, double d) {
          if (d > length) return false;
          within_reach += d <= reach;
          const Point2 p = points[v];
          const bool close =
              in_diametral_circle(p, a, b) && twice_area(p, a, b) < ratio * length * length;
          if (close && !on_boundary[v]) selection.invalidate(v);
          return true;
        });
    count.add(within_reach);
  }
  return count;
}

}  // namespace wellspaced
