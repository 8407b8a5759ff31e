#include "wellspaced/algorithms/coarsening/level_triangulation.hpp"

#include "wellspaced/kernel/plane/delaunay2.hpp"

namespace wellspaced {
namespace {

using Edge = Triangulation2::Edge;
std::size_t slot(Edge e) { return std::size_t{3} * e.triangle + e.i; }

// What the domain edges say about the two sides of every edge of the triangulation.
struct DomainSides {
  // For edge i of triangle t at 3 t + i: how many domain edges run along it with t on their left,
  // less those with t on their right.
  std::vector<std::int8_t> turns;
  // True where a domain edge runs along it, whatever the direction: both sides belong apart.
  std::vector<std::uint8_t> is_wall;

  explicit DomainSides(const Triangulation2& topology)
      : turns(std::size_t{3} * topology.size(), 0), is_wall(turns.size(), 0) {}

  void add(const Triangulation2& topology, Edge left) {
    const Edge right = topology.mirror(left);
    ++turns[slot(left)];
    --turns[slot(right)];
    is_wall[slot(left)] = is_wall[slot(right)] = 1;
  }
};

// Forces the edges into the triangulation. Returns them in the same order, each in the pieces that
// points on it make of it.
Result<std::vector<ConstrainedEdge>> insert_edges(Delaunay2& delaunay,
                                                  std::span<const ConstrainedEdge> edges) {
  std::vector<ConstrainedEdge> pieces;
  for (const ConstrainedEdge& edge : edges) {
    auto along = delaunay.insert_constraint(edge.a, edge.b);
    if (!along) return along.error();
    // The ends keep their own names, of which the vertex may stand for several.
    along->front() = edge.a;
    along->back() = edge.b;
    for (std::size_t i = 0; i + 1 < along->size(); ++i)
      pieces.push_back({(*along)[i], (*along)[i + 1], edge.marker, edge.kind});
  }
  return pieces;
}

Edge left_edge(const Delaunay2& delaunay, const ConstrainedEdge& piece) {
  return delaunay.find_edge(delaunay.representative(piece.a), delaunay.representative(piece.b));
}

// The winding number of the domain edges around each triangle, found by a walk from the outside.
std::vector<int> winding_numbers(const Triangulation2& topology, const DomainSides& sides) {
  std::vector<int> winding(topology.size(), 0);
  std::vector<std::uint8_t> reached(topology.size(), 0);
  std::vector<Index> stack;
  for (Index t = 0; t < topology.size() && stack.empty(); ++t)
    if (topology.is_ghost(t)) stack.push_back(t), reached[t] = 1;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (unsigned i = 0; i < 3; ++i) {
      const Index next = topology.neighbor(t, i);
      if (reached[next]) continue;
      reached[next] = 1;
      winding[next] = winding[t] - sides.turns[slot({t, i})];
      stack.push_back(next);
    }
  }
  return winding;
}

// Gives the corners at a vertex with several names that of the domain edge they lie behind: from
// the left of each edge counter-clockwise around its origin, up to the next wall.
void name_corners(const Delaunay2& delaunay, const DomainSides& sides,
                  std::span<const ConstrainedEdge> pieces,
                  std::vector<std::array<Index, 3>>& names) {
  const Triangulation2& topology = delaunay.topology();
  for (const ConstrainedEdge& piece : pieces) {
    if (piece.kind != ConstrainedEdge::Kind::kDomain) continue;
    Edge e = left_edge(delaunay, piece);
    do {
      names[e.triangle][Triangulation2::next(e.i)] = piece.a;
      e = topology.next_around_origin(e);
    } while (!sides.is_wall[slot(e)]);
  }
}

std::vector<std::array<Index, 3>> all_corners(const Triangulation2& topology) {
  std::vector<std::array<Index, 3>> corners(topology.size());
  for (Index t = 0; t < topology.size(); ++t) corners[t] = topology.vertices(t);
  return corners;
}

std::vector<Segment> as_segments(std::span<const ConstrainedEdge> edges) {
  std::vector<Segment> segments;
  for (const ConstrainedEdge& edge : edges) segments.push_back({edge.a, edge.b, edge.marker});
  return segments;
}

}  // namespace

Result<DomainTriangulation> triangulate_domain(std::span<const Point2> points,
                                               std::span<const ConstrainedEdge> edges,
                                               std::span<const Index> along_curve,
                                               const Progress& progress) {
  auto delaunay = along_curve.empty() ? Delaunay2::build(points, {.progress = progress})
                                      : Delaunay2::build(points, along_curve);
  if (!delaunay) return delaunay.error();
  if (delaunay->dimension() < 2) return DomainTriangulation{{}, as_segments(edges)};

  auto pieces = insert_edges(*delaunay, edges);
  if (!pieces) return pieces.error();

  const Triangulation2& topology = delaunay->topology();
  DomainSides sides(topology);
  for (const ConstrainedEdge& piece : *pieces)
    if (piece.kind == ConstrainedEdge::Kind::kDomain)
      sides.add(topology, left_edge(*delaunay, piece));
  auto corners = all_corners(topology);
  if (delaunay->duplicate_count() > 0) name_corners(*delaunay, sides, *pieces, corners);

  DomainTriangulation result{{}, as_segments(*pieces)};
  const std::vector<int> winding = winding_numbers(topology, sides);
  for (Index t = 0; t < topology.size(); ++t)
    if (winding[t] > 0 && !topology.is_ghost(t)) result.triangles.push_back(corners[t]);
  return result;
}

}  // namespace wellspaced
