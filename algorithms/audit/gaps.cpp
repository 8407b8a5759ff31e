#include "wellspaced/algorithms/audit/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/audit/circumcentre.hpp"
#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

constexpr double kDown = 1 - 0x1p-40, kUp = 1 + 0x1p-40;  // beyond what rounding may have done
constexpr std::uint64_t kStepsAQuestion = 1 << 11;

// Offers the gap of radius r around c in the direction of `towards`; the ball must be empty.
template <std::size_t D>
void offer_gap(const SpacingTree<D>& spacing, const Vec<D>& c, double r, const Vec<D>& towards,
               GapBracket<D>& bracket) {
  const Vec<D> direction = difference(towards, c);
  const double length = norm(direction);
  if (!(length > 0)) return;
  const double radius = std::min(r, length) * kDown;
  const Vec<D> x = step(c, radius / length, direction);
  const double parameter = radius * kDown / spacing.at(x).value;
  if (parameter > bracket.lower) {
    bracket.lower = parameter;
    bracket.centre = c;
    bracket.at = x;
  }
}

// No gap with its centre within e of c has a larger parameter; r: the radius of the gaps at c.
template <std::size_t D>
double largest_parameter(const SpacingTree<D>& spacing, const Vec<D>& c, double r, double e) {
  return ratio((r + e) * kUp, spacing.least_within(c, (r + 2 * e) * kUp).value * kDown);
}

// ---- Voronoi vertices

template <std::size_t D>
struct Candidate {
  Vec<D> centre;
  double radius, error, upper;
};

template <std::size_t D>
std::vector<Candidate<D>> voronoi_vertices(const SpacedPoints<D>& points) {
  std::vector<Candidate<D>> candidates;
  candidates.reserve(points.delaunay.size());
  ProgressMeter meter(points.progress, "audit", 0, kStepsAQuestion);
  for (const auto& simplex : points.delaunay) {
    if (!meter.step()) return {};
    std::array<Vec<D>, D + 1> corners;
    for (std::size_t i = 0; i <= D; ++i) corners[i] = points.places[simplex[i]];
    const auto [centre, error] = circumcentre<D>(corners);
    double radius = kInfinity;
    for (const auto& corner : corners) radius = std::min(radius, distance_of(centre, corner));
    const bool known = std::isfinite(radius) && error < radius;
    const double upper =
        known ? largest_parameter(points.spacing, centre, radius, error) : kInfinity;
    candidates.push_back({centre, radius, error, upper});
  }
  sort(candidates, [](const auto& a, const auto& b) { return a.upper > b.upper; });
  return candidates;
}

// Whether a centre may lie in the domain, for all that is known about it.
template <std::size_t D>
bool may_be_inside(const BoundaryPieces<D>& boundary, const Candidate<D>& candidate) {
  return boundary.contains(candidate.centre) ||
         boundary.comes_near(candidate.centre, candidate.error);
}

// The gap of radius r around a point of the domain, towards a place, or as far on the way there as
// can be seen.
template <std::size_t D>
void offer_gap_in_sight(const SpacedPoints<D>& points, const Vec<D>& c, double r,
                        const Vec<D>& towards, GapBracket<D>& bracket) {
  constexpr int kHalvings = 20;
  const Vec<D> way = difference(towards, c);
  const double length = norm(way);
  if (!(length > 0)) return;
  const auto is_clear = [&](double part) {
    return points.boundary.leaves_clear(c, step(c, part, way));
  };
  double seen = kDown * std::min(1.0, r / length);
  if (!is_clear(seen)) {
    double hidden = std::exchange(seen, 0);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (seen + hidden) / 2;
      (is_clear(middle) ? seen : hidden) = middle;
    }
  }
  offer_gap(points.spacing, c, r, step(c, seen, way), bracket);
}

// Those around a point of the domain: towards the points that make them small or close.
template <std::size_t D>
void offer_gaps_around(const SpacedPoints<D>& points, const Vec<D>& c, double r,
                       GapBracket<D>& bracket) {
  for (const Index q : {points.spacing.at(c).node, points.spacing.nearest(c).node})
    offer_gap_in_sight(points, c, r, points.places[q], bracket);
}

