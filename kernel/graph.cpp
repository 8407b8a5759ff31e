#include "wellspaced/kernel/graph.hpp"

#include <algorithm>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using TableCorner = CornerTable::Corner;

bool adjacent(std::span<const TableCorner> corners, Index node) {
  return any_of(corners, [=](TableCorner c) { return c.next == node || c.previous == node; });
}

// The segments that are no edge of a triangle, in both directions, sorted, each once.
std::vector<std::array<Index, 2>> loose_arcs(const CornerTable& table,
                                             std::span<const Segment> segments) {
  std::vector<std::array<Index, 2>> arcs;
  for (const Segment& s : segments) {
    if (s.a == s.b || adjacent(table.at(s.a), s.b)) continue;
    arcs.push_back({s.a, s.b});
    arcs.push_back({s.b, s.a});
  }
  sort_unique(arcs);
  return arcs;
}

// Appends the neighbours of v in its triangles: all that come next in some corner, then those that
// only come previous, which are across boundary edges into v.
void append_neighbors(std::span<const TableCorner> corners, std::vector<Index>& neighbors) {
  const auto start = static_cast<std::ptrdiff_t>(neighbors.size());
  for (const TableCorner c : corners) neighbors.push_back(c.next);
  const auto next_end = start + static_cast<std::ptrdiff_t>(corners.size());
  for (const TableCorner c : corners) {
    const auto begin = neighbors.begin() + start, end = neighbors.begin() + next_end;
    if (std::find(begin, end, c.previous) == end) neighbors.push_back(c.previous);
  }
}

}  // namespace

Graph mesh_graph(std::span<const Point2> points, const CornerTable& table,
                 std::span<const Segment> segments) {
  const std::vector<std::array<Index, 2>> loose = loose_arcs(table, segments);
  auto next_loose = loose.begin();
  Graph graph;
  graph.first.reserve(points.size() + 1);
  graph.first.push_back(0);
  graph.arcs.reserve(table.corners.size() + table.corners.size() / 16 + loose.size());
  std::vector<Index> neighbors;
  for (Index v = 0; v < points.size(); ++v) {
    neighbors.clear();
    append_neighbors(table.at(v), neighbors);
    for (; next_loose != loose.end() && (*next_loose)[0] == v; ++next_loose)
      neighbors.push_back((*next_loose)[1]);
    for (const Index w : neighbors) graph.arcs.push_back({w, distance(points[v], points[w])});
    graph.first.push_back(static_cast<Index>(graph.arcs.size()));
  }
  return graph;
}

Graph mesh_graph(const TriangleMesh& mesh) {
  const auto nodes = static_cast<Index>(mesh.points.size());
  return mesh_graph(mesh.points, corner_table(mesh.triangles, nodes), mesh.segments);
}

}  // namespace wellspaced
