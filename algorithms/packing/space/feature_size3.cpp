#include "wellspaced/algorithms/packing/space/feature_size3.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "wellspaced/algorithms/spacing/distance_queue.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

constexpr std::size_t kItemsInLeaf = 4;
constexpr double kNoSize = std::numeric_limits<double>::infinity();

double length_sq(Point3 a) { return dot(a, a); }

double distance_sq_to_stretch(Point3 ax, Point3 ab) {
  const double whole = length_sq(ab);
  const double t = whole > 0 ? std::clamp(dot(ax, ab) / whole, 0.0, 1.0) : 0;
  return length_sq(ax - t * ab);
}

bool contains_index(const std::vector<Index>& ascending, Index v) {
  return std::binary_search(ascending.begin(), ascending.end(), v);
}

}  // namespace

// ---- Shapes --------------------------------------------------------------------------------

// For a triangle: over the region of the plane in which x lies, its face, an edge or a corner.
double FeatureSize3::Shape::distance_sq(Point3 x) const {
  const Point3 ax = x - a;
  if (dimension == 0) return length_sq(ax);
  if (dimension == 1) return distance_sq_to_stretch(ax, ab);
  const double bb = length_sq(ab), bc = dot(ab, ac), cc = length_sq(ac);
  const double xb = dot(ax, ab), xc = dot(ax, ac);
  const double v = cc * xb - bc * xc, w = bb * xc - bc * xb, whole = bb * cc - bc * bc;
  if (v >= 0 && w >= 0 && v + w <= whole && whole > 0) {
    const Point3 normal = cross(ab, ac);
    const double height = dot(ax, normal);
    return height * height / length_sq(normal);
  }
  return std::min({distance_sq_to_stretch(ax, ab), distance_sq_to_stretch(ax, ac),
                   distance_sq_to_stretch(ax - ab, ac - ab)});
}

static double distance_sq_to_box(const Box3& box, Point3 x) {
  const auto beyond = [](double at, double from, double to) {
    const double d = at - std::clamp(at, from, to);
    return d * d;
  };
  const auto& [low, high] = box;
  return beyond(x.x, low.x, high.x) + beyond(x.y, low.y, high.y) + beyond(x.z, low.z, high.z);
}

FeatureSize3::Shape FeatureSize3::shape_of(const Item& item) const {
  const Point3 a = complex_->points[item.corners[0]], b = complex_->points[item.corners[1]],
               c = complex_->points[item.corners[2]];
  return {item.feature.dimension, a, b - a, c - a};
}

Box3 FeatureSize3::box_of(const Item& item) const {
  const auto& points = complex_->points;
  const auto& [a, b, c] = item.corners;
  return Box3::around(std::array{points[a], points[b], points[c]});
}

// ---- The tree ------------------------------------------------------------------------------

FeatureSize3::FeatureSize3(const PolyhedralComplex& complex, const Progress& progress)
    : complex_(&complex) {
  for (Index v = 0; v < complex.points.size(); ++v)
    if (complex.is_vertex[v]) items_.push_back({{0, v}, {v, v, v}});
  for (Index s = 0; s < complex.segments.size(); ++s)
    items_.push_back(
        {{1, s}, {complex.segments[s].a, complex.segments[s].b, complex.segments[s].b}});
  std::vector<std::vector<Index>> facets_at(complex.points.size());
  for (Index f = 0; f < complex.facets.size(); ++f) {
    for (const auto& triangle : complex.facets[f].triangles) items_.push_back({{2, f}, triangle});
    for (const Index v : complex.facets[f].points) facets_at[v].push_back(f);
  }
  for (const PolyhedralComplex::Facet& facet : complex.facets) {
    std::vector<Index>& touching = touching_facets_.emplace_back();
    for (const Index v : facet.points)
      touching.insert(touching.end(), facets_at[v].begin(), facets_at[v].end());
    sort_unique(touching);
  }
  if (items_.empty()) return;
  std::size_t leaves = 1, levels = 1;
  for (; leaves * kItemsInLeaf < items_.size(); ++levels) leaves *= 2;
  around_.resize(2 * leaves - 1);
  ProgressMeter meter(progress, "sort", levels * items_.size());
  build_tree(0, 0, items_.size(), meter);
  for (const Item& item : items_) shapes_.push_back(shape_of(item));
}

