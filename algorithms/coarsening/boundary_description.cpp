#include "wellspaced/algorithms/coarsening/boundary_description.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// The segments in both directions, sorted by where they start.
std::vector<Segment> sorted_arcs(std::span<const Segment> segments) {
  std::vector<Segment> arcs;
  for (const Segment& s : segments) {
    arcs.push_back({s.a, s.b, s.marker});
    arcs.push_back({s.b, s.a, s.marker});
  }
  sort(arcs, [](const Segment& a, const Segment& b) {
    return std::tie(a.a, a.b, a.marker) < std::tie(b.a, b.b, b.marker);
  });
  return arcs;
}

std::span<const Segment> arcs_from(std::span<const Segment> arcs, Index v) {
  const auto first =
      std::partition_point(arcs.begin(), arcs.end(), [=](const Segment& arc) { return arc.a < v; });
  const auto last = std::find_if(first, arcs.end(), [=](const Segment& arc) { return arc.a != v; });
  return {first, last};
}

// Whether a chain runs straight on at the node that both arcs leave.
bool runs_straight(std::span<const Point2> points, const Segment& to, const Segment& on) {
  const Point2 before = points[to.b], at = points[to.a], after = points[on.b];
  const auto between = [](double a, double b, double c) {
    return (a <= b && b <= c) || (c <= b && b <= a);
  };
  return orient2d(before, at, after) == 0 && between(before.x, at.x, after.x) &&
         between(before.y, at.y, after.y);
}

bool is_inside_a_segment(std::span<const Point2> points, std::span<const Segment> arcs) {
  return arcs.size() == 2 && arcs[0].marker == arcs[1].marker &&
         runs_straight(points, arcs[0], arcs[1]);
}

}  // namespace

BoundaryDescription boundary_description(const TriangleMesh& mesh) {
  const std::vector<Segment> arcs = sorted_arcs(mesh.segments);
  std::vector<std::uint8_t> in_triangle(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle) in_triangle[v] = 1;

  BoundaryDescription b;
  std::vector<Index> number(mesh.points.size(), kNoIndex);
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const auto around = arcs_from(arcs, v);
    if (around.empty() ? in_triangle[v] : is_inside_a_segment(mesh.points, around)) continue;
    number[v] = static_cast<Index>(b.vertices.size());
    b.vertices.push_back(v);
    b.graph.points.push_back(mesh.points[v]);
  }
  for (const Index v : b.vertices) {
    for (Segment arc : arcs_from(arcs, v)) {
      while (number[arc.b] == kNoIndex) {
        const auto on = arcs_from(arcs, arc.b);
        arc = on[0].b == arc.a ? on[1] : on[0];
      }
      if (number[v] < number[arc.b])
        b.graph.segments.push_back({number[v], number[arc.b], arc.marker});
    }
  }
  return b;
}

}  // namespace wellspaced
