#include "wellspaced/algorithms/audit/half_edges.hpp"

#include <algorithm>

#include "wellspaced/kernel/sort_unique.hpp"

namespace wellspaced::audit {
namespace {

using Triangles = std::span<const std::array<Index, 3>>;

// All half-edges and segments, listed by their lower node; an entry is (higher node, item), where
// item is a half-edge or, from 3 * triangles on, a segment.
class EdgeLists {
 public:
  EdgeLists(Triangles triangles, std::span<const Segment> segments, Index nodes)
      : first_(nodes + 1, 0), entries_(3 * triangles.size() + segments.size()) {
    for_each_edge(triangles, segments, [&](Index low, Index, Index) { ++first_[low]; });
    Index sum = 0;
    for (Index& first : first_) first = sum += first;
    for_each_edge(triangles, segments, [&](Index low, Index high, Index item) {
      entries_[--first_[low]] = std::uint64_t{high} << 32 | item;
    });
  }

  // The edges from one lower node, sorted by higher node, then by item.
  std::span<std::uint64_t> sorted_from(Index low) {
    const std::span<std::uint64_t> list(entries_.data() + first_[low],
                                        entries_.data() + first_[low + 1]);
    std::sort(list.begin(), list.end());
    return list;
  }

 private:
  template <class Visit>
  static void for_each_edge(Triangles triangles, std::span<const Segment> segments, Visit visit) {
    Index item = 0;
    for (const auto& t : triangles)
      for (int i = 0; i < 3; ++i) visit_sorted(t[i], t[i == 2 ? 0 : i + 1], item++, visit);
    for (const Segment& s : segments) visit_sorted(s.a, s.b, item++, visit);
  }

  template <class Visit>
  static void visit_sorted(Index a, Index b, Index item, Visit& visit) {
    visit(std::min(a, b), std::max(a, b), item);
  }

  std::vector<Index> first_;
  std::vector<std::uint64_t> entries_;
};

Index item_of(std::uint64_t entry) { return static_cast<Index>(entry); }

// Turns the sorted lists, edge by edge, into the result.
class Pairing {
 public:
  Pairing(Triangles triangles, std::span<const Segment> segments)
      : triangles_(triangles), segments_(segments) {
    result_.twin.assign(3 * triangles.size(), kNoIndex);
    result_.constrained.assign(3 * triangles.size(), 0);
    result_.segment_edge.assign(segments.size(), kNoIndex);
    half_edges_ = static_cast<Index>(3 * triangles.size());
  }

  // All that lies on one edge: half-edges first, because their items are lower.
  void take_edge(std::span<const std::uint64_t> items) {
    const auto is_half_edge = [&](std::uint64_t entry) { return item_of(entry) < half_edges_; };
    const auto split =
        std::partition_point(items.begin(), items.end(), is_half_edge) - items.begin();
    const auto sides = items.first(split), segments = items.subspan(split);
    if (!segments.empty()) take_segments(segments, sides);
    if (sides.empty()) return;
    ++result_.edges;
    if (sides.size() > 1) pair_up(sides);
  }

  HalfEdges take_result() {
    auto& duplicates = result_.duplicate_triangles;
    std::sort(result_.duplicate_segments.begin(), result_.duplicate_segments.end());
    std::sort(result_.conflicting_segments.begin(), result_.conflicting_segments.end());
    sort_unique(duplicates);
    return std::move(result_);
  }

 private:
  void take_segments(std::span<const std::uint64_t> segments,
                     std::span<const std::uint64_t> sides) {
    for (const std::uint64_t side : sides) result_.constrained[item_of(side)] = 1;
    for (const std::uint64_t& entry : segments) {
      const Index segment = item_of(entry) - half_edges_;
      if (!sides.empty()) result_.segment_edge[segment] = item_of(sides[0]);
      if (&entry != &segments[0]) take_duplicate(item_of(segments[0]) - half_edges_, segment);
    }
  }

  void take_duplicate(Index earlier, Index segment) {
    result_.duplicate_segments.push_back(segment);
    if (segments_[earlier].marker != segments_[segment].marker)
      result_.conflicting_segments.push_back(segment);
  }

