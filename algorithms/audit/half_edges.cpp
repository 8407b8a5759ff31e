#include "wellspaced/algorithms/audit/half_edges.hpp"

#include <algorithm>

#include "wellspaced/algorithms/audit/components.hpp"
#include "wellspaced/algorithms/audit/stars.hpp"
#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

using Triangles = std::span<const std::array<Index, 3>>;

// Half-edges and segments, listed by their lower node; an entry is (higher node, item), where item
// is a half-edge or, from 3 * triangles on, a segment.
class EdgeLists {
 public:
  // Those between two chosen nodes.
  EdgeLists(Triangles triangles, std::span<const Segment> segments,
            std::span<const std::uint8_t> chosen)
      : first_(chosen.size() + 1, 0) {
    for_each_edge(triangles, segments, chosen, [&](Index low, Index, Index) { ++first_[low]; });
    Index sum = 0;
    for (Index& first : first_) first = sum += first;
    entries_.resize(sum);
    for_each_edge(triangles, segments, chosen, [&](Index low, Index high, Index item) {
      entries_[--first_[low]] = std::uint64_t{high} << 32 | item;
    });
  }

  // Calls visit(entries of one edge), edge by edge. Entries are sorted by item.
  template <class Visit>
  void visit_edges(Visit visit) {
    for (std::size_t low = 0; low + 1 < first_.size(); ++low) {
      const std::span list(entries_.data() + first_[low], entries_.data() + first_[low + 1]);
      sort(list);
      for (std::size_t i = 0, end = 0; i < list.size(); i = end) {
        while (end < list.size() && list[end] >> 32 == list[i] >> 32) ++end;
        visit(std::span<const std::uint64_t>(list.subspan(i, end - i)));
      }
    }
  }

 private:
  template <class Visit>
  static void for_each_edge(Triangles triangles, std::span<const Segment> segments,
                            std::span<const std::uint8_t> chosen, Visit visit) {
    Index item = 0;
    const auto visit_sorted = [&](Index a, Index b) {
      if (chosen[a] != 0 && chosen[b] != 0) visit(std::min(a, b), std::max(a, b), item);
      ++item;
    };
    for (const auto& t : triangles)
      for (int i = 0; i < 3; ++i) visit_sorted(t[i], t[i == 2 ? 0 : i + 1]);
    for (const Segment& s : segments) visit_sorted(s.a, s.b);
  }

  std::vector<Index> first_;
  std::vector<std::uint64_t> entries_;
};

Index item_of(std::uint64_t entry) { return static_cast<Index>(entry); }

// Turns what lies on edges, edge by edge, into the result.
class Pairing {
 public:
  Pairing(Triangles triangles, std::span<const Segment> segments)
      : triangles_(triangles), segments_(segments) {
    assign_large(result_.twin, 3 * triangles.size(), kNoIndex);
    result_.constrained.assign(3 * triangles.size(), 0);
    result_.segment_edge.assign(segments.size(), kNoIndex);
    half_edges_ = static_cast<Index>(3 * triangles.size());
  }

  // All that lies on one edge: half-edges first, because their items are lower.
  void take_edge(std::span<const std::uint64_t> items) {
    const auto sides = take_segments_of(items);
    if (sides.empty()) return;
    ++result_.edges;
    if (sides.size() > 1) pair_up(sides);
  }

  // The same without the half-edges, which are returned.
  std::span<const std::uint64_t> take_segments_of(std::span<const std::uint64_t> items) {
    const auto is_half_edge = [&](std::uint64_t entry) { return item_of(entry) < half_edges_; };
    const auto split =
        std::partition_point(items.begin(), items.end(), is_half_edge) - items.begin();
    const auto sides = items.first(split), segments = items.subspan(split);
    if (!segments.empty()) take_segments(segments, sides);
    return sides;
  }

  // Pairs up the half-edges of a mesh that has no crowded or disagreeing edge and no triangle
  // twice; returns false if it has one.
  bool pair_opposites(Index nodes) {
    if (!find_opposites(nodes) || has_twofold_neighbor()) {
      result_.twin.assign(half_edges_, kNoIndex);
      return false;
    }
    const auto rims = std::count(result_.twin.begin(), result_.twin.end(), kNoIndex);
    result_.edges = (half_edges_ + static_cast<std::uint64_t>(rims)) / 2;
    return true;
  }

  HalfEdges take_result() {
    auto& duplicates = result_.duplicate_triangles;
    sort(result_.duplicate_segments);
    sort(result_.conflicting_segments);
    sort_unique(duplicates);
    return std::move(result_);
  }

