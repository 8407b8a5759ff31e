#include "wellspaced/kernel/plane/split_crossings.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>

#include "wellspaced/kernel/plane/crossing.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// What counts as a conflict: at first, whatever gives the result other vertices on a segment than
// the exact crossings have, and crossings on input points; then only what makes it invalid.
enum class Demand { kSameVertices, kValid };

// How often crossings in conflict are moved, each to its next rounding, before chance takes over;
// then there are as many attempts by chance, and more as long as they triangulate few points in
// all.
constexpr std::size_t kOrderlyAttempts = 25;
constexpr std::size_t kPointsByChance = std::size_t{1} << 12;

// A distinct crossing: two of the segments through it, and the doubles it may be rounded to; those
// that are no input point first.
struct Node {
  std::array<Index, 2> segment;
  std::vector<Point2> candidates;
  std::size_t free_candidates = 0;
  std::size_t choice = 0;
};

// Crossings in each other's way.
using Misfits = std::vector<Index>;

class Splitter {
 public:
  Splitter(std::span<const Point2> points, std::span<const Segment> segments,
           const SegmentNetwork& network)
      : points_(points), segments_(segments), network_(network) {}

  Result<SplitGraph> run();

 private:
  Crossing crossing(const SegmentCrossing& pair) const;
  void number_nodes();
  void chain_segments();
  Status find_candidates();
  std::vector<Point2> all_points() const;
  std::size_t choices(const Node& node) const;
  Result<SplitGraph> attempt(std::vector<Misfits>& conflicts) const;
  Index sharer(const Delaunay2& dt, Index node) const;
  Misfits nodes_at(const SplitGraph& split, std::span<const Index> vertices) const;
  void add_nodes_of_edge(const SplitGraph& split, Index c, Index d, Misfits& nodes) const;
  bool move_on(const std::vector<Misfits>& conflicts);
  void move_by_chance(const std::vector<Misfits>& conflicts);
  Result<SplitGraph> search_in_order(std::vector<Misfits>& conflicts);
  Result<SplitGraph> search_by_chance(std::vector<Misfits>& conflicts);
  Error refusal(Index node) const;

  std::span<const Point2> points_;
  std::span<const Segment> segments_;
  const SegmentNetwork& network_;
  std::vector<Index> node_of_;  // of each crossing pair
  std::vector<Node> nodes_;     // ascending by x, then y
  std::vector<std::vector<Index>> chains_;
  Demand demand_ = Demand::kSameVertices;
  Random random_{1};
};

Crossing Splitter::crossing(const SegmentCrossing& pair) const {
  const Segment s = segments_[pair.segment[0]], t = segments_[pair.segment[1]];
  return {points_[s.a], points_[s.b], points_[t.a], points_[t.b]};
}

// Numbers the distinct crossings in the order of their exact coordinates.
void Splitter::number_nodes() {
  const std::vector<SegmentCrossing>& pairs = network_.crossings;
  std::vector<Index> sorted(pairs.size());
  for (Index k = 0; k < sorted.size(); ++k) sorted[k] = k;
  std::sort(sorted.begin(), sorted.end(), [&](Index k, Index l) {
    const int order = compare_xy(crossing(pairs[k]), crossing(pairs[l]));
    return order != 0 ? order < 0 : k < l;
  });
  node_of_.resize(pairs.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const SegmentCrossing& pair = pairs[sorted[i]];
    if (i == 0 || compare_xy(crossing(pairs[sorted[i - 1]]), crossing(pair)) != 0)
      nodes_.push_back({pair.segment, {}});
    node_of_[sorted[i]] = static_cast<Index>(nodes_.size()) - 1;
  }
}

// Strings the vertices and crossings on each segment. The crossings of one piece come in the order
// of their coordinates, which is their order along the segment or its reverse.
void Splitter::chain_segments() {
  using Stop = std::pair<Index, Index>;  // the piece, the node
  std::vector<std::vector<Stop>> stops(segments_.size());
  for (std::size_t k = 0; k < node_of_.size(); ++k)
    for (const int side : {0, 1})
      stops[network_.crossings[k].segment[side]].emplace_back(network_.crossings[k].piece[side],
                                                              node_of_[k]);
  const Index first_node = static_cast<Index>(points_.size());
  chains_ = network_.paths;
  for (std::size_t s = 0; s < stops.size(); ++s) {
    if (stops[s].empty()) continue;
    const Point2 a = points_[segments_[s].a], b = points_[segments_[s].b];
    const bool ascending = a.x < b.x || (a.x == b.x && a.y < b.y);
    std::sort(stops[s].begin(), stops[s].end(), [&](const Stop& i, const Stop& j) {
      if (i.first != j.first) return i.first < j.first;
      return ascending ? i.second < j.second : j.second < i.second;
    });
    stops[s].erase(std::unique(stops[s].begin(), stops[s].end()), stops[s].end());
    std::vector<Index> chain;
    auto stop = stops[s].begin();
    for (Index piece = 0; piece < network_.paths[s].size(); ++piece) {
      chain.push_back(network_.paths[s][piece]);
      for (; stop != stops[s].end() && stop->first == piece; ++stop)
        chain.push_back(first_node + stop->second);
    }
    chains_[s] = std::move(chain);
  }
}

