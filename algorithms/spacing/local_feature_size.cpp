#include "wellspaced/algorithms/spacing/local_feature_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "wellspaced/algorithms/spacing/distance_queue.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {
namespace {

constexpr std::size_t kFeaturesInLeaf = 4;
constexpr double kInfiniteSize = std::numeric_limits<double>::infinity();

bool is_one_vertex(const LocalFeatureSize::Feature& f) { return f[0] == f[1]; }

bool are_incident(const LocalFeatureSize::Feature& f, const LocalFeatureSize::Feature& g) {
  return f[0] == g[0] || f[0] == g[1] || f[1] == g[0] || f[1] == g[1];
}

// Features met so far, pairwise incident. They share a vertex or are the sides of a triangle;
// either way a further one touches them all if it touches the first three.
class IncidentFeatures {
 public:
  // Returns false for a feature that is apart from one of the others.
  bool add(const LocalFeatureSize::Feature& feature) {
    for (std::size_t i = 0; i < size_; ++i)
      if (!are_incident(first_[i], feature)) return false;
    if (size_ < first_.size()) first_[size_++] = feature;
    return true;
  }

 private:
  std::array<LocalFeatureSize::Feature, 3> first_;
  std::size_t size_ = 0;
};

double square(double x) { return x * x; }

double distance_sq_to_box(const Box2& box, Point2 x) {
  return square(x.x - std::clamp(x.x, box.low.x, box.high.x)) +
         square(x.y - std::clamp(x.y, box.low.y, box.high.y));
}

// The features nearest to a place, by distance, up to the first that is apart from one before it:
// how far that one is, is the local feature size.
//
// More than a few that touch each other share a vertex, and any other feature touches two of them
// at most; so the nearest of them will do.
class NearestFeatures {
 public:
  NearestFeatures(const std::vector<LocalFeatureSize::Feature>& features, double bound_sq)
      : features_(features), bound_sq_(bound_sq) {}

  // Features this far away, squared, no longer matter.
  double bound_sq() const { return bound_sq_; }
  // The two that are apart; kNoIndex if none were met.
  const std::array<Index, 2>& apart() const { return apart_; }

  // Requires: nearer than the bound.
  void add(Index feature, double distance_sq) {
    std::size_t at = size_++;
    for (; at > 0 && first_[at - 1].distance_sq > distance_sq; --at) first_[at] = first_[at - 1];
    first_[at] = {distance_sq, feature};
    for (std::size_t i = 0; i < size_; ++i) {
      if (are_incident(features_[first_[i].feature], features_[feature])) continue;
      apart_ = {first_[i].feature, feature};
      size_ = std::max(i, at) + 1;
      bound_sq_ = first_[size_ - 1].distance_sq;
      break;
    }
    size_ = std::min(size_, kMost);
  }

 private:
  struct Met {
    double distance_sq;
    Index feature;
  };

  const std::vector<LocalFeatureSize::Feature>& features_;
  static constexpr std::size_t kMost = 8;
  std::array<Met, kMost + 1> first_;
  std::size_t size_ = 0;
  double bound_sq_;
  std::array<Index, 2> apart_{kNoIndex, kNoIndex};
};

}  // namespace

// ---- Features and their tree ---------------------------------------------------------------

Result<LocalFeatureSize> LocalFeatureSize::build(const Pslg& graph,
                                                 const TriangulateOptions& options) {
  Result<PlanarTriangulation> closed = triangulate(graph, options);
  if (!closed) return closed.error();
  const std::vector<Point2>& points = closed->delaunay.points();
  if (!points.empty()) {
    const Box2 box = Box2::around(points);
    if (!std::isfinite(2 * distance(box.low, box.high)))
      return Error{ErrorCode::kInvalidGeometry, "the extent of the graph is no double", {}};
  }
  return LocalFeatureSize(std::move(*closed));
}

LocalFeatureSize::LocalFeatureSize(PlanarTriangulation graph) : graph_(std::move(graph)) {
  for (Index v = 0; v < graph_.delaunay.points().size(); ++v)
    if (graph_.delaunay.is_vertex(v)) features_.push_back({v, v});
  for (const Segment& s : graph_.segments) features_.push_back({s.a, s.b});
  if (features_.empty()) return;
  const Box2 box = Box2::around(graph_.delaunay.points());
  const double extent = distance(box.low, box.high);
  if (extent > 0) scale_ = std::ldexp(1, std::clamp(-std::ilogb(extent), -1000, 1000));
  std::size_t leaves = 1;
  while (leaves * kFeaturesInLeaf < features_.size()) leaves *= 2;
  around_.resize(2 * leaves - 1);
  build_tree(0, 0, features_.size());
  measure_features();
}

void LocalFeatureSize::measure_features() {
  for (const Feature& feature : features_) {
    const Point2 a = scaled(point(feature[0])), b = scaled(point(feature[1]));
    const double length = distance(a, b);
    const Point2 unit = length > 0 ? Point2{(b.x - a.x) / length, (b.y - a.y) / length} : Point2{};
    stretches_.push_back({a, unit, length});
  }
}

