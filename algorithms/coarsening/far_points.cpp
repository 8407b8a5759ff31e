#include "wellspaced/algorithms/coarsening/far_points.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// Positions of the corners of the convex hull, counter-clockwise (Andrew's monotone chain).
// Requires: a point.
std::vector<std::size_t> convex_hull(std::span<const Point2> points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  sort(order, [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) { return std::make_tuple(points[i].x, points[i].y, i); };
    return key(a) < key(b);
  });
  std::vector<std::size_t> hull;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto it = first; it != last; ++it) {
      while (hull.size() > base + 1 &&
             orient2d(points[hull[hull.size() - 2]], points[hull.back()], points[*it]) <= 0)
        hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();  // the other chain starts with it
  };
  add_chain(order.begin(), order.end());
  add_chain(order.rbegin(), order.rend());
  return hull;
}

// The pair of positions that are farthest apart; of equals the one with the lowest positions.
struct FarPair {
  double distance = -1;
  std::size_t a = 0, b = 0;

  void consider(std::span<const Point2> points, std::size_t i, std::size_t j) {
    if (i > j) std::swap(i, j);
    const double d = wellspaced::distance(points[i], points[j]);
    if (d > distance || (d == distance && std::pair{i, j} < std::pair{a, b})) *this = {d, i, j};
  }
};

double distance_to_line(Point2 p, Point2 a, Point2 b) {
  const double length = distance(a, b);
  return std::fabs((p.x - a.x) * ((b.y - a.y) / length) - (p.y - a.y) * ((b.x - a.x) / length));
}

// Rotating calipers: as the edge i, i+1 turns around the hull, its farthest corner j follows.
FarPair farthest_pair(std::span<const Point2> points) {
  const std::vector<std::size_t> hull = convex_hull(points);
  const std::size_t n = hull.size();
  FarPair best;
  const auto corner = [&](std::size_t i) { return points[hull[i % n]]; };
  for (std::size_t i = 0, j = 1; i < n; ++i) {
    for (; j < i + n; ++j) {
      best.consider(points, hull[i % n], hull[j % n]);
      best.consider(points, hull[(i + 1) % n], hull[j % n]);
      const Point2 a = corner(i), b = corner(i + 1);
      if (distance_to_line(corner(j + 1), a, b) < distance_to_line(corner(j), a, b)) break;
    }
  }
  return best;
}

double distance_to_triangle(Point2 p, Point2 a, Point2 b, Point2 c) {
  const int ab = orient2d(a, b, p), bc = orient2d(b, c, p), ca = orient2d(c, a, p);
  const bool inside = (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  if (inside) return 0;
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

// The position with the greatest measure, the lowest of equals; loop.size() if none is positive.
template <class Measure>
std::size_t farthest(std::span<const Point2> loop, Measure measure) {
  std::size_t best = loop.size();
  double greatest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (const double value = measure(loop[i]); value > greatest) greatest = value, best = i;
  return best;
}

std::size_t next_far_point(std::span<const Point2> loop, std::span<const std::size_t> chosen) {
  const auto at = [&](std::size_t k) { return loop[chosen[k]]; };
  if (chosen.size() == 1) return farthest(loop, [&](Point2 p) { return distance(p, at(0)); });
  if (chosen.size() >= 3)
    return farthest(loop, [&](Point2 p) { return distance_to_triangle(p, at(0), at(1), at(2)); });
  const auto off_line = farthest(loop, [&](Point2 p) { return distance_to_line(p, at(0), at(1)); });
  if (off_line != loop.size()) return off_line;
  return farthest(loop, [&](Point2 p) { return std::min(distance(p, at(0)), distance(p, at(1))); });
}

}  // namespace

std::vector<std::size_t> add_far_points(std::span<const Point2> loop,
                                        std::vector<std::size_t> chosen, std::size_t count) {
  if (chosen.empty()) {
    if (loop.size() < 2) return {};
    const FarPair pair = farthest_pair(loop);
    if (!(pair.distance > 0)) return {};
    chosen = {pair.a, pair.b};
  }
  while (chosen.size() < count) {
    const std::size_t next = next_far_point(loop, chosen);
    if (next == loop.size()) break;
    chosen.push_back(next);
  }
  return chosen;
}

}  // namespace wellspaced
