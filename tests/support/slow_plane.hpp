// Points, crossings and triangulations of the plane in the tests' own integers: for each question
// the plainest answer, by trying everything. It shares nothing with the library.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "tests/support/slow_integer.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::testing {

/// The point (x / w, y / w) times 2^-kSlowUnit: crossings have w > 1.
struct SlowPoint {
  SlowInteger x, y, w = 1;
};

/// Every double is an integer times 2^kSlowUnit.
inline constexpr int kSlowUnit = -1074;

inline SlowPoint slow_point(Point2 p, int unit = kSlowUnit) {
  return {SlowInteger::from_double(p.x, unit), SlowInteger::from_double(p.y, unit)};
}

/// -1, 0 or 1: by x, then by y.
inline int slow_order(const SlowPoint& p, const SlowPoint& q) {
  const int order = (p.x * q.w - q.x * p.w).sign();
  return order != 0 ? order : (p.y * q.w - q.y * p.w).sign();
}

/// Positive for a left turn.
inline int slow_turn(const SlowPoint& p, const SlowPoint& q, const SlowPoint& r) {
  return (p.x * (q.y * r.w - r.y * q.w) - p.y * (q.x * r.w - r.x * q.w) +
          p.w * (q.x * r.y - r.x * q.y))
      .sign();
}

