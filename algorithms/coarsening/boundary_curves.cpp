#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using Ends = std::array<Index, 2>;
using Kind = BoundaryCurve::Kind;

Ends unordered(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// The segments by their ends, each once.
struct MarkedEnds {
  Ends ends{};
  int marker = 0;
};

std::vector<MarkedEnds> sorted_segments(std::span<const Segment> segments) {
  std::vector<MarkedEnds> sorted;
  sorted.reserve(segments.size());
  for (const Segment& s : segments)
    if (s.a != s.b) sorted.push_back({unordered(s.a, s.b), s.marker});
  const auto less = [](const auto& a, const auto& b) { return a.ends < b.ends; };
  const auto equal = [](const auto& a, const auto& b) { return a.ends == b.ends; };
  sort(sorted, less);
  sorted.erase(std::unique(sorted.begin(), sorted.end(), equal), sorted.end());
  return sorted;
}

int marker_of(std::span<const MarkedEnds> segments, Ends ends) {
  const auto less = [](const MarkedEnds& a, const Ends& b) { return a.ends < b; };
  const auto found = std::lower_bound(segments.begin(), segments.end(), ends, less);
  return found != segments.end() && found->ends == ends ? found->marker : 1;
}

// Directed edges sorted by their first node, each to be taken once.
class EdgeList {
 public:
  explicit EdgeList(std::vector<Ends> edges) : edges_(std::move(edges)), taken_(edges_.size()) {}

  const std::vector<Ends>& edges() const { return edges_; }
  bool taken(std::size_t i) const { return taken_[i] != 0; }

  std::span<const Ends> from(Index v) const {
    const auto first = std::lower_bound(edges_.begin(), edges_.end(), Ends{v, 0});
    const auto last = std::find_if(first, edges_.end(), [=](const Ends& e) { return e[0] != v; });
    return {first, last};
  }
  // Takes the edge from v to w. Returns whether there was one left to take.
  bool take(Index v, Index w) {
    for (const Ends& edge : from(v)) {
      const auto i = static_cast<std::size_t>(&edge - edges_.data());
      if (edge[1] == w && !taken_[i]) return taken_[i] = 1, true;
    }
    return false;
  }

 private:
  std::vector<Ends> edges_;
  std::vector<std::uint8_t> taken_;
};

void append_edge(BoundaryCurve& curve, Index from, Index to, std::span<const MarkedEnds> segments) {
  curve.nodes.push_back(from);
  curve.markers.push_back(marker_of(segments, unordered(from, to)));
}

// The closed curves with the domain on their left, each from its lowest untaken edge on.
void trace_domain_curves(const CornerTable& table, std::span<const MarkedEnds> segments,
                         EdgeList& list, std::vector<BoundaryCurve>& curves) {
  for (const auto& [start, second] : list.edges()) {
    BoundaryCurve curve;
    for (Index u = start, v = second; v != kNoIndex && list.take(u, v);) {
      append_edge(curve, u, v, segments);
      const auto out = list.from(v);
      const Index w = out.size() == 1 ? out[0][1] : table.next_boundary_node(u, v);
      u = std::exchange(v, w);
    }
    if (!curve.nodes.empty()) curves.push_back(std::move(curve));
  }
}

// Follows inner segments from u over v to the next end, or around to u.
BoundaryCurve trace_inner_curve(Index u, Index v, std::span<const std::uint8_t> is_end,
                                std::span<const MarkedEnds> segments, EdgeList& list) {
  BoundaryCurve curve{Kind::kInner, true, {}, {}};
  const Index start = u;
  while (list.take(u, v) && list.take(v, u)) {
    append_edge(curve, u, v, segments);
    curve.closed = v == start && !is_end[v];
    if (v == start || is_end[v]) break;
    const auto out = list.from(v);
    u = std::exchange(v, out[0][1] == u ? out[1][1] : out[0][1]);
  }
  if (!curve.closed) curve.nodes.push_back(v);
  return curve;
}

// Both directions of the segments that are no boundary edge of the triangles.
std::vector<Ends> inner_edges(std::span<const MarkedEnds> segments, const EdgeList& domain) {
  const auto has = [&](Index a, Index b) {
    return std::ranges::any_of(domain.from(a), [=](const Ends& e) { return e[1] == b; });
  };
  std::vector<Ends> inner;
  for (const auto& [ends, marker] : segments) {
    if (has(ends[0], ends[1]) || has(ends[1], ends[0])) continue;
    inner.push_back(ends);
    inner.push_back({ends[1], ends[0]});
  }
  sort(inner);
  return inner;
}

void trace_inner_curves(std::span<const MarkedEnds> segments,
                        std::span<const std::uint8_t> on_domain_curve, EdgeList& list,
                        Boundary& boundary) {
  std::vector<std::uint8_t> is_end(on_domain_curve.begin(), on_domain_curve.end());
  for (const auto& [u, v] : list.edges())
    if (list.from(u).size() != 2) is_end[u] = 1;
  for (const bool from_ends : {true, false}) {
    for (std::size_t i = 0; i < list.edges().size(); ++i) {
      const auto [u, v] = list.edges()[i];
      if (list.taken(i) || (is_end[u] != 0) != from_ends) continue;
      boundary.curves.push_back(trace_inner_curve(u, v, is_end, segments, list));
    }
  }
}

void mark_nodes(std::span<const BoundaryCurve> curves, std::vector<std::uint8_t>& marks) {
  for (const BoundaryCurve& curve : curves)
    for (const Index v : curve.nodes) marks[v] = 1;
}

std::vector<Index> marked_nodes(std::span<const std::uint8_t> marks) {
  std::vector<Index> nodes;
  for (Index v = 0; v < marks.size(); ++v)
    if (marks[v]) nodes.push_back(v);
  return nodes;
}

// Ties each run of equal points into a circular list.
TwinNodes find_twins(std::span<const Point2> points, std::vector<Index> nodes) {
  const auto position = [&](Index v) { return std::pair{points[v].x, points[v].y}; };
  sort(nodes, [&](Index a, Index b) {
    return position(a) < position(b) || (position(a) == position(b) && a < b);
  });
  TwinNodes twins;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (points[nodes[i]] != points[nodes[i - 1]]) continue;
    if (twins.next.empty()) {
      twins.next.resize(points.size());
      for (Index v = 0; v < points.size(); ++v) twins.next[v] = v;
    }
    std::swap(twins.next[nodes[i]], twins.next[nodes[i - 1]]);
  }
  return twins;
}

