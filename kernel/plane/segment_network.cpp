#include "wellspaced/kernel/plane/segment_network.hpp"

#include <algorithm>

#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr std::uint64_t kSegmentsAQuestion = 256;

// Which segment a constrained edge is a piece of; with overlaps there are several.
struct Owner {
  Index low, high;  // the edge's ends
  Index segment, piece;
  friend auto operator<=>(const Owner&, const Owner&) = default;
};

Owner piece_of(const std::vector<Index>& path, Index segment, Index piece) {
  const auto [low, high] = std::minmax(path[piece], path[piece + 1]);
  return {low, high, segment, piece};
}

// Adds the crossings of one piece of segment `s`, which crosses `edge`, with the edge's owners.
void add_crossings(const std::vector<Owner>& owners, std::array<Index, 2> edge, Index s,
                   Index piece, std::vector<SegmentCrossing>& crossings) {
  const auto [low, high] = std::minmax(edge[0], edge[1]);
  auto owner = std::lower_bound(owners.begin(), owners.end(), Owner{low, high, 0, 0});
  for (; owner != owners.end() && owner->low == low && owner->high == high; ++owner) {
    const Index t = owner->segment;
    crossings.push_back(s < t ? SegmentCrossing{{s, t}, {piece, owner->piece}}
                              : SegmentCrossing{{t, s}, {owner->piece, piece}});
  }
}

// Follows segment s through the triangulation of one round, through constrained edges as well.
void trace(const Delaunay2& dt, Index s, const Segment& segment, const std::vector<Owner>& owners,
           std::vector<SegmentCrossing>& crossings) {
  const Index end = dt.representative(segment.b);
  std::vector<Index> path{dt.representative(segment.a)};
  std::vector<Delaunay2::Edge> crossed;
  while (path.back() != end) {
    const Index piece = static_cast<Index>(path.size()) - 1;
    path.push_back(dt.walk_to_next_vertex(path.back(), end, crossed));
    for (const Delaunay2::Edge e : crossed)
      if (dt.topology().is_constrained(e))
        add_crossings(owners, {dt.topology().origin(e), dt.topology().destination(e)}, s, piece,
                      crossings);
  }
}

}  // namespace

Result<SegmentNetwork> segment_network(std::span<const Point2> points,
                                       std::span<const Segment> segments,
                                       const Progress& progress) {
  ProgressMeter meter(progress, "cross", 0, kSegmentsAQuestion);
  const auto go_on = [&](auto, auto, auto) { return meter.step(kSegmentsAQuestion); };
  const Result<Delaunay2> bare = Delaunay2::build(points, {go_on});
  if (!bare) return bare.error();
  SegmentNetwork network;
  network.paths.resize(segments.size());
  std::vector<Index> waiting(segments.size());
  for (Index s = 0; s < segments.size(); ++s) waiting[s] = s;
  while (!waiting.empty()) {
    Delaunay2 dt = *bare;
    std::vector<Owner> owners;
    std::vector<Index> refused;
    for (const Index s : waiting) {
      if (!meter.step()) return cancelled();
      Result<std::vector<Index>> path = dt.insert_constraint(segments[s].a, segments[s].b);
      if (!path) {
        refused.push_back(s);
        continue;
      }
      network.paths[s] = std::move(*path);
      for (Index piece = 0; piece + 1 < network.paths[s].size(); ++piece)
        owners.push_back(piece_of(network.paths[s], s, piece));
    }
    sort(owners);
    for (const Index s : refused) {
      if (!meter.step()) return cancelled();
      trace(dt, s, segments[s], owners, network.crossings);
    }
    waiting = std::move(refused);
  }
  sort(network.crossings);
  return network;
}

}  // namespace wellspaced