// Recursion is as deep as the tree, log2 n.
void FeatureSize3::build_tree(std::size_t node, std::size_t first, std::size_t last,
                              ProgressMeter& meter) {
  if (!meter.step(last - first)) return;
  Box3 box = box_of(items_[first]);
  for (std::size_t i = first + 1; i < last; ++i) box.cover(box_of(items_[i]));
  around_[node] = box;
  if (last - first <= kItemsInLeaf) return;
  const Point3 size = box.size();
  const auto along = [&](Point3 p) {
    return size.x >= std::max(size.y, size.z) ? p.x : size.y >= size.z ? p.y : p.z;
  };
  const auto key = [&](const Item& item) {
    const Box3 own = box_of(item);
    return std::tuple(along(own.low) / 2 + along(own.high) / 2, item.feature.dimension,
                      item.feature.number, item.corners);
  };
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last),
                   [&](const Item& x, const Item& y) { return key(x) < key(y); });
  build_tree(2 * node + 1, first, middle, meter);
  build_tree(2 * node + 2, middle, last, meter);
}

// Calls visit(number of an item, distance squared) by increasing distance until it returns false.
template <class Visit>
void FeatureSize3::visit_by_distance(Point3 x, Visit visit) const {
  if (items_.empty()) return;
  DistanceQueue queue;
  const auto push_node = [&](Index node, Index first, Index last) {
    queue.push({distance_sq_to_box(around_[node - 1], x), node, first, last});
  };
  push_node(1, 0, static_cast<Index>(items_.size()));
  while (!queue.empty()) {
    const auto [distance_sq, node, first, last] = queue.pop();
    if (node == 0) {
      if (!visit(first, distance_sq)) return;
    } else if (last - first <= kItemsInLeaf) {
      for (Index i = first; i < last; ++i) queue.push({shapes_[i].distance_sq(x), 0, i, i});
    } else {
      const Index middle = first + (last - first) / 2;
      push_node(2 * node, first, middle);
      push_node(2 * node + 1, middle, last);
    }
  }
}

// ---- What touches what ---------------------------------------------------------------------

bool FeatureSize3::touch(const Item& x, const Item& y) const {
  if (x.feature.dimension == 2)
    return y.feature.dimension == 2 ? facets_touch(x, y) : touches_facet(y, x);
  if (y.feature.dimension == 2) return touches_facet(x, y);
  const auto& [a, b, unused] = x.corners;
  return a == y.corners[0] || a == y.corners[1] || b == y.corners[0] || b == y.corners[1];
}

// Whether a vertex or segment touches a facet, or the triangle of one that is not convex.
bool FeatureSize3::touches_facet(const Item& x, const Item& facet) const {
  const PolyhedralComplex::Facet& whole = complex_->facets[facet.feature.number];
  const auto& [a, b, unused] = x.corners;
  if (whole.is_convex) return contains_index(whole.points, a) || contains_index(whole.points, b);
  if (x.feature.dimension == 0) return contains_index(whole.points, a);
  if (contains_index(whole.segments, x.feature.number)) return true;
  const auto is_end = [&](Index v) { return v == x.corners[0] || v == x.corners[1]; };
  return any_of(facet.corners, is_end);
}