// Where the two lips of a slit meet: the nodes before and after are twins.
bool is_slit_tip(const BoundaryCurve& curve, std::size_t position, std::span<const Point2> points) {
  const Index before = curve.node(position + curve.nodes.size() - 1);
  const Index after = curve.node(position + 1);
  return before != after && points[before] == points[after];
}

std::vector<Index> find_anchors(std::span<const BoundaryCurve> curves,
                                std::span<const Point2> points) {
  std::vector<Index> anchors;
  for (const BoundaryCurve& curve : curves) {
    if (!curve.closed) anchors.insert(anchors.end(), {curve.nodes.front(), curve.nodes.back()});
    if (curve.kind != Kind::kDomain) continue;
    for (std::size_t i = 0; i < curve.nodes.size(); ++i)
      if (is_slit_tip(curve, i, points)) anchors.push_back(curve.nodes[i]);
  }
  sort_unique(anchors);
  return anchors;
}

}  // namespace

Boundary boundary_of(const TriangleMesh& mesh, const CornerTable& table) {
  const std::vector<MarkedEnds> segments = sorted_segments(mesh.segments);
  Boundary boundary;
  boundary.on_boundary.assign(mesh.points.size(), 0);

  EdgeList domain(boundary_edges(table));
  trace_domain_curves(table, segments, domain, boundary.curves);
  mark_nodes(boundary.curves, boundary.on_boundary);
  boundary.twins = find_twins(mesh.points, marked_nodes(boundary.on_boundary));

  EdgeList inner(inner_edges(segments, domain));
  trace_inner_curves(segments, boundary.on_boundary, inner, boundary);
  mark_nodes(boundary.curves, boundary.on_boundary);
  boundary.nodes = marked_nodes(boundary.on_boundary);
  boundary.anchors = find_anchors(boundary.curves, mesh.points);
  return boundary;
}

std::vector<Segment> boundary_segments(const Boundary& boundary) {
  std::vector<Segment> segments;
  for (const BoundaryCurve& curve : boundary.curves)
    for (std::size_t i = 0; i < curve.edges(); ++i)
      segments.push_back({curve.nodes[i], curve.node(i + 1), curve.markers[i]});
  return segments;
}

}  // namespace wellspaced