// Recursion is as deep as the tree, log2 n.
void LocalFeatureSize::build_tree(std::size_t node, std::size_t first, std::size_t last) {
  const auto box_of = [this](const Feature& f) {
    return Box2::around(std::array{scaled(point(f[0])), scaled(point(f[1]))});
  };
  Box2 box = box_of(features_[first]);
  for (std::size_t i = first + 1; i < last; ++i) box.cover(box_of(features_[i]));
  around_[node] = box;
  if (last - first <= kFeaturesInLeaf) return;
  const bool wide = box.high.x - box.low.x > box.high.y - box.low.y;
  const auto middle_of = [&](const Feature& f) {
    const Point2 a = point(f[0]), b = point(f[1]);
    return wide ? a.x / 2 + b.x / 2 : a.y / 2 + b.y / 2;
  };
  const std::size_t middle = first + (last - first) / 2;
  const auto begin = features_.begin();
  std::nth_element(
      begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
      begin + static_cast<std::ptrdiff_t>(last), [&](const Feature& f, const Feature& g) {
        const double kf = middle_of(f), kg = middle_of(g);
        return kf < kg || (kf == kg && f < g);
      });
  build_tree(2 * node + 1, first, middle);
  build_tree(2 * node + 2, middle, last);
}

// How far from a the point nearest to x is.
double LocalFeatureSize::Stretch::nearest_to(Point2 x) const {
  return std::clamp((x.x - a.x) * unit.x + (x.y - a.y) * unit.y, 0.0, length);
}

double LocalFeatureSize::Stretch::distance_sq(Point2 x) const {
  const Point2 nearest = at(nearest_to(x));
  return square(x.x - nearest.x) + square(x.y - nearest.y);
}

// The point of the feature nearest to x, rounded; exact where it is a vertex.
Point2 LocalFeatureSize::nearest_point(std::size_t feature, Point2 x) const {
  const Stretch& stretch = stretches_[feature];
  const double along = stretch.nearest_to(scaled(x));
  if (along <= 0) return point(features_[feature][0]);
  if (along >= stretch.length) return point(features_[feature][1]);
  const Point2 p = stretch.at(along);
  return {p.x / scale_, p.y / scale_};
}

// Calls visit(number of a feature, distance) by increasing distance from x until it returns false.
template <class Visit>
void LocalFeatureSize::visit_by_distance(Point2 x, Visit visit) const {
  if (features_.empty()) return;
  DistanceQueue queue;
  const Point2 from = scaled(x);
  const auto push_node = [&](Index node, Index first, Index last) {
    queue.push({distance_sq_to_box(around_[node - 1], from), node, first, last});
  };
  push_node(1, 0, static_cast<Index>(features_.size()));
  while (!queue.empty()) {
    const auto [distance_sq, node, first, last] = queue.pop();
    if (node == 0) {
      if (!visit(first, std::sqrt(distance_sq) / scale_)) return;
    } else if (last - first <= kFeaturesInLeaf) {
      for (Index i = first; i < last; ++i) queue.push({stretches_[i].distance_sq(from), 0, i, i});
    } else {
      const Index middle = first + (last - first) / 2;
      push_node(2 * node, first, middle);
      push_node(2 * node + 1, middle, last);
    }
  }
}

double LocalFeatureSize::at(Point2 x, double bound) const {
  return std::min(bound, search(x, bound).size);
}

// The local feature size if it is below the bound, else something above it. The nearer half of each
// node of the tree comes first.
LocalFeatureSize::Answer LocalFeatureSize::search(Point2 x, double bound) const {
  const Point2 from = scaled(x);
  NearestFeatures nearest(features_, square(scale_ * bound));
  std::array<Pending, 64> stack;  // the tree is at most 28 deep
  std::size_t waiting = 0;
  const auto box_distance_sq = [&](Index node) {
    return distance_sq_to_box(around_[node - 1], from);
  };
  const auto push = [&](double distance_sq, Index node, Index first, Index last) {
    if (distance_sq < nearest.bound_sq()) stack[waiting++] = {distance_sq, node, first, last};
  };
  if (!features_.empty()) push(box_distance_sq(1), 1, 0, static_cast<Index>(features_.size()));
  while (waiting > 0) {
    const Pending& next = stack[--waiting];
    if (!(next.distance_sq < nearest.bound_sq())) continue;
    const Index node = next.node, first = next.first, last = next.last;
    if (last - first > kFeaturesInLeaf) {
      const Index middle = first + (last - first) / 2;
      const double low_sq = box_distance_sq(2 * node), high_sq = box_distance_sq(2 * node + 1);
      const bool is_low_nearer = low_sq <= high_sq;
      if (is_low_nearer) push(high_sq, 2 * node + 1, middle, last);
      push(low_sq, 2 * node, first, middle);
      if (!is_low_nearer) push(high_sq, 2 * node + 1, middle, last);
      continue;
    }
    for (Index i = first; i < last; ++i) {
      const double feature_sq = stretches_[i].distance_sq(from);
      if (feature_sq < nearest.bound_sq()) nearest.add(i, feature_sq);
    }
  }
  if (nearest.apart()[0] == kNoIndex) return {};
  return {std::sqrt(nearest.bound_sq()) / scale_, nearest.apart()};
}