// Those around a point of the boundary simplex s, their centres a little way inside; along s if
// the points lie behind it.
template <std::size_t D>
void offer_gaps_inwards(const SpacedPoints<D>& points, Index s, const Vec<D>& c, double r,
                        GapBracket<D>& bracket) {
  constexpr double kLittle = 0x1p-20;
  const auto inwards = points.boundary.inward_normal(s);
  if (!inwards) return;
  const Vec<D> inside = step(c, kLittle * r, *inwards);
  if (!points.boundary.contains(inside)) return;
  for (const Index q : {points.spacing.at(c).node, points.spacing.nearest(c).node}) {
    const double height = product(*inwards, difference(points.places[q], inside));
    const Vec<D> towards = step(points.places[q], std::max(0.0, -height), *inwards);
    offer_gap_in_sight(points, inside, r * (1 - 2 * kLittle), towards, bracket);
  }
}

// The largest upper bound is that of the first vertex inside; the lower ones of further vertices
// matter until one comes close to it.
template <std::size_t D>
GapBracket<D> gap_at_vertices(const SpacedPoints<D>& points) {
  GapBracket<D> bracket;
  ProgressMeter meter(points.progress, "audit", 0, kStepsAQuestion);
  for (const Candidate<D>& candidate : voronoi_vertices(points)) {
    if (!meter.step()) break;
    if (candidate.upper <= bracket.lower) break;
    if (bracket.upper > 0 && bracket.lower * (1 + points.tolerance) >= bracket.upper) break;
    if (!may_be_inside(points.boundary, candidate)) continue;
    bracket.upper = std::max(bracket.upper, candidate.upper);
    if (points.boundary.contains(candidate.centre) && candidate.error < candidate.radius)
      offer_gaps_around(points, candidate.centre, candidate.radius - candidate.error, bracket);
  }
  return bracket;
}

// ---- Search by halving

// A part of simplex `of`; no gap with its centre in there has a larger parameter than `upper`.
template <std::size_t D, std::size_t K>
struct SearchCell {
  std::array<Vec<D>, K> corners;
  Index of;
  double upper;
};

template <std::size_t D, std::size_t K>
std::array<SearchCell<D, K>, 2> halves(const SearchCell<D, K>& cell) {
  std::size_t a = 0, b = 1;
  for (std::size_t i = 0; i < K; ++i)
    for (std::size_t j = i + 1; j < K; ++j)
      if (distance_of(cell.corners[i], cell.corners[j]) >
          distance_of(cell.corners[a], cell.corners[b]))
        a = i, b = j;
  const Vec<D> middle = step(cell.corners[a], 0.5, difference(cell.corners[b], cell.corners[a]));
  std::array<SearchCell<D, K>, 2> result{cell, cell};
  result[0].corners[a] = middle;
  result[1].corners[b] = middle;
  return result;
}

// Looks for the largest gap that belongs to a place on one of the simplices. judge(cell, place, e,
// bracket) offers gaps there and returns what no gap that belongs to the cell, all of which lies
// within e of the place, can exceed.
template <std::size_t D, std::size_t K, class Judge>
void search_gaps(const SpacedPoints<D>& points, std::span<const std::array<Vec<D>, K>> simplices,
                 Judge judge, GapBracket<D>& bracket) {
  using Cell = SearchCell<D, K>;
  std::vector<Cell> heap;
  const auto below = [](const Cell& a, const Cell& b) { return a.upper < b.upper; };
  const auto add = [&](Cell cell) {
    Vec<D> centre{};
    for (const auto& corner : cell.corners) centre = step(centre, 1.0 / K, corner);
    double e = 0;
    for (const auto& corner : cell.corners) e = std::max(e, distance_of(centre, corner));
    cell.upper = judge(cell, centre, e, bracket);
    if (cell.upper <= bracket.lower) return;
    heap.push_back(cell);
    std::push_heap(heap.begin(), heap.end(), below);
  };
  ProgressMeter meter(points.progress, "audit", 0, kStepsAQuestion);
  for (Index s = 0; s < simplices.size() && meter.step(); ++s) add({simplices[s], s, 0});
  std::size_t budget = 100000 + 50 * simplices.size();
  const auto goal = [&] { return std::max(bracket.lower * (1 + points.tolerance), bracket.upper); };
  while (meter.step() && !heap.empty() && heap.front().upper > goal() && budget-- > 0) {
    std::pop_heap(heap.begin(), heap.end(), below);
    const Cell cell = heap.back();
    heap.pop_back();
    for (const Cell& half : halves(cell)) add(half);
  }
  if (!heap.empty()) bracket.upper = std::max(bracket.upper, heap.front().upper);
  bracket.upper = std::max(bracket.upper, bracket.lower);
}

