// Another implementation of CHOICES.md, to compare node sets with: plain, by brute force, and
// without a line of the library but its exact predicates. No slits, no inner segments, and simple
// boundary curves only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::test {

struct SlowOptions {
  bool mis = false;
  double beta = 25, factor = 8, protect = 0.2;
  std::uint64_t seed = 1;
};

class SlowCoarsening {
 public:
  using NodeSet = std::vector<Index>;

  SlowCoarsening(const TriangleMesh& mesh, const NodeSet& fixed, const SlowOptions& options)
      : options_(options), points_(mesh.points), fixed_(fixed.begin(), fixed.end()) {
    for (Index v = 0; v < points_.size(); ++v) nodes_.push_back(v);
    triangles_ = mesh.triangles;
    find_edges();
    for (const Index v : nodes_) {
      double shortest = kFar;
      for (const Index w : neighbors_[v]) shortest = std::min(shortest, length(v, w));
      spacing_[v] = 0.5 * shortest;
    }
  }

  /// The node sets of levels 1, 2, ..., in numbers of the input mesh.
  std::vector<NodeSet> levels() {
    std::vector<NodeSet> sets;
    for (level_ = 1;; ++level_) {
      const NodeSet chosen = choose_nodes();
      if (chosen.size() == nodes_.size()) return sets;
      sets.push_back(chosen);
      nodes_ = chosen;
      triangulate();
      find_edges();
    }
  }

 private:
  using Edge = std::array<Index, 2>;
  static constexpr double kFar = 1e300;

  double length(Index a, Index b) const {
    const double dx = points_[a].x - points_[b].x, dy = points_[a].y - points_[b].y;
    return std::sqrt(dx * dx + dy * dy);
  }
  int turn(Index a, Index b, Index c) const { return orient2d(points_[a], points_[b], points_[c]); }

  // ---- The mesh: neighbours and the boundary edges, domain on the left
  void find_edges() {
    std::set<Edge> directed;
    for (const auto& [a, b, c] : triangles_) directed.insert({{a, b}, {b, c}, {c, a}});
    neighbors_.clear();
    boundary_.clear();
    for (const auto& [a, b] : directed) {
      neighbors_[a].insert(b);
      neighbors_[b].insert(a);
      if (!directed.contains({b, a})) boundary_[a] = b;
    }
  }