 private:
  // Links the half-edges that enter each node to those that leave it. Returns false where two leave
  // it for the same node.
  bool find_opposites(Index nodes) {
    const Stars stars(triangles_, nodes);
    std::vector<std::uint64_t> last_to(nodes, ~std::uint64_t{0});  // (from, half-edge) to each node
    bool repeated = false;
    for (Index v = 0; v < nodes; ++v) {
      for (const Index h : stars.leaving(v)) {
        std::uint64_t& last = last_to[target(triangles_, h)];
        repeated |= last >> 32 == v;
        last = std::uint64_t{v} << 32 | h;
      }
      for (const Index h : stars.leaving(v)) {
        const std::uint64_t last = last_to[apex(triangles_, h)];
        result_.twin[HalfEdges::previous(h)] = last >> 32 == v ? item_of(last) : kNoIndex;
      }
    }
    return !repeated;
  }

  // Two triangles that share two edges have the same nodes.
  bool has_twofold_neighbor() const {
    bool found = false;
    for (Index h = 0; h < half_edges_; h += 3)
      found |= result_.twin[h] != kNoIndex && result_.twin[h] / 3 == result_.twin[h + 1] / 3;
    return found;
  }

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
    sort(apexes_);
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

// The number of triangles in the fan around the origin of h. Turning never merges two ways, so it
// ends, or comes back to h.
std::size_t fan_size(const HalfEdges& half_edges, Index h) {
  std::size_t size = 1;
  Index g = half_edges.turn_right(h);
  for (; g != kNoIndex && g != h; g = half_edges.turn_right(g)) ++size;
  if (g == h) return size;
  for (g = half_edges.turn_left(h); g != kNoIndex; g = half_edges.turn_left(g)) ++size;
  return size;
}

// Marks the half-edges of that fan.
void mark_fan(const HalfEdges& half_edges, Index h, std::vector<std::uint8_t>& marked) {
  for (Index g = h; g != kNoIndex && marked[g] == 0; g = half_edges.turn_right(g)) marked[g] = 1;
  for (Index g = half_edges.turn_left(h); g != kNoIndex && marked[g] == 0;
       g = half_edges.turn_left(g))
    marked[g] = 1;
}

// For each node one half-edge that leaves it, or kNoIndex.
std::vector<Index> some_leaving(Triangles triangles, std::size_t nodes) {
  std::vector<Index> leaving(nodes, kNoIndex);
  for (Index t = 0; t < triangles.size(); ++t)
    for (Index i = 0; i < 3; ++i) leaving[triangles[t][i]] = 3 * t + i;
  return leaving;
}

// Adds the fans that do not hold the half-edge listed for their node.
void count_further_fans(Triangles triangles, const HalfEdges& half_edges,
                        std::span<const Index> leaving, std::vector<std::uint8_t>& fans,
                        std::uint64_t& total) {
  std::vector<std::uint8_t> marked(half_edges.twin.size(), 0);
  for (const Index h : leaving)
    if (h != kNoIndex) mark_fan(half_edges, h, marked);
  for (Index h = 0; h < marked.size(); ++h) {
    if (marked[h] != 0) continue;
    mark_fan(half_edges, h, marked);
    std::uint8_t& count = fans[origin(triangles, h)];
    if (count < 255) ++count;
    ++total;
  }
}

// The nodes that segments end at, as a set of flags.
std::vector<std::uint8_t> ends_of(std::span<const Segment> segments, Index nodes) {
  std::vector<std::uint8_t> is_end(nodes, 0);
  for (const Segment& s : segments) is_end[s.a] = is_end[s.b] = 1;
  return is_end;
}

}  // namespace

HalfEdges pair_half_edges(Triangles triangles, std::span<const Segment> segments, Index nodes) {
  Pairing pairing(triangles, segments);
  if (!pairing.pair_opposites(nodes)) {
    EdgeLists(triangles, segments, std::vector<std::uint8_t>(nodes, 1)).visit_edges([&](auto edge) {
      pairing.take_edge(edge);
    });
  } else if (!segments.empty()) {
    EdgeLists(triangles, segments, ends_of(segments, nodes)).visit_edges([&](auto edge) {
      pairing.take_segments_of(edge);
    });
  }
  return pairing.take_result();
}

std::vector<std::uint8_t> count_fans(Triangles triangles, const HalfEdges& half_edges,
                                     std::size_t nodes, std::uint64_t& total) {
  std::vector<std::uint8_t> fans(nodes, 0);
  total = 0;
  std::size_t covered = 0;
  const std::vector<Index> leaving = some_leaving(triangles, nodes);
  for (std::size_t v = 0; v < nodes; ++v) {
    if (leaving[v] == kNoIndex) continue;
    covered += fan_size(half_edges, leaving[v]);
    fans[v] = 1;
    ++total;
  }
  if (covered < half_edges.twin.size())
    count_further_fans(triangles, half_edges, leaving, fans, total);
  return fans;
}

std::uint64_t count_components(const HalfEdges& half_edges) {
  return count_components<3>(half_edges.twin);
}

}  // namespace wellspaced::audit