// The two features of the last answer bound the next one.
double LocalFeatureSize::Cursor::at(Point2 x, double bound) {
  constexpr double kRounding = 1 + 1e-9;
  double expected = kInfiniteSize;
  if (last_[0] != kNoIndex) {
    const Point2 p = lfs_->scaled(x);
    const double farther = std::max(lfs_->stretches_[last_[0]].distance_sq(p),
                                    lfs_->stretches_[last_[1]].distance_sq(p));
    expected = std::sqrt(farther) / lfs_->scale_ * kRounding;
  }
  const Answer answer = lfs_->search(x, std::min(expected, bound));
  if (answer.features[0] != kNoIndex) last_ = answer.features;
  return std::min({answer.size, expected, bound});
}

// ---- Inside the domain ---------------------------------------------------------------------

// The shortest path from x to a feature is straight, or bends at vertices. The first bend v is a
// feature itself, met on the way; if the answer is not known by then, all features met so far end
// in v. From there any further vertex is apart from v; so the rest of the path is straight, too.
double LocalFeatureSize::geodesic_at(Point2 x) const {
  double result = kInfiniteSize;
  IncidentFeatures met;
  std::vector<Index> around;
  bool is_located = false;
  visit_by_distance(x, [&](Index number, double distance) {
    const Feature& feature = features_[number];
    if (graph_.delaunay.dimension() < 2) return false;
    if (!is_located) around = triangles_around(x, feature[0]);
    is_located = true;
    if (around.empty() || distance >= result) return false;
    if (!sees(x, around, number)) return true;
    if (!met.add(feature)) {
      result = distance;
      return false;
    }
    if (is_one_vertex(feature))
      result = std::min(result, distance + geodesic_from_vertex(feature[0]));
    return true;
  });
  return result;
}

// How far vertex v is from the nearest feature that does not end in it, inside the domain.
double LocalFeatureSize::geodesic_from_vertex(Index v) const {
  double result = kInfiniteSize;
  const std::vector<Index> around = triangles_around(point(v), v);
  visit_by_distance(point(v), [&](Index number, double distance) {
    const Feature& feature = features_[number];
    if (feature[0] == v || feature[1] == v || !sees(point(v), around, number)) return true;
    result = distance;
    return false;
  });
  return result;
}

// The triangles of the domain that contain x; `near` is a vertex from which to look for them.
std::vector<Index> LocalFeatureSize::triangles_around(Point2 x, Index near) const {
  const Delaunay2& delaunay = graph_.delaunay;
  const Triangulation2& topology = delaunay.topology();
  const auto [place, edge] = delaunay.locate(x, delaunay.edge_from(near).triangle);
  std::vector<Index> around;
  const auto add = [&](Index t) {
    if (graph_.in_domain[t]) around.push_back(t);
  };
  if (place != Delaunay2::Place::kOutside) add(edge.triangle);
  if (place == Delaunay2::Place::kEdge) add(topology.mirror(edge).triangle);
  if (place == Delaunay2::Place::kVertex)
    for (Edge e = topology.next_around_origin(edge); e != edge; e = topology.next_around_origin(e))
      add(e.triangle);
  return around;
}

// Whether the straight path from x, in the triangles `around`, to the feature's nearest point stays
// in the domain.
bool LocalFeatureSize::sees(Point2 x, const std::vector<Index>& around, std::size_t feature) const {
  const Point2 target = nearest_point(feature, x);
  return any_of(around, [&](Index t) { return reaches(x, t, target, features_[feature]); });
}

// The same by way of the first triangle. The walk ends at `target`, which may lie beside the
// feature by a rounding error, or at the first vertex or segment that it meets.
bool LocalFeatureSize::reaches(Point2 x, Index triangle, Point2 target,
                               const Feature& feature) const {
  const Triangulation2& topology = graph_.delaunay.topology();
  Index t = triangle;
  for (Index step = 0; step < topology.size(); ++step) {
    Edge exit;
    bool is_inside = true;
    for (unsigned i = 0; i < 3; ++i) {
      const Edge e{t, i};
      const Point2 a = point(topology.origin(e)), b = point(topology.destination(e));
      if (orient2d(a, b, target) >= 0) continue;
      is_inside = false;
      if (orient2d(a, b, x) <= 0) continue;
      const int left = orient2d(x, target, b), right = -orient2d(x, target, a);
      if (left < 0 || right < 0) continue;
      if (left == 0)
        return are_incident(feature, {topology.destination(e), topology.destination(e)});
      if (right == 0) return are_incident(feature, {topology.origin(e), topology.origin(e)});
      exit = e;
    }
    if (is_inside) return true;
    if (exit.triangle == kNoIndex) return false;
    if (topology.is_constrained(exit))
      return std::ranges::is_permutation(
          feature, Feature{topology.origin(exit), topology.destination(exit)});
    t = topology.neighbor(t, exit.i);
    if (topology.is_ghost(t)) return false;
  }
  return false;
}

}  // namespace wellspaced
