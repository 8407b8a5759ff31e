#include "wellspaced/algorithms/packing/corner_shells.hpp"

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using Edge = Triangulation2::Edge;

constexpr double kSharpCosine = 0.5 + 1e-9;

double cosine_at(Point2 apex, Point2 p, Point2 q) {
  const double to_p = distance(apex, p), to_q = distance(apex, q);
  return (p.x - apex.x) / to_p * ((q.x - apex.x) / to_q) +
         (p.y - apex.y) / to_p * ((q.y - apex.y) / to_q);
}

// The constrained edges that leave vertex v, counter-clockwise.
std::vector<Edge> segments_at(const Delaunay2& delaunay, Index v) {
  std::vector<Edge> segments;
  const Edge first = delaunay.edge_from(v);
  if (first.triangle == kNoIndex) return segments;
  Edge e = first;
  do {
    if (delaunay.topology().is_constrained(e)) segments.push_back(e);
    e = delaunay.topology().next_around_origin(e);
  } while (e != first);
  return segments;
}

}  // namespace

std::vector<Corner> sharp_corners(const PlanarTriangulation& graph) {
  const Delaunay2& delaunay = graph.delaunay;
  const std::vector<Point2>& points = delaunay.points();
  std::vector<Corner> corners;
  for (Index v = 0; v < points.size(); ++v) {
    const std::vector<Edge> segments = segments_at(delaunay, v);
    for (std::size_t i = 0; i < segments.size() && segments.size() > 1; ++i) {
      if (!graph.in_domain[segments[i].triangle]) continue;
      const Index right = delaunay.topology().destination(segments[i]);
      const Index left = delaunay.topology().destination(segments[(i + 1) % segments.size()]);
      const double cosine = cosine_at(points[v], points[right], points[left]);
      if (cosine > kSharpCosine && orient2d(points[v], points[right], points[left]) > 0)
        corners.push_back({v, right, left, cosine});
    }
  }
  return corners;
}

}  // namespace wellspaced