/// Positive for d inside the circle through a, b, c, counter-clockwise. Requires: all w = 1.
inline int slow_incircle(const SlowPoint& a, const SlowPoint& b, const SlowPoint& c,
                         const SlowPoint& d) {
  const SlowInteger ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x,
                    cy = c.y - d.y;
  return ((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
          (cx * cx + cy * cy) * (ax * by - ay * bx))
      .sign();
}

/// Where the lines ab and cd cross. Requires: that they do.
inline SlowPoint slow_crossing(const SlowPoint& a, const SlowPoint& b, const SlowPoint& c,
                               const SlowPoint& d) {
  const SlowInteger k = a.y - b.y, l = b.x - a.x, m = a.x * b.y - b.x * a.y;
  const SlowInteger r = c.y - d.y, s = d.x - c.x, t = c.x * d.y - d.x * c.y;
  SlowPoint p{l * t - s * m, m * r - t * k, k * s - r * l};
  if (p.w.sign() < 0) p = {-p.x, -p.y, -p.w};
  return p;
}

/// Whether the coordinate x / w lies within two units in the last place of the double p: two
/// distances between the doubles on either side of x / w.
inline bool is_within_two_ulp(double p, const SlowInteger& x, const SlowInteger& w) {
  const auto integer = [](double value) { return SlowInteger::from_double(value, kSlowUnit); };
  double below = p;
  for (int steps = 0; integer(below) * w > x; below = std::nextafter(below, -HUGE_VAL))
    if (++steps > 8) return false;
  for (int steps = 0; integer(std::nextafter(below, HUGE_VAL)) * w <= x;
       below = std::nextafter(below, HUGE_VAL))
    if (++steps > 8) return false;
  const SlowInteger ulp = integer(std::nextafter(below, HUGE_VAL)) - integer(below);
  const SlowInteger error = integer(p) * w - x, bound = ulp * w + ulp * w;
  return error <= bound && -error <= bound;
}

/// Whether segment ab has a point within two doubles of p in each coordinate.
inline bool slow_passes_near(Point2 a, Point2 b, Point2 p) {
  const auto two_on = [](double x, double towards) {
    return std::nextafter(std::nextafter(x, towards), towards);
  };
  const double most = std::numeric_limits<double>::max();
  const double left = two_on(p.x, -most), right = two_on(p.x, most);
  const double low = two_on(p.y, -most), high = two_on(p.y, most);
  const auto reaches = [](double c, double d, double from, double to) {
    return std::max(c, d) >= from && std::min(c, d) <= to;
  };
  if (!reaches(a.x, b.x, left, right) || !reaches(a.y, b.y, low, high)) return false;
  int least = 1, most_left = -1;
  for (const double x : {left, right})
    for (const double y : {low, high}) {
      const int side = slow_turn(slow_point(a), slow_point(b), slow_point({x, y}));
      least = std::min(least, side);
      most_left = std::max(most_left, side);
    }
  return least <= 0 && most_left >= 0;
}

/// Points of the plane with all that can be said of them by trying.
class SlowPoints {
 public:
  explicit SlowPoints(std::span<const Point2> points) {
    int unit = 1024;
    for (const Point2 p : points)
      for (const double c : {p.x, p.y})
        if (c != 0) unit = std::min(unit, std::max(std::ilogb(c) - 52, kSlowUnit));
    for (const Point2 p : points) points_.push_back(slow_point(p, unit));
    for (Index i = 0; i < points_.size(); ++i) {
      Index j = 0;
      while (slow_order(points_[j], points_[i]) != 0) ++j;
      representative_.push_back(j);
      if (i == j) distinct_.push_back(i);
    }
  }

  Index representative(Index i) const { return representative_[i]; }
  const std::vector<Index>& distinct() const { return distinct_; }

  int turn(Index a, Index b, Index c) const {
    return slow_turn(points_[a], points_[b], points_[c]);
  }

  int dimension() const {
    if (distinct_.size() < 3) return static_cast<int>(distinct_.size()) - 1;
    for (const Index c : distinct_)
      if (turn(distinct_[0], distinct_[1], c) != 0) return 2;
    return 1;
  }

  /// How many distinct points lie on the boundary of the hull. Requires: dimension() == 2.
  std::size_t hull_size() const {
    return static_cast<std::size_t>(
        std::count_if(distinct_.begin(), distinct_.end(), [&](Index v) { return on_hull(v); }));
  }

  /// The distinct points on the circle through a, b, c; empty if one lies inside.
  std::vector<Index> empty_circle(Index a, Index b, Index c) const {
    std::vector<Index> on_circle;
    for (const Index d : distinct_) {
      const int side = slow_incircle(points_[a], points_[b], points_[c], points_[d]);
      if (side > 0) return {};
      if (side == 0) on_circle.push_back(d);
    }
    return on_circle;
  }

  /// The Delaunay polygons: the vertex sets on all empty circles.
  std::set<std::vector<Index>> delaunay_cells() const {
    std::set<std::vector<Index>> cells;
    for (const Index a : distinct_)
      for (const Index b : distinct_)
        for (const Index c : distinct_) {
          if (b <= a || c <= a || b == c || turn(a, b, c) <= 0) continue;
          if (auto cell = empty_circle(a, b, c); !cell.empty()) cells.insert(std::move(cell));
        }
    return cells;
  }

 private:
  bool on_hull(Index v) const {
    return std::any_of(distinct_.begin(), distinct_.end(), [&](Index u) {
      return u != v && std::all_of(distinct_.begin(), distinct_.end(),
                                   [&](Index w) { return turn(v, u, w) >= 0; });
    });
  }

  std::vector<SlowPoint> points_;
  std::vector<Index> representative_, distinct_;
};

/// What a planar straight-line graph becomes when all its crossings are vertices.
///
/// crossings: the points where segments cross that are no input points, ascending by x, then y;
/// number k is vertex points.size() + k. pieces: the pairs of vertices next to each other on a
/// segment, lower number first, ascending. pairs: the segments that cross at such a point, two by
/// two.
struct SlowArrangement {
  std::vector<SlowPoint> crossings;
  std::vector<std::array<Index, 2>> pieces;
  std::vector<Index> pairs;

  explicit SlowArrangement(const Pslg& graph) {
    for (const Point2 p : graph.points) vertices_.push_back(slow_point(p));
    const SlowPoints points(graph.points);
    find_crossings(graph, points);
    for (const SlowPoint& p : crossings) vertices_.push_back(p);
    for (const Segment& s : graph.segments) cut(s, points);
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  }

 private:
  int turn(Index a, Index b, Index c) const {
    return slow_turn(vertices_[a], vertices_[b], vertices_[c]);
  }

  void find_crossings(const Pslg& graph, const SlowPoints& points) {
    const auto less = [](const SlowPoint& p, const SlowPoint& q) { return slow_order(p, q) < 0; };
    std::set<SlowPoint, decltype(less)> found(less);
    for (Index i = 0; i < graph.segments.size(); ++i)
      for (Index j = i + 1; j < graph.segments.size(); ++j) {
        const Segment s = graph.segments[i], t = graph.segments[j];
        if (turn(s.a, s.b, t.a) * turn(s.a, s.b, t.b) >= 0) continue;
        if (turn(t.a, t.b, s.a) * turn(t.a, t.b, s.b) >= 0) continue;
        const SlowPoint p =
            slow_crossing(vertices_[s.a], vertices_[s.b], vertices_[t.a], vertices_[t.b]);
        if (std::any_of(points.distinct().begin(), points.distinct().end(),
                        [&](Index v) { return slow_order(vertices_[v], p) == 0; }))
          continue;
        found.insert(p);
        pairs.insert(pairs.end(), {i, j});
      }
    crossings.assign(found.begin(), found.end());
  }

  void cut(const Segment& s, const SlowPoints& points) {
    const Index a = points.representative(s.a), b = points.representative(s.b);
    if (a == b) return;
    const int way = slow_order(vertices_[a], vertices_[b]);
    std::vector<Index> on;
    for (Index v = 0; v < vertices_.size(); ++v) {
      if (v < vertices_.size() - crossings.size() && points.representative(v) != v) continue;
      const int from_a = slow_order(vertices_[a], vertices_[v]);
      const int to_b = slow_order(vertices_[v], vertices_[b]);
      if (from_a != -way && to_b != -way && turn(a, b, v) == 0) on.push_back(v);
    }
    std::sort(on.begin(), on.end(),
              [&](Index u, Index v) { return slow_order(vertices_[u], vertices_[v]) < 0; });
    for (std::size_t i = 0; i + 1 < on.size(); ++i)
      pieces.push_back({std::min(on[i], on[i + 1]), std::max(on[i], on[i + 1])});
  }

  std::vector<SlowPoint> vertices_;
};

}  // namespace wellspaced::testing
