#include "wellspaced/kernel/split_crossings.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>

#include "wellspaced/kernel/crossing.hpp"

namespace wellspaced {
namespace {

// For some attempts the result must have the very vertices on each segment that the exact crossings
// have; then it will do if it is valid.
constexpr int kStrictAttempts = 25;
constexpr int kMaxAttempts = 75;

// A distinct crossing: two of the segments through it, and the doubles it may be rounded to.
struct Node {
  std::array<Index, 2> segment;
  std::vector<Point2> candidates;
  std::size_t choice = 0;
};

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
  Result<SplitGraph> attempt(std::vector<Index>& conflicts) const;
  bool shares_its_point(const Delaunay2& dt, Index node) const;
  Index blame(const Delaunay2& dt, std::span<const Index> vertices) const;
  bool move_on(const std::vector<Index>& conflicts);
  Error refusal(Index node) const;

  std::span<const Point2> points_;
  std::span<const Segment> segments_;
  const SegmentNetwork& network_;
  std::vector<Index> node_of_;  // of each crossing pair
  std::vector<Node> nodes_;     // ascending by x, then y
  std::vector<std::vector<Index>> chains_;
  bool strict_ = true;  // whether pieces may not run through other vertices
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

// The roundings of a crossing that lie within the hull, those on an input point last.
std::vector<Point2> candidates(const Crossing& crossing, const Delaunay2& bare) {
  const RoundedCrossing rounded = round_crossing(crossing);
  std::vector<Point2> free, taken;
  Index hint = 0;
  for (int i = 0; i < (rounded.exact ? 1 : rounded.count); ++i) {
    const Delaunay2::Location found = bare.locate(rounded.points[i], hint);
    hint = found.edge.triangle;
    if (found.place == Delaunay2::Place::kOutside) continue;
    (found.place == Delaunay2::Place::kVertex ? taken : free).push_back(rounded.points[i]);
  }
  free.insert(free.end(), taken.begin(), taken.end());
  return free;
}

Status Splitter::find_candidates() {
  const Result<Delaunay2> bare = Delaunay2::build(points_);
  if (!bare) return bare.error();
  for (std::size_t k = 0; k < node_of_.size(); ++k) {
    Node& node = nodes_[node_of_[k]];
    if (!node.candidates.empty()) continue;
    node.candidates = candidates(crossing(network_.crossings[k]), *bare);
    if (node.candidates.empty()) return refusal(node_of_[k]);
  }
  return Ok{};
}

Error Splitter::refusal(Index node) const {
  const auto [s, t] = nodes_[node].segment;
  return {ErrorCode::kInvalidGeometry,
          "segments " + std::to_string(s) + " and " + std::to_string(t) +
              " cross where no doubles within 2 units in the last place keep the segments around "
              "in order; scale the input up to whole numbers, or move one of them",
          {s, t}};
}

std::vector<Point2> Splitter::all_points() const {
  std::vector<Point2> all(points_.begin(), points_.end());
  for (const Node& node : nodes_) all.push_back(node.candidates[node.choice]);
  return all;
}

// Whether an earlier crossing has been rounded to the same point.
bool Splitter::shares_its_point(const Delaunay2& dt, Index node) const {
  const Index point = static_cast<Index>(points_.size()) + node;
  const Index vertex = dt.representative(point);
  return vertex != point && vertex >= points_.size();
}

// Triangulates with the present choices. Fails with the crossings to move in `conflicts`.
Result<SplitGraph> Splitter::attempt(std::vector<Index>& conflicts) const {
  Result<Delaunay2> built = Delaunay2::build(all_points());
  if (!built) return built.error();
  SplitGraph split{std::move(*built), {}};
  for (Index node = 0; node < nodes_.size(); ++node)
    if (shares_its_point(split.delaunay, node)) conflicts.push_back(node);
  for (const std::vector<Index>& chain : chains_) {
    std::vector<Index> refined(chain.begin(), chain.begin() + 1);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Result<std::vector<Index>> path =
          split.delaunay.insert_constraint(chain[i], chain[i + 1]);
      if (!path) {
        conflicts.push_back(blame(split.delaunay, path.error().ids));
        continue;
      }
      if (path->size() > 2 && strict_) conflicts.push_back(blame(split.delaunay, *path));
      refined.insert(refined.end(), path->begin() + 1, path->end());
    }
    split.chains.push_back(std::move(refined));
  }
  if (conflicts.empty()) return split;
  return refusal(conflicts.front());
}

// Of the crossings among vertices in each other's way, the one moved least so far. There is one,
// perhaps on an input point: between input points all is exact.
Index Splitter::blame(const Delaunay2& dt, std::span<const Index> vertices) const {
  Index blamed = kNoIndex;
  const auto consider = [&](Index node) {
    if (blamed == kNoIndex || nodes_[node].choice < nodes_[blamed].choice) blamed = node;
  };
  const Index first_node = static_cast<Index>(points_.size());
  for (const Index v : vertices)
    if (v >= first_node) consider(v - first_node);
  for (Index node = 0; blamed == kNoIndex && node < nodes_.size(); ++node)
    for (const Index v : vertices)
      if (dt.representative(first_node + node) == v) consider(node);
  assert(blamed != kNoIndex);
  return blamed;
}

// Moves each crossing to its next candidate, from the last back to the first. Returns false if none
// has another.
bool Splitter::move_on(const std::vector<Index>& conflicts) {
  bool moved = false;
  for (const Index k : conflicts) {
    Node& node = nodes_[k];
    node.choice = (node.choice + 1) % node.candidates.size();
    moved |= node.candidates.size() > 1;
  }
  return moved;
}

Result<SplitGraph> Splitter::run() {
  number_nodes();
  chain_segments();
  if (Status status = find_candidates(); !status) return status.error();
  for (int k = 1;; ++k) {
    std::vector<Index> conflicts;
    strict_ = k <= kStrictAttempts;
    Result<SplitGraph> split = attempt(conflicts);
    if (split || conflicts.empty() || k == kMaxAttempts) return split;
    std::sort(conflicts.begin(), conflicts.end());  // so that none moves twice
    conflicts.erase(std::unique(conflicts.begin(), conflicts.end()), conflicts.end());
    if (!move_on(conflicts)) return split;
  }
}

}  // namespace

Result<SplitGraph> split_at_crossings(std::span<const Point2> points,
                                      std::span<const Segment> segments,
                                      const SegmentNetwork& network) {
  return Splitter(points, segments, network).run();
}

}  // namespace wellspaced
