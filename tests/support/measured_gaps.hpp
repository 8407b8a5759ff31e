// The gaps of a point set in a domain: brackets by halving triangles. Distances come from the
// auditor's tree, which shares nothing with the spacing functions of the coarsening.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/spacing_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

using PlaneTree = audit::SpacingTree<2>;

inline PlaneTree tree_of(std::span<const Point2> points, std::span<const double> values) {
  std::vector<audit::Vec<2>> places;
  for (const Point2 p : points) places.push_back({p.x, p.y});
  return PlaneTree(places, values);
}

inline PlaneTree tree_of(std::span<const Point2> points) {
  return tree_of(points, std::vector<double>(points.size(), 0));
}

// A 1-Lipschitz spacing on the domain: max(floor, min(ceiling(x), min over q of weight_q + |q -
// x|)).
class ConeFunction {
 public:
  // ceiling: 1-Lipschitz; empty: none. No places: the floor alone.
  ConeFunction(std::span<const Point2> places, std::span<const double> weights, double floor,
               std::function<double(Point2)> ceiling)
      : cones_(tree_of(places, weights)),
        is_floor_(places.empty()),
        floor_(floor),
        ceiling_(std::move(ceiling)) {}

  // A lower bound of the function on the disc; its value at the centre for radius 0.
  double least(Point2 centre, double radius) const {
    if (is_floor_) return floor_;
    const double value = cones_.least_within({centre.x, centre.y}, radius).value;
    return std::max(floor_, ceiling_ ? std::min(value, ceiling_(centre) - radius) : value);
  }

 private:
  PlaneTree cones_;
  bool is_floor_;
  double floor_;
  std::function<double(Point2)> ceiling_;
};

struct Bracket {
  double lower = 0, upper = 0;
  Point2 centre, at;  // of the gap that shows the lower end
};

inline double distance_to_points(const PlaneTree& points, Point2 x) {
  return points.nearest({x.x, x.y}).value;
}

// Of bounds: a spacing that may be 0 or less allows any gap.
inline double quotient(double length, double spacing) {
  return spacing > 0 ? length / spacing : HUGE_VAL;
}

struct GapCell {
  double upper;
  std::array<Point2, 3> corners;
  friend bool operator<(const GapCell& a, const GapCell& b) { return a.upper < b.upper; }
};

// No ball around a place in the cell that is empty has a parameter above it, whoever sees whom.
inline GapCell gap_cell(const std::array<Point2, 3>& corners, const PlaneTree& points,
                        const ConeFunction& f) {
  const auto [a, b, c] = corners;
  const Point2 middle{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  const double size =
      std::max({distance(middle, a), distance(middle, b), distance(middle, c)}) * (1 + 1e-12);
  const double radius = distance_to_points(points, middle) + size;
  return {quotient(radius, f.least(middle, radius + size)), corners};
}

inline bool is_in_domain(const TriangleMesh& domain, Point2 x) {
  const auto left = [&](Index a, Index b) {
    const Point2 p = domain.points[a], q = domain.points[b];
    return (q.x - p.x) * (x.y - p.y) - (q.y - p.y) * (x.x - p.x) >= 0;
  };
  return std::any_of(domain.triangles.begin(), domain.triangles.end(), [&](const auto& t) {
    return left(t[0], t[1]) && left(t[1], t[2]) && left(t[2], t[0]);
  });
}

// The gaps around a centre with x in 16 directions. The lower end is proven in convex domains,
// where the centre sees every x.
inline void raise_lower_end(Bracket& bracket, Point2 c, const TriangleMesh& domain,
                            const PlaneTree& points, const ConeFunction& f) {
  const double radius = distance_to_points(points, c);
  for (int k = 0; k < 16; ++k) {
    const double angle = k * 3.14159265358979 / 8;
    const Point2 x{c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)};
    const double parameter = quotient(radius, f.least(x, 0));
    if (parameter > bracket.lower && is_in_domain(domain, x))
      bracket = {parameter, bracket.upper, c, x};
  }
}