  // ---- The spacing function and the conflicts
  void coarsen_spacing() {
    const double factor = level_ == 1 ? options_.factor * options_.beta : options_.factor;
    std::map<Index, double> f;
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const Index v : nodes_) queue.push({f[v] = factor * spacing_[v], v});
    while (!queue.empty()) {
      const auto [value, v] = queue.top();
      queue.pop();
      if (value > f[v]) continue;
      for (const Index w : neighbors_[v])
        if (value + length(v, w) < f[w]) queue.push({f[w] = value + length(v, w), w});
    }
    spacing_ = f;
  }

  std::map<Index, double> distances_within(Index source, double radius) {
    std::map<Index, double> settled;
    std::set<std::pair<double, Index>> queue{{0, source}};
    while (!queue.empty() && queue.begin()->first <= radius) {
      const auto [d, v] = *queue.begin();
      queue.erase(queue.begin());
      if (!settled.insert({v, d}).second) continue;
      for (const Index w : neighbors_[v])
        if (!settled.contains(w)) queue.insert({d + length(v, w), w});
    }
    return settled;
  }

  std::vector<Index> conflicts(Index v) {
    std::vector<Index> list;
    if (options_.mis) return {neighbors_[v].begin(), neighbors_[v].end()};
    for (const auto& [w, d] : distances_within(v, 3 * spacing_[v] / options_.beta))
      if (w != v && spacing_[v] + spacing_[w] > options_.beta * d) list.push_back(w);
    return list;
  }

  // ---- The choice
  static std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  std::vector<Index> in_order(const std::vector<Index>& nodes) const {
    std::vector<std::pair<std::uint64_t, Index>> keyed;
    for (const Index v : nodes)
      keyed.push_back({mix(mix(options_.seed) ^ mix((std::uint64_t{level_} << 32) + v)), v});
    std::sort(keyed.begin(), keyed.end());
    std::vector<Index> ordered;
    for (const auto& [key, v] : keyed) ordered.push_back(v);
    return ordered;
  }

  void take(Index v, const std::vector<Index>& in_conflict) {
    selected_.insert(v);
    for (const Index w : in_conflict)
      if (!selected_.contains(w)) invalid_.insert(w);
  }
  void consider(Index v) {
    if (selected_.contains(v) || invalid_.contains(v)) return;
    const auto in_conflict = conflicts(v);
    for (const Index w : in_conflict)
      if (selected_.contains(w)) return;
    take(v, in_conflict);
  }

  NodeSet choose_nodes() {
    if (!options_.mis) coarsen_spacing();
    selected_ = fixed_;
    invalid_.clear();
    for (const Index v : fixed_) take(v, conflicts(v));
    std::vector<Index> on_boundary, interior;
    for (const Index v : nodes_) (boundary_.contains(v) ? on_boundary : interior).push_back(v);
    for (const Index v : in_order(on_boundary)) consider(v);
    contract();
    for (const Index v : interior)
      if (!selected_.contains(v) && (!is_inside(v) || is_too_close(v))) invalid_.insert(v);
    for (const Index v : in_order(interior)) consider(v);
    return {selected_.begin(), selected_.end()};
  }

  // ---- The boundary
  struct Chain {
    std::vector<Index> nodes;  // from survivor to survivor
    Index a() const { return nodes.front(); }
    Index b() const { return nodes.back(); }
  };

  void contract() {
    for (;;) {
      find_chains();
      std::set<Index> back;
      for (const Chain& c : chains_)
        for (const Chain& d : chains_)
          if (cross(c, d) && c.nodes.size() > 2) back.insert(c.nodes[(c.nodes.size() - 1) / 2]);
      if (back.empty()) return;
      for (const Index v : back) {
        invalid_.erase(v);
        take(v, conflicts(v));
      }
    }
  }
  void find_chains() {
    chains_.clear();
    for (const auto& [start, next] : boundary_) {
      if (!selected_.contains(start)) continue;
      Chain chain{{start}};
      Index v = next;
      for (; !selected_.contains(v); v = boundary_[v]) chain.nodes.push_back(v);
      chain.nodes.push_back(v);
      chains_.push_back(chain);
    }
  }
  bool cross(const Chain& c, const Chain& d) const {
    return turn(c.a(), c.b(), d.a()) * turn(c.a(), c.b(), d.b()) < 0 &&
           turn(d.a(), d.b(), c.a()) * turn(d.a(), d.b(), c.b()) < 0;
  }
  bool is_inside(Index v) const {
    int winding = 0;
    for (const Chain& c : chains_) {
      const bool from_below = points_[c.a()].y <= points_[v].y,
                 to_above = points_[c.b()].y > points_[v].y;
      if (from_below && to_above && turn(c.a(), c.b(), v) > 0) ++winding;
      if (!from_below && !to_above && turn(c.a(), c.b(), v) < 0) --winding;
    }
    return winding > 0;
  }
  bool is_too_close(Index v) const {
    const Point2 p = points_[v];
    return std::any_of(chains_.begin(), chains_.end(), [&](const Chain& c) {
      const Point2 a = points_[c.a()], b = points_[c.b()];
      const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
      const double area = std::fabs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
      const double e = length(c.a(), c.b());
      return dot < 0 && area / e < options_.protect * e;
    });
  }

  // ---- The constrained Delaunay triangulation: from every edge on, the triangle on its left whose
  // circle holds no visible node
  void triangulate() {
    triangles_.clear();
    std::set<Edge> open, constrained;
    for (const Chain& c : chains_) {
      open.insert({c.a(), c.b()});
      constrained.insert({c.a(), c.b()});
    }
    while (!open.empty()) {
      const auto [a, b] = *open.begin();
      open.erase(open.begin());
      const Index c = apex(a, b);
      triangles_.push_back({a, b, c});
      for (const Edge& side : {Edge{b, c}, Edge{c, a}}) {
        if (open.erase(side) > 0 || constrained.contains(side)) continue;
        open.insert({side[1], side[0]});
      }
    }
  }
  Index apex(Index a, Index b) const {
    Index best = a;
    for (const Index c : nodes_) {
      if (c == a || c == b || turn(a, b, c) <= 0) continue;
      const bool better =
          best == a || incircle(points_[a], points_[b], points_[best], points_[c]) > 0;
      if (better && is_visible(a, c) && is_visible(b, c)) best = c;
    }
    return best;
  }
  bool is_visible(Index v, Index w) const {
    return std::none_of(chains_.begin(), chains_.end(), [&](const Chain& c) {
      return turn(v, w, c.a()) * turn(v, w, c.b()) < 0 &&
             turn(c.a(), c.b(), v) * turn(c.a(), c.b(), w) < 0;
    });
  }

  SlowOptions options_;
  std::vector<Point2> points_;
  std::set<Index> fixed_;
  Index level_ = 0;
  NodeSet nodes_;
  std::vector<std::array<Index, 3>> triangles_;
  std::map<Index, std::set<Index>> neighbors_;
  std::map<Index, Index> boundary_;  // the next node along the boundary
  std::map<Index, double> spacing_;
  std::set<Index> selected_, invalid_;
  std::vector<Chain> chains_;
};

}  // namespace wellspaced::test
