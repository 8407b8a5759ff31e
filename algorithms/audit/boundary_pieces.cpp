#include "wellspaced/algorithms/audit/boundary_pieces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "wellspaced/algorithms/audit/contact.hpp"
#include "wellspaced/algorithms/audit/rounding_box.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

constexpr double kStraight = 2;       // units in the last place
constexpr double kGrazing = 0x1p-20;  // a way so near to the boundary, by its length, is along it

// ---- A ray from x along the first axis, against one simplex

enum class Hit { kMissed, kCrossed, kStartsOn };

// Ends at the height of the ray count as below it.
Hit ray_hits(const Vec<2>& x, const std::array<Vec<2>, 2>& segment) {
  const Vec<2>&a = segment[0], &b = segment[1];
  const int side = orient2d(point_at(a), point_at(b), point_at(x));
  const auto in = [&](std::size_t i) {
    return std::min(a[i], b[i]) <= x[i] && x[i] <= std::max(a[i], b[i]);
  };
  if (side == 0 && in(0) && in(1)) return Hit::kStartsOn;
  const bool a_above = a[1] > x[1], b_above = b[1] > x[1];
  if (a_above == b_above) return Hit::kMissed;
  return (b_above ? side > 0 : side < 0) ? Hit::kCrossed : Hit::kMissed;
}

// The side of the edge from a to b, seen along the first axis, of x displaced by e along the second
// axis and by much less along the third: never 0 unless a and b look the same.
int displaced_side(const Vec<3>& a, const Vec<3>& b, const Vec<3>& x) {
  const int side = orient2d(Point2{a[1], a[2]}, Point2{b[1], b[2]}, Point2{x[1], x[2]});
  if (side != 0) return side;
  if (a[2] != b[2]) return a[2] > b[2] ? 1 : -1;
  return a[1] == b[1] ? 0 : (b[1] > a[1] ? 1 : -1);
}

bool lies_in_triangle(const Vec<3>& x, const std::array<Vec<3>, 3>& t) {
  const Point3 p = point_at(x), up{p.x, p.y, moved(p.z, ulp(p.z))};
  return segment_meets_triangle(p, up, {point_at(t[0]), point_at(t[1]), point_at(t[2])});
}

Hit ray_hits(const Vec<3>& x, const std::array<Vec<3>, 3>& t) {
  const int above = orient3d(point_at(t[0]), point_at(t[1]), point_at(t[2]), point_at(x));
  if (above == 0 && lies_in_triangle(x, t)) return Hit::kStartsOn;
  const int side = displaced_side(t[0], t[1], x);
  if (side == 0 || displaced_side(t[1], t[2], x) != side || displaced_side(t[2], t[0], x) != side)
    return Hit::kMissed;
  return above == side ? Hit::kCrossed : Hit::kMissed;
}

// ---- A segment against one simplex

bool segments_touch(Point2 p, Point2 q, Point2 a, Point2 b) {
  const int at_a = orient2d(p, q, a), at_b = orient2d(p, q, b);
  if (at_a * at_b > 0 || orient2d(a, b, p) * orient2d(a, b, q) > 0) return false;
  if (at_a != 0 || at_b != 0) return true;
  return touch(box_of(p, q), box_of(a, b));  // all on one line
}

bool touches(const Vec<2>& a, const Vec<2>& b, const std::array<Vec<2>, 2>& segment) {
  return segments_touch(point_at(a), point_at(b), point_at(segment[0]), point_at(segment[1]));
}

bool touches(const Vec<3>& a, const Vec<3>& b, const std::array<Vec<3>, 3>& t) {
  return segment_meets_triangle(point_at(a), point_at(b),
                                {point_at(t[0]), point_at(t[1]), point_at(t[2])});
}

// ---- Which simplices continue each other

// What two simplices have in common if they are neighbours: a node, or an edge.
std::array<Index, 1> common_part(const std::array<Index, 2>& nodes, std::size_t i) {
  return {nodes[i]};
}
std::array<Index, 2> common_part(const std::array<Index, 3>& nodes, std::size_t i) {
  const Index a = nodes[(i + 1) % 3], b = nodes[(i + 2) % 3];
  return {std::min(a, b), std::max(a, b)};
}

// The corner that is not part of what they share.
Index far_corner(const std::array<Index, 2>& nodes, std::size_t i) { return nodes[1 - i]; }
Index far_corner(const std::array<Index, 3>& nodes, std::size_t i) { return nodes[i]; }

