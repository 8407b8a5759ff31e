#include "wellspaced/kernel/plane/triangulate.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "wellspaced/kernel/plane/segment_network.hpp"
#include "wellspaced/kernel/plane/split_crossings.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using Edge = Triangulation2::Edge;

constexpr Index kSegmentsAReport = 1 << 10;

Status check_segments(const Pslg& graph) {
  std::vector<Index> bad;
  for (Index s = 0; s < graph.segments.size(); ++s)
    if (std::max(graph.segments[s].a, graph.segments[s].b) >= graph.points.size()) bad.push_back(s);
  if (bad.empty()) return Ok{};
  return Error{ErrorCode::kInvalidGeometry,
               {"segment ", bad[0], " ends at a point that does not exist"},
               std::move(bad)};
}

// ---- Segments ------------------------------------------------------------------------------

// The pieces of a chain of vertices, as segments with a < b.
void add_pieces(const std::vector<Index>& chain, int marker, std::vector<Segment>& pieces) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const auto [a, b] = std::minmax(chain[i], chain[i + 1]);
    pieces.push_back({a, b, marker});
  }
}

// Ascending, each edge once, with its largest marker.
void sort_out_repeated(std::vector<Segment>& pieces) {
  sort(pieces, [](const Segment& s, const Segment& t) {
    return std::tie(s.a, s.b, t.marker) < std::tie(t.a, t.b, s.marker);
  });
  const auto same_edge = [](const Segment& s, const Segment& t) {
    return s.a == t.a && s.b == t.b;
  };
  pieces.erase(std::unique(pieces.begin(), pieces.end(), same_edge), pieces.end());
}

// The vertices on the segment from a to b among `sorted`, which are collinear and in order.
std::vector<Index> chain_on_line(const std::vector<Index>& sorted, const std::vector<Index>& place,
                                 Index a, Index b) {
  const auto [low, high] = std::minmax(place[a], place[b]);
  return {sorted.begin() + low, sorted.begin() + high + 1};
}

// All points on one line: its vertices in order, and the segments' pieces between them.
void split_on_line(const Pslg& graph, PlanarTriangulation& result) {
  const Delaunay2& dt = result.delaunay;
  std::vector<Index> sorted, place(graph.points.size());
  for (Index i = 0; i < place.size(); ++i)
    if (dt.is_vertex(i)) sorted.push_back(i);
  sort(sorted, [&](Index i, Index j) {
    const Point2 p = graph.points[i], q = graph.points[j];
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  });
  for (Index k = 0; k < sorted.size(); ++k) place[sorted[k]] = k;
  for (const Segment& s : graph.segments)
    add_pieces(chain_on_line(sorted, place, dt.representative(s.a), dt.representative(s.b)),
               s.marker, result.segments);
  sort_out_repeated(result.segments);
}

// Inserts the segments one by one. Returns whether none crosses another.
Result<bool> insert_segments(const Pslg& graph, const Progress& progress,
                             PlanarTriangulation& result) {
  const auto count = static_cast<Index>(graph.segments.size());
  for (Index i = 0; i < count; ++i) {
    if (i % kSegmentsAReport == 0 && !report(progress, "constrain", i, count)) return cancelled();
    const Segment& s = graph.segments[i];
    const Result<std::vector<Index>> chain = result.delaunay.insert_constraint(s.a, s.b);
    if (!chain) return false;
    add_pieces(*chain, s.marker, result.segments);
  }
  return true;
}

// The ids list every pair; the message as many as fit into a line.
Error crossing_error(const SegmentNetwork& network) {
  constexpr std::size_t kNamed = 20;
  const std::vector<SegmentCrossing>& pairs = network.crossings;
  Error error{ErrorCode::kInvalidGeometry, "", {}};
  error.message =
      concat({pairs.size(), pairs.size() == 1 ? " pair" : " pairs", " of segments cross: "});
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [s, t] = pairs[k].segment;
    error.ids.insert(error.ids.end(), {s, t});
    if (k < kNamed) append(error.message, {k == 0 ? "" : ", ", s, " and ", t});
  }
  if (pairs.size() > kNamed) error.message += ", ...";
  return error;
}