// Gives the node the roundings of its crossing that lie within the hull.
void set_candidates(Node& node, const Crossing& crossing, const Delaunay2& bare) {
  const RoundedCrossing rounded = round_crossing(crossing);
  std::vector<Point2> taken;
  Index hint = 0;
  for (int i = 0; i < (rounded.exact ? 1 : rounded.count); ++i) {
    const Delaunay2::Location found = bare.locate(rounded.points[i], hint);
    hint = found.edge.triangle;
    if (found.place == Delaunay2::Place::kOutside) continue;
    (found.place == Delaunay2::Place::kVertex ? taken : node.candidates)
        .push_back(rounded.points[i]);
  }
  node.free_candidates = node.candidates.size();
  node.candidates.insert(node.candidates.end(), taken.begin(), taken.end());
}

Status Splitter::find_candidates() {
  const Result<Delaunay2> bare = Delaunay2::build(points_);
  if (!bare) return bare.error();
  for (std::size_t k = 0; k < node_of_.size(); ++k) {
    Node& node = nodes_[node_of_[k]];
    if (!node.candidates.empty()) continue;
    set_candidates(node, crossing(network_.crossings[k]), *bare);
    if (node.candidates.empty()) return refusal(node_of_[k]);
  }
  return Ok{};
}

Error Splitter::refusal(Index node) const {
  const auto [s, t] = nodes_[node].segment;
  const char* reason =
      nodes_[node].candidates.empty()
          ? " cross where all doubles within 2 units in the last place lie outside the points' hull"
          : " cross where no doubles within 2 units in the last place were found that keep the "
            "segments around in order";
  return {ErrorCode::kInvalidGeometry,
          "segments " + std::to_string(s) + " and " + std::to_string(t) + reason +
              "; scale the input up to whole numbers, or move one of them",
          {s, t}};
}

std::vector<Point2> Splitter::all_points() const {
  std::vector<Point2> all(points_.begin(), points_.end());
  for (const Node& node : nodes_) all.push_back(node.candidates[node.choice]);
  return all;
}

// How many of its roundings a crossing may have now.
std::size_t Splitter::choices(const Node& node) const {
  const bool any = demand_ == Demand::kValid || node.free_candidates == 0;
  return any ? node.candidates.size() : node.free_candidates;
}

// An earlier crossing that has been rounded to the same point, or kNoIndex.
Index Splitter::sharer(const Delaunay2& dt, Index node) const {
  const Index first_node = static_cast<Index>(points_.size());
  const Index vertex = dt.representative(first_node + node);
  return vertex == first_node + node || vertex < first_node ? kNoIndex : vertex - first_node;
}

// Triangulates with the present choices. Fails with what has to move in `conflicts`.
Result<SplitGraph> Splitter::attempt(std::vector<Misfits>& conflicts) const {
  conflicts.clear();
  Result<Delaunay2> built = Delaunay2::build(all_points());
  if (!built) return built.error();
  SplitGraph split{std::move(*built), {}};
  for (Index node = 0; node < nodes_.size(); ++node)
    if (const Index other = sharer(split.delaunay, node); other != kNoIndex)
      conflicts.push_back({other, node});
  for (const std::vector<Index>& chain : chains_) {
    split.chains.emplace_back(chain.begin(), chain.begin() + 1);
    std::vector<Index>& refined = split.chains.back();
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Result<std::vector<Index>> path =
          split.delaunay.insert_constraint(chain[i], chain[i + 1]);
      if (!path) {
        conflicts.push_back(nodes_at(split, path.error().ids));
        continue;
      }
      if (path->size() > 2 && demand_ == Demand::kSameVertices)
        conflicts.push_back(nodes_at(split, *path));
      refined.insert(refined.end(), path->begin() + 1, path->end());
    }
  }
  if (conflicts.empty()) return split;
  return refusal(conflicts.front().front());
}