// Whether the nodes p and q beyond the common part lie straight on from each other.
bool is_straight(std::span<const Vec<2>> places, std::array<Index, 1> common, Index p, Index q) {
  const Vec<2>&a = places[p], &m = places[common[0]], &b = places[q];
  return product(difference(a, m), difference(b, m)) < 0 &&
         passes_near(point_at(a), point_at(b), point_at(m), kStraight);
}

bool is_straight(std::span<const Vec<3>> places, std::array<Index, 2> common, Index p, Index q) {
  const Point3 a = point_at(places[common[0]]), b = point_at(places[common[1]]);
  const Point3 c = point_at(places[p]), d = point_at(places[q]);
  const Vec<3> along = difference(places[common[1]], places[common[0]]);
  const Vec<3> to_c = cross_product(along, difference(places[p], places[common[0]]));
  const Vec<3> to_d = cross_product(along, difference(places[q], places[common[0]]));
  return product(to_c, to_d) < 0 && vanishes_near(d, rounding_box(a, c, kStraight),
                                                  [&](Point3 x) { return orient3d(a, b, c, x); });
}

template <std::size_t D>
PlaceOnBoundary<D> nearest_on_edge(const Vec<D>& x, const Vec<D>& a, const Vec<D>& b) {
  const Vec<D> along = difference(b, a);
  const double length_sq = product(along, along);
  const double t = length_sq > 0 ? product(difference(x, a), along) / length_sq : 0;
  const Vec<D> place = step(a, std::clamp(t, 0.0, 1.0), along);
  return {place, distance_of(x, place)};
}

}  // namespace

PlaceOnBoundary<2> nearest_place(const Vec<2>& x, const std::array<Vec<2>, 2>& segment) {
  return nearest_on_edge(x, segment[0], segment[1]);
}

PlaceOnBoundary<3> nearest_place(const Vec<3>& x, const std::array<Vec<3>, 3>& t) {
  const Vec<3> u = difference(t[1], t[0]), v = difference(t[2], t[0]), w = difference(x, t[0]);
  const Vec<3> n = cross_product(u, v);
  const double nn = product(n, n);
  const double at_u = product(cross_product(w, v), n), at_v = product(cross_product(u, w), n);
  if (nn > 0 && at_u >= 0 && at_v >= 0 && at_u + at_v <= nn)
    return {step(x, -product(w, n) / nn, n), std::fabs(product(w, n)) / std::sqrt(nn)};
  return std::min({nearest_on_edge(x, t[0], t[1]), nearest_on_edge(x, t[1], t[2]),
                   nearest_on_edge(x, t[2], t[0])},
                  [](const auto& a, const auto& b) { return a.distance < b.distance; });
}

Vec<2> unit_normal(const std::array<Vec<2>, 2>& segment) {
  const Vec<2> along = difference(segment[1], segment[0]);
  return step(Vec<2>{}, 1 / norm(along), {-along[1], along[0]});
}

Vec<3> unit_normal(const std::array<Vec<3>, 3>& t) {
  const Vec<3> n = cross_product(difference(t[1], t[0]), difference(t[2], t[0]));
  return step(Vec<3>{}, 1 / norm(n), n);
}

template <std::size_t D>
BoundaryPieces<D>::BoundaryPieces(std::span<const Vec<D>> places,
                                  std::vector<BoundarySimplex<D>> simplices)
    : places_(places), simplices_(std::move(simplices)), tree_([&] {
        for (Index s = 0; s < simplices_.size(); ++s) {
          const auto c = corners(s);
          Box<static_cast<int>(D)> box{c[0], c[0]};
          for (const auto& corner : c) box.grow({corner, corner});
          boxes_.push_back(box);
        }
        return BoxTree<static_cast<int>(D)>(boxes_);
      }()) {
  join_straight_ones();
  list_pieces_of_nodes();
}

template <std::size_t D>
std::array<Vec<D>, D> BoundaryPieces<D>::corners(Index s) const {
  std::array<Vec<D>, D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = places_[simplices_[s].nodes[i]];
  return result;
}

template <std::size_t D>
std::optional<Vec<D>> BoundaryPieces<D>::inward_normal(Index s) const {
  if (!simplices_[s].closed) return std::nullopt;
  const Vec<D> normal = unit_normal(corners(s));
  const Vec<D> inwards = difference(places_[simplices_[s].inner], places_[nodes(s)[0]]);
  const double side = product(normal, inwards);
  if (!(std::fabs(side) > 0x1p-40 * norm(inwards))) return std::nullopt;
  return step(Vec<D>{}, side < 0 ? -1 : 1, normal);
}