  void pair_up(std::span<const std::uint64_t> sides) {
    find_duplicates(sides);
    const Index h = item_of(sides[0]), g = item_of(sides[1]);
    if (sides.size() > 2) return list_edge(result_.crowded_edges, h);
    if (origin(triangles_, h) == origin(triangles_, g))
      return list_edge(result_.disagreeing_edges, h);
    result_.twin[h] = g;
    result_.twin[g] = h;
  }

  void list_edge(std::vector<Index>& list, Index h) const {
    list.insert(list.end(), {origin(triangles_, h), target(triangles_, h)});
  }

  // Triangles on one edge have the same nodes if they have the same apex.
  void find_duplicates(std::span<const std::uint64_t> sides) {
    if (sides.size() == 2 && apex_of(sides[0]) != apex_of(sides[1])) return;
    apexes_.clear();
    for (const std::uint64_t side : sides)
      apexes_.push_back(std::uint64_t{apex_of(side)} << 32 | item_of(side) / 3);
    std::sort(apexes_.begin(), apexes_.end());
    for (std::size_t i = 1; i < apexes_.size(); ++i)
      if (apexes_[i - 1] >> 32 == apexes_[i] >> 32)
        result_.duplicate_triangles.push_back(item_of(apexes_[i]));
  }

  Index apex_of(std::uint64_t entry) const { return apex(triangles_, item_of(entry)); }

  Triangles triangles_;
  std::span<const Segment> segments_;
  Index half_edges_ = 0;
  HalfEdges result_;
  std::vector<std::uint64_t> apexes_;
};

// Marks the fan of triangles around the origin of `h`: to the right as far as it goes, which may be
// all around, then to the left.
void mark_fan(const HalfEdges& half_edges, Index h, std::vector<std::uint8_t>& marked) {
  for (Index g = h; g != kNoIndex && marked[g] == 0; g = half_edges.turn_right(g)) marked[g] = 1;
  for (Index g = half_edges.turn_left(h); g != kNoIndex && marked[g] == 0;
       g = half_edges.turn_left(g))
    marked[g] = 1;
}

// The root of the tree that t is in, halving the path on the way.
Index root(std::vector<Index>& parent, Index t) {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

}  // namespace

HalfEdges pair_half_edges(Triangles triangles, std::span<const Segment> segments, Index nodes) {
  EdgeLists lists(triangles, segments, nodes);
  Pairing pairing(triangles, segments);
  for (Index low = 0; low < nodes; ++low) {
    const auto list = lists.sorted_from(low);
    for (std::size_t i = 0, end = 0; i < list.size(); i = end) {
      while (end < list.size() && list[end] >> 32 == list[i] >> 32) ++end;
      pairing.take_edge(list.subspan(i, end - i));
    }
  }
  return pairing.take_result();
}

std::vector<std::uint8_t> count_fans(Triangles triangles, const HalfEdges& half_edges,
                                     std::size_t nodes, std::uint64_t& total) {
  std::vector<std::uint8_t> fans(nodes, 0), marked(half_edges.twin.size(), 0);
  total = 0;
  for (Index h = 0; h < marked.size(); ++h) {
    if (marked[h] != 0) continue;
    mark_fan(half_edges, h, marked);
    std::uint8_t& count = fans[origin(triangles, h)];
    if (count < 255) ++count;
    ++total;
  }
  return fans;
}

// Triangles are united with their neighbours; the lowest of each set is its root.
std::uint64_t count_components(const HalfEdges& half_edges) {
  std::vector<Index> parent(half_edges.twin.size() / 3);
  for (Index t = 0; t < parent.size(); ++t) parent[t] = t;
  for (Index h = 0; h < half_edges.twin.size(); ++h) {
    const Index twin = half_edges.twin[h];
    if (twin == kNoIndex || twin < h) continue;
    const Index a = root(parent, h / 3), b = root(parent, twin / 3);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::uint64_t components = 0;
  for (Index t = 0; t < parent.size(); ++t) components += parent[t] == t;
  return components;
}

}  // namespace wellspaced::audit