// The largest parameter of gaps around the places of a cell, if no more than two points are nearest
// to any of them, else infinite. The cell is then one polygon, or two, in Voronoi cells, so that
// the largest is that of a corner: see interior_gap().
template <std::size_t D>
class CellGaps {
 public:
  CellGaps(const SpacedPoints<D>& points, const std::array<Vec<D>, D>& corners)
      : points_(points), corners_(corners) {}

  double largest() {
    std::array<Index, D> owner;
    for (std::size_t i = 0; i < D; ++i) {
      const auto nearest = points_.spacing.nearest(corners_[i]);
      owner[i] = nearest.node;
      for (std::size_t j = 0; j < i; ++j)
        if (is_nearest(owner[j], corners_[i], nearest.value)) owner[i] = owner[j];
      judge(corners_[i], nearest.value);
    }
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (owner[i] != owner[j] && !judge_wall(corners_[j], corners_[i], owner[j], owner[i]))
          return kInfinity;
    return D == 3 && owner[2] != owner[0] && owner[2] != owner[1] && owner[0] != owner[1]
               ? kInfinity
               : largest_;
  }

 private:
  bool is_nearest(Index p, const Vec<D>& c, double distance) const {
    return distance_of(points_.places[p], c) <= distance * kUp;
  }

  void judge(const Vec<D>& c, double r) {
    const double rounding = 0x1p-40 * r + 0x1p-50 * norm(c);
    largest_ = std::max(largest_, largest_parameter(points_.spacing, c, r, rounding));
  }

  // Where the way from a to b leaves the Voronoi cell of p for that of q, if there is none between.
  bool judge_wall(const Vec<D>& a, const Vec<D>& b, Index p, Index q) {
    const auto excess = [&](const Vec<D>& c) {
      const Vec<D> to_p = difference(points_.places[p], c), to_q = difference(points_.places[q], c);
      return product(to_p, to_p) - product(to_q, to_q);
    };
    const double at_a = excess(a), at_b = excess(b);
    if (!(at_a <= 0 && at_b >= 0 && at_a < at_b)) return false;
    const Vec<D> wall = step(a, at_a / (at_a - at_b), difference(b, a));
    const double r = points_.spacing.nearest(wall).value;
    judge(wall, r);
    return is_nearest(p, wall, r) && is_nearest(q, wall, r);
  }

  const SpacedPoints<D>& points_;
  const std::array<Vec<D>, D>& corners_;
  double largest_ = 0;
};

// Gaps with their centres on the boundary: towards the corners of the simplex, which hides none of
// itself, and towards the points.
template <std::size_t D>
void search_boundary(const SpacedPoints<D>& points, GapBracket<D>& bracket) {
  std::vector<std::array<Vec<D>, D>> simplices;
  for (Index s = 0; s < points.boundary.size(); ++s)
    simplices.push_back(points.boundary.corners(s));
  const auto judge = [&](const SearchCell<D, D>& cell, const Vec<D>& centre, double e,
                         GapBracket<D>& found) {
    const double r = points.spacing.nearest(centre).value;
    const double upper = largest_parameter(points.spacing, centre, r, e);
    if (upper <= found.lower) return upper;
    for (const auto& corner : simplices[cell.of])
      offer_gap(points.spacing, centre, r, corner, found);
    offer_gaps_inwards(points, cell.of, centre, r, found);
    return std::min(upper, CellGaps<D>(points, cell.corners).largest());
  };
  search_gaps<D, D>(points, simplices, judge, bracket);
}