// The crossings among vertices in each other's way, perhaps on an input point; or else those of the
// segment that was bent until it ran between input points, through the last two: between segments
// that are not bent all is exact.
Misfits Splitter::nodes_at(const SplitGraph& split, std::span<const Index> vertices) const {
  const Index first_node = static_cast<Index>(points_.size());
  Misfits nodes;
  for (const Index v : vertices)
    if (v >= first_node) nodes.push_back(v - first_node);
  for (Index node = 0; nodes.empty() && node < nodes_.size(); ++node)
    for (const Index v : vertices)
      if (split.delaunay.representative(first_node + node) == v) nodes.push_back(node);
  if (nodes.empty()) add_nodes_of_edge(split, vertices.end()[-2], vertices.back(), nodes);
  assert(!nodes.empty());
  return nodes;
}

// Adds the crossings on the segments that have the edge from c to d.
void Splitter::add_nodes_of_edge(const SplitGraph& split, Index c, Index d, Misfits& nodes) const {
  const Index first_node = static_cast<Index>(points_.size());
  const auto is_edge = [&](Index u, Index v) { return (u == c && v == d) || (u == d && v == c); };
  for (std::size_t s = 0; s < split.chains.size(); ++s) {
    const std::vector<Index>& refined = split.chains[s];
    if (std::adjacent_find(refined.begin(), refined.end(), is_edge) == refined.end()) continue;
    for (const Index v : chains_[s])
      if (v >= first_node) nodes.push_back(v - first_node);
  }
}

// Of each conflict, moves the crossing that was moved least so far to its next rounding, from the
// last back to the first. Returns false if none has another.
bool Splitter::move_on(const std::vector<Misfits>& conflicts) {
  std::vector<Index> blamed;
  for (const Misfits& nodes : conflicts)
    blamed.push_back(*std::min_element(nodes.begin(), nodes.end(), [&](Index k, Index l) {
      return nodes_[k].choice < nodes_[l].choice;
    }));
  std::sort(blamed.begin(), blamed.end());  // so that none moves twice
  blamed.erase(std::unique(blamed.begin(), blamed.end()), blamed.end());
  bool moved = false;
  for (const Index k : blamed) {
    Node& node = nodes_[k];
    node.choice = (node.choice + 1) % choices(node);
    moved |= choices(node) > 1;
  }
  return moved;
}

Result<SplitGraph> Splitter::search_in_order(std::vector<Misfits>& conflicts) {
  Result<SplitGraph> split = attempt(conflicts);
  for (std::size_t k = 1; k < kOrderlyAttempts && !conflicts.empty() && move_on(conflicts); ++k)
    split = attempt(conflicts);
  return split;
}

void Splitter::move_by_chance(const std::vector<Misfits>& conflicts) {
  for (const Misfits& nodes : conflicts) {
    if (random_.below(2) == 0) continue;
    Node& node = nodes_[nodes[random_.below(nodes.size())]];
    node.choice = random_.below(choices(node));
  }
}

// From the present choices to ones with as few conflicts or fewer, and so on.
Result<SplitGraph> Splitter::search_by_chance(std::vector<Misfits>& conflicts) {
  Result<SplitGraph> split = attempt(conflicts);
  const std::size_t points = points_.size() + nodes_.size();
  const std::size_t attempts = kOrderlyAttempts + kPointsByChance / points;
  for (std::size_t k = 0; k < attempts && !conflicts.empty(); ++k) {
    const std::vector<Node> before = nodes_;
    std::vector<Misfits> left;
    move_by_chance(conflicts);
    split = attempt(left);
    if (left.size() <= conflicts.size())
      conflicts = std::move(left);
    else
      nodes_ = before;
  }
  return split;
}

Result<SplitGraph> Splitter::run() {
  number_nodes();
  chain_segments();
  if (Status status = find_candidates(); !status) return status.error();
  std::vector<Misfits> conflicts;
  for (const Demand demand : {Demand::kSameVertices, Demand::kValid}) {
    demand_ = demand;
    Result<SplitGraph> split = search_in_order(conflicts);
    if (!conflicts.empty()) split = search_by_chance(conflicts);
    if (conflicts.empty() || demand == Demand::kValid) return split;
  }
  return refusal(0);  // not reached
}

}  // namespace

Result<SplitGraph> split_at_crossings(std::span<const Point2> points,
                                      std::span<const Segment> segments,
                                      const SegmentNetwork& network) {
  return Splitter(points, segments, network).run();
}

}  // namespace wellspaced