bool FeatureSize3::facets_touch(const Item& x, const Item& y) const {
  const Index f = x.feature.number, g = y.feature.number;
  if (f == g) return true;
  if (!contains_index(touching_facets_[f], g)) return false;
  const PolyhedralComplex::Facet &first = complex_->facets[f], &second = complex_->facets[g];
  const auto any_in = [](const Item& item, const auto& points) {
    return any_of(item.corners, [&](Index v) { return is_among(v, points); });
  };
  if (first.is_convex && second.is_convex) return true;
  if (first.is_convex) return any_in(y, first.points);
  if (second.is_convex) return any_in(x, second.points);
  return any_in(x, y.corners);
}

// Items met so far, which all touch each other.
class FeatureSize3::Touching {
 public:
  explicit Touching(const FeatureSize3& size) : size_(size) { met_.reserve(32); }

  // Returns false for an item that is apart from one of the others.
  bool add(Index number) {
    const Item& item = size_.items_[number];
    for (const Index other : met_)
      if (!size_.touch(size_.items_[other], item)) return false;
    met_.push_back(number);
    return true;
  }

 private:
  const FeatureSize3& size_;
  std::vector<Index> met_;
};

double FeatureSize3::at(Point3 x) const {
  double result = kNoSize;
  Touching met(*this);
  visit_by_distance(x, [&](Index number, double distance_sq) {
    if (met.add(number)) return true;
    result = std::sqrt(distance_sq);
    return false;
  });
  return result;
}

// ---- From near by --------------------------------------------------------------------------

// With s = lfs(centre), what matters at x lies within lfs(x) <= s + |x - centre| of x, so within
// s + 2 |x - centre| of the centre: within 2.2 s, for x up to 0.6 s away.
void FeatureSize3::Cursor::explore(Point3 x, Place& place) const {
  constexpr double kRemembered = 2.3, kExplored = 0.6;
  const double size = size_->at(x);
  place.centre = x;
  place.size = size;
  place.reach_sq = kExplored * kExplored * size * size;
  place.items.clear();
  size_->visit_by_distance(x, [&](Index number, double distance_sq) {
    if (distance_sq > kRemembered * kRemembered * size * size) return false;
    place.items.push_back(number);
    return true;
  });
}

// The place that x is near to, a new one instead of the longest unused if there is none; brought to
// the front.
const FeatureSize3::Cursor::Place& FeatureSize3::Cursor::place_of(Point3 x) {
  constexpr std::size_t kPlaces = 32;
  auto found = std::find_if(places_.begin(), places_.end(), [x](const Place& place) {
    return length_sq(x - place.centre) <= place.reach_sq;
  });
  if (found == places_.end()) {
    if (places_.size() < kPlaces) places_.emplace_back();
    found = places_.end() - 1;
    explore(x, *found);
  }
  std::rotate(places_.begin(), found, found + 1);
  return places_.front();
}

double FeatureSize3::Cursor::at(Point3 x) { return at_near(place_of(x), x); }

double FeatureSize3::Cursor::capped(Point3 x, double cap) {
  const Place& place = place_of(x);
  const double room = place.size - cap;
  if (room > 0 && length_sq(x - place.centre) <= room * room) return cap;
  return std::min(cap, at_near(place, x));
}

double FeatureSize3::Cursor::at_near(const Place& place, Point3 x) const {
  constexpr std::size_t kMany = 80;  // so many that the tree is as good
  const std::size_t count = place.items.size();
  if (count > kMany || !(place.reach_sq < kNoSize)) return size_->at(x);
  std::array<std::pair<double, Index>, kMany> by_distance;
  for (std::size_t i = 0; i < count; ++i)
    by_distance[i] = {size_->shapes_[place.items[i]].distance_sq(x), place.items[i]};
  sort(std::span(by_distance).first(count));
  Touching met(*size_);
  for (std::size_t i = 0; i < count; ++i)
    if (!met.add(by_distance[i].second)) return std::sqrt(by_distance[i].first);
  return size_->at(x);  // not reached but for rounding
}

// ---- Contacts ------------------------------------------------------------------------------