// The points on each piece of a boundary, ready to be asked for the nearest.
class PointsOnPieces {
 public:
  PointsOnPieces(std::span<const Vec<3>> places, const BoundaryPieces<3>& boundary)
      : boundary_(boundary), tree_of_(boundary.size(), kNoIndex) {
    std::vector<std::array<Index, 2>> order;
    for (Index s = 0; s < boundary.size(); ++s)
      for (const Index v : boundary.nodes(s)) order.push_back({boundary.piece(s), v});
    sort_unique(order);
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
      std::vector<Vec<3>> on_piece;
      for (; end < order.size() && order[end][0] == order[i][0]; ++end)
        on_piece.push_back(places[order[end][1]]);
      tree_of_[order[i][0]] = static_cast<Index>(trees_.size());
      trees_.emplace_back(on_piece, std::vector<double>(on_piece.size(), 0.0));
    }
  }

  double distance(Index simplex, const Vec<3>& x) const {
    return trees_[tree_of_[boundary_.piece(simplex)]].nearest(x).value;
  }

 private:
  const BoundaryPieces<3>& boundary_;
  std::vector<Index> tree_of_;
  std::vector<SpacingTree<3>> trees_;
};

// ---- Gaps in a plane

// The largest parameter, and the point it comes from, of gaps whose centre c' lies within e of c
// and whose x lies with it in the plane through c with this unit normal; r: the radius of gaps at
// c.
//
// At a distance t from c towards the foot of q, at height h over the plane and distance s from c,
// the parameter is at most min(t, r) + e over f_q + sqrt(h^2 + (t - s)^2), which rises with t up to
// one place.
struct PlanarGap {
  Index towards = kNoIndex;
  double parameter = 0, distance = 0;
};

class PlanarGaps {
 public:
  PlanarGaps(const Vec<3>& c, const Vec<3>& normal, double r, double e)
      : c_(c), normal_(normal), reach_(r + 2 * e), r_(r), e_(e) {}

  // The largest, if it exceeds `least`.
  PlanarGap largest(const SpacedPoints<3>& points, double least) const {
    const auto found =
        points.spacing.minimise([&](const Tree::SiteBox& box, double f) { return -bound(box, f); },
                                [&](const Vec<3>& place, double f) {
                                  return -parameter(place, f, best_distance(place, f));
                                },
                                -least);
    if (found.node == kNoIndex) return {};
    const Vec<3>& place = points.places[found.node];
    // The value comes back from the tree; the distance is found again.
    return {found.node, -found.value, best_distance(place, points.spacing.at(place).value)};
  }

  // The place of the plane at that distance from c towards the foot of q.
  Vec<3> towards_foot(const Vec<3>& q, double distance) const {
    const Vec<3> w = difference(q, c_), flat = step(w, -product(w, normal_), normal_);
    const double s = norm(flat);
    return s > 0 ? step(c_, distance / s, flat) : c_;
  }

 private:
  using Tree = SpacingTree<3>;
  struct Foot {
    double h, s;
  };
  // How far a box is from the plane, and how far its points are from c.
  struct Reach {
    double height, nearest, farthest;
  };
  Reach reach_of(const Tree::SiteBox& box) const {
    double middle = 0, half = 0, farthest_sq = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = box.low[i] - c_[i], high = box.high[i] - c_[i];
      middle += normal_[i] * (low / 2 + high / 2);
      half += std::fabs(normal_[i]) * (high / 2 - low / 2);
      farthest_sq += std::max(low * low, high * high);
    }
    return {std::max(0.0, std::fabs(middle) - half), Tree::distance_to(box, c_),
            std::sqrt(farthest_sq)};
  }

  // No point of the box with a value of f or more has a larger parameter: a place at the distance
  // t is at least |t - |q - c|| and h away from q. In between the distances tried the quotient only
  // rises or only falls.
  double bound(const Tree::SiteBox& box, double f) const {
    const auto [height, nearest, farthest] = reach_of(box);
    double largest = 0;
    for (const double tried : {0.0, nearest - height, farthest + height, r_, reach_}) {
      const double t = std::clamp(tried, 0.0, reach_);
      const double away = std::max({height, t - farthest, nearest - t});
      largest = std::max(largest, ratio(std::min(t, r_) + e_, f + away));
    }
    return largest * kUp;
  }

  Foot foot_of(const Vec<3>& q) const {
    const Vec<3> w = difference(q, c_);
    const double h = product(w, normal_);
    return {std::fabs(h), norm(step(w, -h, normal_))};
  }

  double best_distance(const Vec<3>& q, double f) const {
    const auto [h, s] = foot_of(q);
    const double a = s + e_;
    const double at_cap = std::clamp(s, r_, reach_);
    if (a <= f) return at_cap;
    const double u = (a * h * h + h * f * std::sqrt(a * a + h * h - f * f)) / (a * a - f * f);
    return s + u <= r_ ? s + u : at_cap;
  }

  double parameter(const Vec<3>& q, double f, double t) const {
    const auto [h, s] = foot_of(q);
    return std::min(t + e_, r_ + e_) / (f + std::sqrt(h * h + (t - s) * (t - s)));
  }

  Vec<3> c_, normal_;
  double reach_, r_, e_;
};

