#include "wellspaced/algorithms/spacing/local_feature_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"

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

// What the search has before it: a node of the tree with its features, or one feature (node 0 is
// never a child).
struct Pending {
  double distance;
  std::size_t node, first, last;
};

bool is_farther(const Pending& a, const Pending& b) {
  return a.distance > b.distance || (a.distance == b.distance && a.first > b.first);
}

}  // namespace

// ---- Features and their tree ---------------------------------------------------------------

Result<LocalFeatureSize> LocalFeatureSize::build(const Pslg& graph,
                                                 const TriangulateOptions& options) {
  Result<PlanarTriangulation> closed = triangulate(graph, options);
  if (!closed) return closed.error();
  LocalFeatureSize result(std::move(*closed));
  if (!result.around_.empty()) {
    const Box2& box = result.around_[0];
    if (!std::isfinite(2 * distance(box.low, box.high)))
      return Error{ErrorCode::kInvalidGeometry, "the extent of the graph is no double", {}};
  }
  return result;
}

LocalFeatureSize::LocalFeatureSize(PlanarTriangulation graph) : graph_(std::move(graph)) {
  for (Index v = 0; v < graph_.delaunay.points().size(); ++v)
    if (graph_.delaunay.is_vertex(v)) features_.push_back({v, v});
  for (const Segment& s : graph_.segments) features_.push_back({s.a, s.b});
  if (features_.empty()) return;
  std::size_t leaves = 1;
  while (leaves * kFeaturesInLeaf < features_.size()) leaves *= 2;
  around_.resize(2 * leaves - 1);
  build_tree(0, 0, features_.size());
}

// Recursion is as deep as the tree, log2 n.
void LocalFeatureSize::build_tree(std::size_t node, std::size_t first, std::size_t last) {
  const auto box_of = [this](const Feature& f) {
    return Box2::around(std::array{point(f[0]), point(f[1])});
  };
  Box2 box = box_of(features_[first]);
  for (std::size_t i = first + 1; i < last; ++i) box.cover(box_of(features_[i]));
  around_[node] = box;
  if (last - first <= kFeaturesInLeaf) return;
  const bool wide = box.high.x / 2 - box.low.x / 2 > box.high.y / 2 - box.low.y / 2;
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

// The point of the feature nearest to x, rounded; exact where it is a vertex.
Point2 LocalFeatureSize::nearest_point(const Feature& feature, Point2 x) const {
  const Point2 a = point(feature[0]), b = point(feature[1]);
  const double length = distance(a, b);
  if (!(length > 0)) return a;
  const Point2 unit{(b.x - a.x) / length, (b.y - a.y) / length};
  const double along = (x.x - a.x) * unit.x + (x.y - a.y) * unit.y;
  if (along <= 0) return a;
  if (along >= length) return b;
  return {a.x + along * unit.x, a.y + along * unit.y};
}

double LocalFeatureSize::distance_to(const Feature& feature, Point2 x) const {
  return distance(nearest_point(feature, x), x);
}

// Calls visit(feature, distance) by increasing distance from x until it returns false.
template <class Visit>
void LocalFeatureSize::visit_by_distance(Point2 x, Visit visit) const {
  if (features_.empty()) return;
  std::vector<Pending> heap;
  heap.reserve(64);
  const auto push = [&](const Pending& pending) {
    heap.push_back(pending);
    std::push_heap(heap.begin(), heap.end(), is_farther);
  };
  const auto push_node = [&](std::size_t node, std::size_t first, std::size_t last) {
    push({distance_to_box(around_[node], x), node + 1, first, last});
  };
  push_node(0, 0, features_.size());
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), is_farther);
    const auto [distance, node, first, last] = heap.back();
    heap.pop_back();
    if (node == 0) {
      if (!visit(features_[first], distance)) return;
    } else if (last - first <= kFeaturesInLeaf) {
      for (std::size_t i = first; i < last; ++i) push({distance_to(features_[i], x), 0, i, i + 1});
    } else {
      const std::size_t middle = first + (last - first) / 2;
      push_node(2 * node - 1, first, middle);
      push_node(2 * node, middle, last);
    }
  }
}

double LocalFeatureSize::at(Point2 x) const {
  double result = kInfiniteSize;
  IncidentFeatures met;
  visit_by_distance(x, [&](const Feature& feature, double distance) {
    if (met.add(feature)) return true;
    result = distance;
    return false;
  });
  return result;
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
  visit_by_distance(x, [&](const Feature& feature, double distance) {
    if (graph_.delaunay.dimension() < 2) return false;
    if (!is_located) around = triangles_around(x, feature[0]);
    is_located = true;
    if (around.empty() || distance >= result) return false;
    if (!sees(x, around, feature)) return true;
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
  visit_by_distance(point(v), [&](const Feature& feature, double distance) {
    if (feature[0] == v || feature[1] == v || !sees(point(v), around, feature)) return true;
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
bool LocalFeatureSize::sees(Point2 x, const std::vector<Index>& around,
                            const Feature& feature) const {
  const Point2 target = nearest_point(feature, x);
  return std::any_of(around.begin(), around.end(),
                     [&](Index t) { return reaches(x, t, target, feature); });
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
