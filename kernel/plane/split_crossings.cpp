#include "wellspaced/kernel/plane/split_crossings.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "wellspaced/kernel/plane/crossing.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// How often crossings in conflict are moved, each to its next rounding, before chance takes over;
// then there are as many attempts by chance, and more as long as they triangulate few points in
// all.
constexpr std::size_t kOrderlyAttempts = 25;
constexpr std::size_t kPointsByChance = std::size_t{1} << 12;

constexpr std::uint64_t kSplitStepsAQuestion = 256;

// A distinct crossing: two of the segments through it, and the doubles it may be rounded to; those
// that are no input point first. `nearest` and `choice` number candidates.
struct Node {
  std::array<Index, 2> segment;
  std::vector<Point2> candidates;
  std::size_t free_candidates = 0;
  std::size_t nearest = 0;
  std::size_t choice = 0;

  // How many candidates it may be moved to: it stays off the input points where it can.
  std::size_t choices() const { return free_candidates == 0 ? candidates.size() : free_candidates; }
};

// Crossings in each other's way.
using Misfits = std::vector<Index>;

class Splitter {
 public:
  Splitter(std::span<const Point2> points, std::span<const Segment> segments,
           const SegmentNetwork& network, const Progress& progress)
      : points_(points),
        segments_(segments),
        network_(network),
        progress_(progress),
        meter_(progress, "split", 0, kSplitStepsAQuestion) {}

  Result<SplitGraph> run();

 private:
  Crossing crossing(const SegmentCrossing& pair) const;
  void number_nodes();
  void chain_segments();
  Status find_candidates();
  std::vector<Point2> all_points() const;
  Result<Delaunay2> triangulation_of(std::span<const Point2> points);
  Result<SplitGraph> attempt(std::vector<Misfits>& conflicts);
  Index sharer(const Delaunay2& dt, Index node) const;
  Misfits nodes_at(const SplitGraph& split, std::span<const Index> vertices) const;
  void add_nodes_of_edge(const SplitGraph& split, Index c, Index d, Misfits& nodes) const;
  bool move_on(const std::vector<Misfits>& conflicts);
  void move_by_chance(const std::vector<Misfits>& conflicts);
  Result<SplitGraph> search_in_order(std::vector<Misfits>& conflicts);
  Result<SplitGraph> search_by_chance(std::vector<Misfits>& conflicts);
  Result<SplitGraph> snap();

  std::span<const Point2> points_;
  std::span<const Segment> segments_;
  const SegmentNetwork& network_;
  const Progress& progress_;
  ProgressMeter meter_;
  std::vector<Index> node_of_;  // of each crossing pair
  std::vector<Node> nodes_;     // ascending by x, then y
  std::vector<std::vector<Index>> chains_;
  Random random_{1};
};

Crossing Splitter::crossing(const SegmentCrossing& pair) const {
  const Segment s = segments_[pair.segment[0]], t = segments_[pair.segment[1]];
  return {points_[s.a], points_[s.b], points_[t.a], points_[t.b]};
}