// Whether x lies in the triangle, given that it lies in its plane.
bool lies_over(const Vec<3>& x, const std::array<Vec<3>, 3>& t, const Vec<3>& normal) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec<3>&a = t[i], &b = t[(i + 1) % 3];
    if (product(cross_product(difference(b, a), difference(x, a)), normal) < 0) return false;
  }
  return true;
}

// ---- Gaps on a face that is one triangle

double distance_squared(const Vec<3>& a, const Vec<3>& b) {
  const Vec<3> w = difference(b, a);
  return product(w, w);
}

// The part of a convex polygon where a linear function is not negative.
template <class Linear>
std::vector<Vec<3>> clipped(const std::vector<Vec<3>>& polygon, Linear function) {
  std::vector<Vec<3>> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec<3>&a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double at_a = function(a), at_b = function(b);
    if (at_a >= 0) result.push_back(a);
    if ((at_a < 0) != (at_b < 0)) result.push_back(step(a, at_a / (at_a - at_b), difference(b, a)));
  }
  return result;
}

// The centre in the triangle farthest from x, of those to which the square of no corner's distance
// is less than that of x by more than `slack`. They form a polygon.
Vec<3> farthest_centre(const std::array<Vec<3>, 3>& t, const Vec<3>& x, double slack) {
  std::vector<Vec<3>> polygon(t.begin(), t.end());
  for (const Vec<3>& corner : t)
    polygon = clipped(polygon, [&](const Vec<3>& c) {
      return distance_squared(c, corner) + slack - distance_squared(c, x);
    });
  Vec<3> farthest = x;
  for (const Vec<3>& c : polygon)
    if (distance_squared(c, x) > distance_squared(farthest, x)) farthest = c;
  return farthest;
}

double distance_to_corners(const std::array<Vec<3>, 3>& t, const Vec<3>& c) {
  return std::min({distance_of(c, t[0]), distance_of(c, t[1]), distance_of(c, t[2])});
}

double longest_side(const std::array<Vec<3>, 3>& t) {
  return std::max({distance_of(t[0], t[1]), distance_of(t[1], t[2]), distance_of(t[2], t[0])});
}

// The places x are searched. For one within e of x, distances from a centre differ by e at most, so
// their squares by no more than 2 e times the longest side.
void search_triangles(const SpacedPoints<3>& points,
                      const std::vector<std::array<Vec<3>, 3>>& triangles, GapBracket<3>& bracket) {
  constexpr double kRoundingPart = 0x1p-40;
  const auto judge = [&](const SearchCell<3, 3>& cell, const Vec<3>& x, double e,
                         GapBracket<3>& found) {
    const std::array<Vec<3>, 3>& t = triangles[cell.of];
    const double longest = longest_side(t), f = points.spacing.at(x).value;
    const double slack = 2 * longest * (e + kRoundingPart * longest);
    const double reach = distance_of(farthest_centre(t, x, slack), x) + e + kRoundingPart * longest;
    const double upper = ratio(reach * kUp, f * kDown - e);
    if (upper <= found.lower) return upper;
    const Vec<3> c = farthest_centre(t, x, 0);
    offer_gap(points.spacing, c, distance_to_corners(t, c), x, found);
    return upper;
  };
  search_gaps<3, 3>(points, triangles, judge, bracket);
}