// Calls visit(number of an item) for those whose leaf comes within a distance of the box, until it
// returns false.
template <class Visit>
void FeatureSize3::visit_near(const Box3& box, double within, Visit visit) const {
  struct Range {
    std::size_t node, first, last;
  };
  std::vector<Range> stack{{0, 0, items_.size()}};
  while (!stack.empty()) {
    const auto [node, first, last] = stack.back();
    stack.pop_back();
    const auto& [low, high] = around_[node];
    if (low.x - within > box.high.x || box.low.x - within > high.x || low.y - within > box.high.y ||
        box.low.y - within > high.y || low.z - within > box.high.z || box.low.z - within > high.z)
      continue;
    if (last - first <= kItemsInLeaf) {
      for (std::size_t i = first; i < last; ++i)
        if (!visit(static_cast<Index>(i))) return;
      continue;
    }
    const std::size_t middle = first + (last - first) / 2;
    stack.push_back({2 * node + 2, middle, last});
    stack.push_back({2 * node + 1, first, middle});
  }
}

// The distance of two stretches, by the nearest points of their lines if those are on both.
static double distance_sq_of_stretches(Point3 a, Point3 ab, Point3 c, Point3 cd) {
  double best =
      std::min({distance_sq_to_stretch(c - a, ab), distance_sq_to_stretch(c + cd - a, ab),
                distance_sq_to_stretch(a - c, cd), distance_sq_to_stretch(a + ab - c, cd)});
  const Point3 normal = cross(ab, cd), ac = c - a;
  const double square = length_sq(normal);
  if (!(square > 0)) return best;
  const double s = dot(cross(ac, cd), normal), t = dot(cross(ac, ab), normal);
  if (0 <= s && s <= square && 0 <= t && t <= square) {
    const double height = dot(ac, normal);
    best = std::min(best, height * height / square);
  }
  return best;
}

// x is a vertex or a segment, y anything.
double FeatureSize3::distance_between(const Item& x, const Item& y) const {
  const Shape p = shape_of(x), q = shape_of(y);
  if (p.dimension == 0) return std::sqrt(q.distance_sq(p.a));
  if (q.dimension == 0) return std::sqrt(p.distance_sq(q.a));
  if (q.dimension == 1) return std::sqrt(distance_sq_of_stretches(p.a, p.ab, q.a, q.ab));
  const Point3 normal = cross(q.ab, q.ac);
  const double from = dot(p.a - q.a, normal), to = dot(p.a + p.ab - q.a, normal);
  if ((from < 0) != (to < 0)) {
    const Point3 through = p.a + (from / (from - to)) * p.ab;
    if (q.distance_sq(through) <= 0x1p-80 * length_sq(p.ab)) return 0;
  }
  return std::sqrt(std::min({q.distance_sq(p.a), q.distance_sq(p.a + p.ab),
                             distance_sq_of_stretches(p.a, p.ab, q.a, q.ab),
                             distance_sq_of_stretches(p.a, p.ab, q.a, q.ac),
                             distance_sq_of_stretches(p.a, p.ab, q.a + q.ab, q.ac - q.ab)}));
}

std::vector<FeatureSize3::Contact> FeatureSize3::contacts(double within, std::size_t most,
                                                          const Progress& progress) const {
  constexpr std::uint64_t kItemsAQuestion = 1024;
  std::vector<Contact> found;
  ProgressMeter meter(progress, "contacts", items_.size(), kItemsAQuestion);
  for (std::size_t i = 0; i < items_.size() && found.size() < most && meter.step(); ++i) {
    if (items_[i].feature.dimension == 2) continue;
    visit_near(box_of(items_[i]), within, [&](Index j) {
      const Item &x = items_[i], &y = items_[j];
      const bool is_told = y.feature.dimension < 2 && j <= i;
      if (is_told || touch(x, y) || distance_between(x, y) > within) return true;
      if (!found.empty() && found.back().a == x.feature && found.back().b == y.feature) return true;
      found.push_back({x.feature, y.feature});
      return found.size() < most;
    });
  }
  return found;
}

}  // namespace wellspaced