// Starts again with the crossings as vertices, or lists them.
Status resolve_crossings(const Pslg& graph, const TriangulateOptions& options,
                         PlanarTriangulation& result) {
  const Result<SegmentNetwork> network =
      segment_network(graph.points, graph.segments, options.progress);
  if (!network) return network.error();
  if (options.crossings == CrossingRule::kRefuse) return crossing_error(*network);
  Result<SplitGraph> split =
      split_at_crossings(graph.points, graph.segments, *network, options.progress);
  if (!split) return split.error();
  result.added_points = static_cast<Index>(split->delaunay.points().size() - graph.points.size());
  result.delaunay = std::move(split->delaunay);
  result.segments.clear();
  for (std::size_t s = 0; s < split->edges.size(); ++s)
    for (const auto& [a, b] : split->edges[s])
      result.segments.push_back({std::min(a, b), std::max(a, b), graph.segments[s].marker});
  return Ok{};
}

// ---- The domain ----------------------------------------------------------------------------

// Gives `value` to the triangles that can be reached from `front` without crossing a constrained
// edge and have none yet. Returns those behind the constrained edges met.
constexpr std::uint8_t kUnset = 255;

std::vector<Index> flood(const Triangulation2& mesh, std::vector<Index> front, std::uint8_t value,
                         std::vector<std::uint8_t>& values) {
  std::vector<Index> behind;
  std::erase_if(front, [&](Index t) { return values[t] != kUnset; });
  for (const Index t : front) values[t] = value;
  while (!front.empty()) {
    const Index t = front.back();
    front.pop_back();
    for (unsigned i = 0; i < 3; ++i) {
      const Index u = mesh.neighbor(t, i);
      if (values[u] != kUnset) continue;
      if (mesh.is_constrained({t, i})) {
        behind.push_back(u);
      } else {
        values[u] = value;
        front.push_back(u);
      }
    }
  }
  return behind;
}

std::vector<Index> ghosts_of(const Triangulation2& mesh) {
  std::vector<Index> ghosts;
  for (Index t = 0; t < mesh.size(); ++t)
    if (mesh.is_ghost(t)) ghosts.push_back(t);
  return ghosts;
}

// The hole seeds' triangles. A seed outside the hull is in no hole.
std::vector<Index> seeded(const Delaunay2& dt, const std::vector<Point2>& holes) {
  std::vector<Index> triangles;
  for (const Point2 seed : holes) triangles.push_back(dt.locate(seed).edge.triangle);
  return triangles;
}

std::vector<std::uint8_t> find_domain(const Delaunay2& dt, const Pslg& graph, HoleRule rule) {
  const Triangulation2& mesh = dt.topology();
  std::vector<std::uint8_t> inside(mesh.size(), kUnset);
  const std::vector<Index> ghosts = ghosts_of(mesh);
  if (rule == HoleRule::kNone) {
    for (const Index t : ghosts) inside[t] = 0;
  } else {
    std::vector<Index> front = flood(mesh, ghosts, 0, inside);
    if (rule == HoleRule::kSeeds) flood(mesh, seeded(dt, graph.holes), 0, inside);
    for (std::uint8_t level = 1; rule == HoleRule::kParity && !front.empty(); level ^= 1)
      front = flood(mesh, std::move(front), level, inside);
  }
  std::replace(inside.begin(), inside.end(), kUnset, std::uint8_t{1});
  return inside;
}

}  // namespace

std::vector<std::array<Index, 3>> PlanarTriangulation::triangles() const {
  std::vector<std::array<Index, 3>> result;
  for (Index t = 0; t < in_domain.size(); ++t)
    if (in_domain[t]) result.push_back(delaunay.topology().vertices(t));
  return result;
}

Result<PlanarTriangulation> triangulate(const Pslg& graph, const TriangulateOptions& options) {
  if (Status status = check_segments(graph); !status) return status.error();
  Result<Delaunay2> built = Delaunay2::build(graph.points, {options.progress, options.threads});
  if (!built) return built.error();
  PlanarTriangulation result;
  result.delaunay = std::move(*built);
  if (result.delaunay.dimension() < 2) {
    split_on_line(graph, result);
    return result;
  }
  const Result<bool> planar = insert_segments(graph, options.progress, result);
  if (!planar) return planar.error();
  if (!*planar) {
    Status resolved = resolve_crossings(graph, options, result);
    if (!resolved) return resolved.error();
  }
  sort_out_repeated(result.segments);
  if (!report(options.progress, "domain", 0, 0)) return cancelled();
  result.in_domain = find_domain(result.delaunay, graph, options.holes);
  return result;
}

}  // namespace wellspaced
