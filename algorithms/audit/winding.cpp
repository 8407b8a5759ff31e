#include "wellspaced/algorithms/audit/winding.hpp"

#include <algorithm>
#include <set>

#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// A chain edge seen along the sweep: from its first point to its last.
struct SweepEdge {
  Point2 first, last;
  int jump = 0;           // the winding number above it less that below it
  Index next = kNoIndex;  // the next edge of its bundle
};

SweepEdge edge_along_sweep(const ChainEdge& e) {
  return before(e.from, e.to) ? SweepEdge{e.from, e.to, 1} : SweepEdge{e.to, e.from, -1};
}

// Edges that coincide from `first` at least as far as `last`.
struct Bundle {
  Point2 first, last;
  Index head = kNoIndex;
  int above = 0;
};

// The order along the sweep line of bundles that it meets at the same time; a point is equivalent
// to the bundles that it lies on.
struct Below {
  using is_transparent = void;
  bool operator()(const Bundle& b, Point2 p) const { return orient2d(b.first, b.last, p) > 0; }
  bool operator()(Point2 p, const Bundle& b) const { return orient2d(b.first, b.last, p) < 0; }
  bool operator()(const Bundle& a, const Bundle& b) const { return side(a, b) > 0; }

 private:
  // On which side of a does b lie? Both start at or before the sweep line.
  static int side(const Bundle& a, const Bundle& b) {
    if (before(b.first, a.first)) return -side_of_later(b, a);
    return side_of_later(a, b);
  }
  static int side_of_later(const Bundle& a, const Bundle& later) {
    const int sign = orient2d(a.first, a.last, later.first);
    return sign != 0 ? sign : orient2d(a.first, a.last, later.last);
  }
};

struct Event {
  Point2 point;
  Index node = 0;
};

// The end points of all edges, each point once.
std::vector<Event> events_of(std::span<const ChainEdge> chain) {
  std::vector<Event> events;
  events.reserve(2 * chain.size());
  for (const ChainEdge& e : chain) {
    events.push_back({e.from, e.from_node});
    events.push_back({e.to, e.to_node});
  }
  sort(events, [](const Event& a, const Event& b) {
    return before(a.point, b.point) || (a.point == b.point && a.node < b.node);
  });
  const auto same = [](const Event& a, const Event& b) { return a.point == b.point; };
  events.erase(std::unique(events.begin(), events.end(), same), events.end());
  return events;
}

class Sweep {
 public:
  explicit Sweep(std::span<const ChainEdge> chain) : events_(events_of(chain)) {
    for (const ChainEdge& e : chain) edges_.push_back(edge_along_sweep(e));
    sort(edges_, [](const SweepEdge& a, const SweepEdge& b) { return before(a.first, b.first); });
  }

  WindingVerdict run() {
    for (const Event& event : events_) {
      pass(event);
      if (!verdict_.at_most_once) break;
    }
    return std::move(verdict_);
  }

 private:
  using Status = std::set<Bundle, Below>;

  // Moves the sweep line over a point: what ends there leaves, what starts or goes on enters.
  void pass(const Event& event) {
    outgoing_.clear();
    const auto [low, high] = status_.equal_range(event.point);
    int winding = low == status_.begin() ? 0 : std::prev(low)->above;
    for (auto bundle = low; bundle != high; ++bundle) collect_continuing(*bundle, event);
    status_.erase(low, high);
    for (; next_ < edges_.size() && edges_[next_].first == event.point; ++next_)
      outgoing_.push_back(next_);
    if (outgoing_.empty()) return check_below(high);
    sort_outgoing(event.point);
    insert_outgoing(event.point, high, winding);
    check_below(high);
  }

  void collect_continuing(const Bundle& bundle, const Event& event) {
    for (Index e = bundle.head; e != kNoIndex; e = edges_[e].next) {
      if (edges_[e].last == event.point) continue;
      outgoing_.push_back(e);
      note_hanging(event.node);
    }
  }

  void note_hanging(Index node) {
    auto& nodes = verdict_.hanging_nodes;
    if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
  }

  // From below to above; coincident edges by their length, the shortest first.
  void sort_outgoing(Point2 p) {
    sort(outgoing_, [&](Index i, Index j) {
      const Point2 a = edges_[i].last, b = edges_[j].last;
      const int sign = orient2d(p, a, b);
      if (sign != 0) return sign > 0;
      return a == b ? i < j : before(a, b);
    });
  }

  void insert_outgoing(Point2 p, Status::iterator position, int winding) {
    auto lowest = status_.end();
    for (std::size_t i = 0, end = 0; i < outgoing_.size(); i = end) {
      Bundle bundle{p, edges_[outgoing_[i]].last, kNoIndex, winding};
      for (; end < outgoing_.size() && orient2d(p, bundle.last, edges_[outgoing_[end]].last) == 0;
           ++end)
        add_to(bundle, outgoing_[end]);
      winding = bundle.above;
      if (winding > 1) verdict_.at_most_once = false;
      const auto inserted = status_.insert(position, bundle);
      if (i == 0) lowest = inserted;
    }
    check_below(lowest);
  }

  void add_to(Bundle& bundle, Index e) {
    edges_[e].next = bundle.head;
    bundle.head = e;
    bundle.above += edges_[e].jump;
  }

  // Tests whether the bundle at `position` and the one below it cross properly further on.
  void check_below(Status::iterator position) {
    if (position == status_.begin() || position == status_.end()) return;
    if (cross(*std::prev(position), *position)) verdict_.at_most_once = false;
  }

  static bool cross(const Bundle& low, const Bundle& high) {
    if (before(low.last, high.last)) return orient2d(high.first, high.last, low.last) > 0;
    return orient2d(low.first, low.last, high.last) < 0;
  }

  std::vector<Event> events_;
  std::vector<SweepEdge> edges_;
  std::size_t next_ = 0;  // the first edge that has not started
  std::vector<Index> outgoing_;
  Status status_;
  WindingVerdict verdict_;
};

}  // namespace

WindingVerdict cover_at_most_once(std::span<const ChainEdge> chain) { return Sweep(chain).run(); }

}  // namespace wellspaced::audit