template <std::size_t D>
void BoundaryPieces<D>::join_straight_ones() {
  piece_.resize(simplices_.size());
  std::iota(piece_.begin(), piece_.end(), Index{0});
  const auto root = [&](Index s) {
    while (piece_[s] != s) s = piece_[s] = piece_[piece_[s]];
    return s;
  };
  struct Side {
    std::array<Index, D - 1> common;
    Index simplex, far;
    bool operator<(const Side& other) const {
      return common != other.common ? common < other.common : simplex < other.simplex;
    }
  };
  std::vector<Side> sides;
  for (Index s = 0; s < simplices_.size(); ++s)
    for (std::size_t i = 0; i < D; ++i)
      sides.push_back({common_part(nodes(s), i), s, far_corner(nodes(s), i)});
  sort(sides);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].common == sides[i].common) ++end;
    if (end - i != 2) continue;
    const Side &a = sides[i], &b = sides[i + 1];
    if (!is_straight(places_, a.common, a.far, b.far)) continue;
    const Index p = root(a.simplex), q = root(b.simplex);
    piece_[std::max(p, q)] = std::min(p, q);
  }
  for (Index s = 0; s < piece_.size(); ++s) piece_[s] = root(s);
}

template <std::size_t D>
void BoundaryPieces<D>::list_pieces_of_nodes() {
  for (Index s = 0; s < simplices_.size(); ++s)
    for (const Index v : nodes(s)) node_pieces_.push_back({v, piece_[s]});
  sort_unique(node_pieces_);
}

template <std::size_t D>
bool BoundaryPieces<D>::lies_on(Index v, Index piece) const {
  return std::binary_search(node_pieces_.begin(), node_pieces_.end(), std::array{v, piece});
}

template <std::size_t D>
bool BoundaryPieces<D>::contains(const Vec<D>& x) const {
  bool inside = false, on_boundary = false;
  tree_.search(
      [&](const Box<static_cast<int>(D)>& box) {
        for (std::size_t i = 1; i < D; ++i)
          if (x[i] < box.low[i] || box.high[i] < x[i]) return false;
        return x[0] <= box.high[0];
      },
      [&](Index s) {
        if (!simplices_[s].closed) return true;
        const Hit hit = ray_hits(x, corners(s));
        on_boundary = hit == Hit::kStartsOn;
        inside = inside != (hit == Hit::kCrossed);
        return !on_boundary;
      });
  return inside || on_boundary;
}

template <std::size_t D>
bool BoundaryPieces<D>::leaves_clear(const Vec<D>& a, const Vec<D>& b) const {
  Box<static_cast<int>(D)> around{a, a};
  around.grow({b, b});
  bool clear = true;
  tree_.search([&](const auto& box) { return touch(box, around); },
               [&](Index s) {
                 if (touch(boxes_[s], around)) clear = !touches(a, b, corners(s));
                 return clear;
               });
  return clear;
}

template <std::size_t D>
bool BoundaryPieces<D>::comes_near(const Vec<D>& x, double distance) const {
  Box<static_cast<int>(D)> around{x, x};
  for (std::size_t i = 0; i < D; ++i) around.low[i] -= distance, around.high[i] += distance;
  bool near = false;
  tree_.search([&](const auto& box) { return touch(box, around); },
               [&](Index s) {
                 near = nearest_place(x, corners(s)).distance <= distance;
                 return !near;
               });
  return near;
}

template <std::size_t D>
bool BoundaryPieces<D>::starts_inside(const Vec<D>& x, const PlaceOnBoundary<D>& place) const {
  const Vec<D> middle = step(x, 0.5, difference(place.place, x));
  return contains(middle) || comes_near(middle, place.distance * kGrazing);
}

template <std::size_t D>
PlaceOnBoundary<D> BoundaryPieces<D>::nearest_elsewhere(Index v, double bound) const {
  const Vec<D>& x = places_[v];
  PlaceOnBoundary<D> nearest{x, bound};
  tree_.search(
      [&](const Box<static_cast<int>(D)>& box) {
        for (std::size_t i = 0; i < D; ++i)
          if (x[i] + nearest.distance < box.low[i] || box.high[i] < x[i] - nearest.distance)
            return false;
        return true;
      },
      [&](Index s) {
        const auto found = nearest_place(x, corners(s));
        if (found.distance < nearest.distance && !lies_on(v, piece_[s]) && starts_inside(x, found))
          nearest = found;
        return true;
      });
  return nearest;
}

template class BoundaryPieces<2>;
template class BoundaryPieces<3>;

}  // namespace wellspaced::audit