// Interior gaps: centres in the triangles that cover the domain.
inline Bracket interior_gaps(const TriangleMesh& domain, const std::vector<Point2>& nodes,
                             const ConeFunction& f, int most_cells = 20000) {
  const PlaneTree points = tree_of(nodes);
  std::priority_queue<GapCell> cells;
  Bracket bracket;
  for (const auto& [a, b, c] : domain.triangles)
    cells.push(gap_cell({domain.points[a], domain.points[b], domain.points[c]}, points, f));
  for (int k = 0; k < most_cells; ++k) {
    const auto [a, b, c] = cells.top().corners;
    bracket.upper = cells.top().upper;
    raise_lower_end(bracket, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, domain, points, f);
    if (bracket.upper < 1.1 * bracket.lower) break;
    cells.pop();
    const Point2 ab{(a.x + b.x) / 2, (a.y + b.y) / 2}, bc{(b.x + c.x) / 2, (b.y + c.y) / 2},
        ca{(c.x + a.x) / 2, (c.y + a.y) / 2};
    for (const auto& part : {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c},
                             std::array{ab, bc, ca}})
      cells.push(gap_cell(part, points, f));
  }
  return bracket;
}

// A part of a boundary edge, in parts of its length. An interval of the edge that ends in it is at
// most `longest`.
struct IntervalCell {
  double upper;
  Point2 a, b;
  double first, last;
  friend bool operator<(const IntervalCell& s, const IntervalCell& t) { return s.upper < t.upper; }

  Point2 at(double t) const { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }
  double middle() const { return (first + last) / 2; }
};

inline IntervalCell interval_cell(Point2 a, Point2 b, double first, double last,
                                  const ConeFunction& f) {
  IntervalCell cell{0, a, b, first, last};
  const double length = distance(a, b);
  cell.upper = quotient(length * std::max(last, 1 - first),
                        f.least(cell.at(cell.middle()), length * (last - first) / 2));
  return cell;
}

// An upper bound of the boundary gaps in the interval convention: no interval of a boundary edge
// that is longer than this times f at one of its places.
inline double boundary_gaps(const TriangleMesh& level, const ConeFunction& f) {
  std::priority_queue<IntervalCell> cells;
  double lower = 0;
  for (const Segment& s : level.segments)
    cells.push(interval_cell(level.points[s.a], level.points[s.b], 0, 1, f));
  for (int k = 0; k < 20000 && cells.top().upper > 1.1 * lower; ++k) {
    const IntervalCell cell = cells.top();
    cells.pop();
    const double half = cell.middle();
    lower = std::max(lower, quotient(distance(cell.a, cell.b) * std::max(half, 1 - half),
                                     f.least(cell.at(half), 0)));
    cells.push(interval_cell(cell.a, cell.b, cell.first, half, f));
    cells.push(interval_cell(cell.a, cell.b, half, cell.last, f));
  }
  return cells.top().upper;
}

// An upper bound of the side of an empty axis-parallel square in the unit square.
inline double largest_empty_square(const std::vector<Point2>& points) {
  struct Cell {
    double upper, half;
    Point2 centre;
    bool operator<(const Cell& other) const { return upper < other.upper; }
  };
  const auto cell = [&](Point2 c, double half) {
    double s = std::min({c.x, c.y, 1 - c.x, 1 - c.y});
    for (const Point2 p : points)
      s = std::min(s, std::max(std::fabs(p.x - c.x), std::fabs(p.y - c.y)));
    return Cell{s + half, half, c};
  };
  std::priority_queue<Cell> cells;
  cells.push(cell({0.5, 0.5}, 0.5));
  for (int k = 0; k < 20000 && cells.top().half > 0.02 * cells.top().upper; ++k) {
    const Cell top = cells.top();
    cells.pop();
    const double q = top.half / 2;
    for (const double dx : {-q, q})
      for (const double dy : {-q, q}) cells.push(cell({top.centre.x + dx, top.centre.y + dy}, q));
  }
  return 2 * cells.top().upper;
}

}  // namespace wellspaced::test