// Numbers the distinct crossings in the order of their exact coordinates. Once the caller wants to
// stop, comparing them ends, and with it soon the sorting.
void Splitter::number_nodes() {
  const std::vector<SegmentCrossing>& pairs = network_.crossings;
  std::vector<Index> sorted(pairs.size());
  for (Index k = 0; k < sorted.size(); ++k) sorted[k] = k;
  sort(sorted, [&](Index k, Index l) {
    if (!meter_.step()) return false;
    const int order = compare_xy(crossing(pairs[k]), crossing(pairs[l]));
    return order != 0 ? order < 0 : k < l;
  });
  node_of_.resize(pairs.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (!meter_.step()) return;
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
    sort(stops[s], [&](const Stop& i, const Stop& j) {
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

// Gives the node the roundings of its crossing that lie within the hull; all if none does.
void set_candidates(Node& node, const Crossing& crossing, const Delaunay2& bare) {
  const RoundedCrossing rounded = round_crossing(crossing);
  const std::span<const Point2> all(rounded.points.data(), rounded.exact ? 1 : rounded.count);
  std::vector<Point2> taken;
  bool nearest_is_taken = false;
  Index hint = 0;
  for (const Point2 p : all) {
    const Delaunay2::Location found = bare.locate(p, hint);
    hint = found.edge.triangle;
    if (found.place == Delaunay2::Place::kOutside) continue;
    const bool is_taken = found.place == Delaunay2::Place::kVertex;
    if (node.candidates.empty() && taken.empty()) nearest_is_taken = is_taken;
    (is_taken ? taken : node.candidates).push_back(p);
  }
  node.free_candidates = node.candidates.size();
  node.nearest = nearest_is_taken ? node.free_candidates : 0;
  node.candidates.insert(node.candidates.end(), taken.begin(), taken.end());
  if (node.candidates.empty()) node.candidates.assign(all.begin(), all.end());
}

// Its questions are this one's.
Result<Delaunay2> Splitter::triangulation_of(std::span<const Point2> points) {
  return Delaunay2::build(points,
                          {[this](auto, auto, auto) { return meter_.step(kSplitStepsAQuestion); }});
}

Status Splitter::find_candidates() {
  const Result<Delaunay2> bare = triangulation_of(points_);
  if (!bare) return bare.error();
  for (std::size_t k = 0; k < node_of_.size(); ++k) {
    if (!meter_.step()) return cancelled();
    Node& node = nodes_[node_of_[k]];
    if (node.candidates.empty()) set_candidates(node, crossing(network_.crossings[k]), *bare);
  }
  return Ok{};
}

std::vector<Point2> Splitter::all_points() const {
  std::vector<Point2> all(points_.begin(), points_.end());
  for (const Node& node : nodes_) all.push_back(node.candidates[node.choice]);
  return all;
}

// An earlier crossing that has been rounded to the same point, or kNoIndex.
Index Splitter::sharer(const Delaunay2& dt, Index node) const {
  const Index first_node = static_cast<Index>(points_.size());
  const Index vertex = dt.representative(first_node + node);
  return vertex == first_node + node || vertex < first_node ? kNoIndex : vertex - first_node;
}

// Triangulates with the present choices. What would have to move is in `conflicts`: nothing where
// it fails.
Result<SplitGraph> Splitter::attempt(std::vector<Misfits>& conflicts) {
  conflicts.clear();
  Result<Delaunay2> built = triangulation_of(all_points());
  if (!built) return built.error();
  SplitGraph split{std::move(*built), {}};
  for (Index node = 0; node < nodes_.size(); ++node)
    if (const Index other = sharer(split.delaunay, node); other != kNoIndex)
      conflicts.push_back({other, node});
  for (const std::vector<Index>& chain : chains_) {
    auto& edges = split.edges.emplace_back();
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (!meter_.step()) return conflicts.clear(), cancelled();
      const Result<std::vector<Index>> path =
          split.delaunay.insert_constraint(chain[i], chain[i + 1]);
      if (!path) {
        conflicts.push_back(nodes_at(split, path.error().ids));
        continue;
      }
      if (path->size() > 2) conflicts.push_back(nodes_at(split, *path));
      for (std::size_t k = 0; k + 1 < path->size(); ++k)
        edges.push_back({(*path)[k], (*path)[k + 1]});
    }
  }
  return split;
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
  const auto is_edge = [&](std::array<Index, 2> e) {
    return (e[0] == c && e[1] == d) || (e[0] == d && e[1] == c);
  };
  for (std::size_t s = 0; s < split.edges.size(); ++s) {
    if (none_of(split.edges[s], is_edge)) continue;
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
  sort(blamed);  // so that none moves twice
  blamed.erase(std::unique(blamed.begin(), blamed.end()), blamed.end());
  bool moved = false;
  for (const Index k : blamed) {
    Node& node = nodes_[k];
    node.choice = (node.choice + 1) % node.choices();
    moved |= node.choices() > 1;
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
    node.choice = random_.below(node.choices());
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

// All crossings where they round to, equal ones merged, and the segments bent where that brought
// them across each other.
Result<SplitGraph> Splitter::snap() {
  for (Node& node : nodes_) node.choice = node.nearest;
  Result<Delaunay2> built = triangulation_of(all_points());
  if (!built) return built.error();
  Result<SegmentEdges> edges = bend_chains(*built, segments_, chains_, progress_);
  if (!edges) return edges.error();
  return SplitGraph{std::move(*built), std::move(*edges)};
}

Result<SplitGraph> Splitter::run() {
  number_nodes();
  if (meter_.stopped()) return cancelled();
  chain_segments();
  if (Status status = find_candidates(); !status) return status.error();
  std::vector<Misfits> conflicts;
  Result<SplitGraph> split = search_in_order(conflicts);
  if (!conflicts.empty()) split = search_by_chance(conflicts);
  return conflicts.empty() ? std::move(split) : snap();
}

}  // namespace

Result<SplitGraph> split_at_crossings(std::span<const Point2> points,
                                      std::span<const Segment> segments,
                                      const SegmentNetwork& network, const Progress& progress) {
  return Splitter(points, segments, network, progress).run();
}

}  // namespace wellspaced