std::vector<Index> sizes_of_pieces(const BoundaryPieces<3>& boundary) {
  std::vector<Index> sizes(boundary.size(), 0);
  for (Index s = 0; s < boundary.size(); ++s) ++sizes[boundary.piece(s)];
  return sizes;
}

}  // namespace

template <std::size_t D>
GapBracket<D> interior_gap(const SpacedPoints<D>& points) {
  GapBracket<D> bracket = gap_at_vertices(points);
  search_boundary(points, bracket);
  return bracket;
}

GapBracket<3> face_gap(const SpacedPoints<3>& points) {
  GapBracket<3> bracket;
  const PointsOnPieces on_pieces(points.places, points.boundary);
  std::vector<std::array<Vec<3>, 3>> lone, faces;
  std::vector<Index> number;  // of the simplices in `faces`
  const std::vector<Index> sizes = sizes_of_pieces(points.boundary);
  for (Index s = 0; s < points.boundary.size(); ++s) {
    const bool is_lone = sizes[points.boundary.piece(s)] == 1;
    (is_lone ? lone : faces).push_back(points.boundary.corners(s));
    if (!is_lone) number.push_back(s);
  }
  search_triangles(points, lone, bracket);
  const auto judge = [&](const SearchCell<3, 3>& cell, const Vec<3>& c, double e,
                         GapBracket<3>& found) {
    const Index s = cell.of;
    const Vec<3> normal = unit_normal(faces[s]);
    const double r = on_pieces.distance(number[s], c);
    const PlanarGap limit = PlanarGaps(c, normal, r, e).largest(points, found.lower / kUp);
    const double upper = limit.parameter * kUp;
    if (upper <= found.lower) return upper;
    for (const auto& corner : faces[s]) offer_gap(points.spacing, c, r, corner, found);
    const PlanarGaps here(c, normal, r, 0);
    const PlanarGap gap = here.largest(points, found.lower);
    if (gap.towards == kNoIndex) return upper;
    const Vec<3> x = here.towards_foot(points.places[gap.towards], gap.distance);
    if (lies_over(x, faces[s], normal)) offer_gap(points.spacing, c, r, x, found);
    return upper;
  };
  search_gaps<3, 3>(points, faces, judge, bracket);
  return bracket;
}

// The largest gap at x on an edge reaches from x to the farther end.
template <std::size_t D>
GapBracket<D> segment_gap(const SpacedPoints<D>& points,
                          std::span<const std::array<Index, 2>> edges) {
  GapBracket<D> bracket;
  std::vector<std::array<Vec<D>, 2>> segments;
  for (const auto& [a, b] : edges) segments.push_back({points.places[a], points.places[b]});
  const auto judge = [&](const SearchCell<D, 2>& cell, const Vec<D>& x, double e,
                         GapBracket<D>& found) {
    const auto& [a, b] = segments[cell.of];
    const Vec<D>& end = distance_of(x, a) > distance_of(x, b) ? a : b;
    const double diameter = distance_of(x, end), f = points.spacing.at(x).value;
    const double parameter = diameter / 2 * kDown / f;
    if (parameter > found.lower) {
      const Vec<D> centre = step(x, 0.5, difference(end, x));
      found.lower = parameter, found.centre = centre, found.at = x;
    }
    return ratio((diameter + e) / 2 * kUp, f * kDown - e);
  };
  search_gaps<D, 2>(points, segments, judge, bracket);
  return bracket;
}

template GapBracket<2> interior_gap(const SpacedPoints<2>&);
template GapBracket<3> interior_gap(const SpacedPoints<3>&);
template GapBracket<2> segment_gap(const SpacedPoints<2>&, std::span<const std::array<Index, 2>>);
template GapBracket<3> segment_gap(const SpacedPoints<3>&, std::span<const std::array<Index, 2>>);

}  // namespace wellspaced::audit
