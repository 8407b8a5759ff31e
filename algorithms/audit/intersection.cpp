#include "wellspaced/algorithms/audit/intersection.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/local_order.hpp"
#include "wellspaced/algorithms/audit/triangle_overlap.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::audit {
namespace {

double longest_edge(const Corners& c) {
  return std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
}

// orient2d, which is slowest where it is 0: common nodes are told apart first.
int side(Point2 a, Point2 b, Point2 p) { return p == a || p == b ? 0 : orient2d(a, b, p); }

// The fine mesh, made ready for walking.
class FineMesh {
 public:
  explicit FineMesh(const TriangleMesh& mesh)
      : mesh_(mesh),
        half_edges_(pair_half_edges(mesh.triangles, {}, static_cast<Index>(mesh.points.size()))),
        leaving_(mesh.points.size(), kNoIndex) {
    for (Index h = static_cast<Index>(half_edges_.twin.size()); h-- > 0;) leaving_[from(h)] = h;
  }

  Index triangles() const { return static_cast<Index>(mesh_.triangles.size()); }
  Index nodes() const { return static_cast<Index>(mesh_.points.size()); }
  Point2 point(Index v) const { return mesh_.points[v]; }
  Index from(Index h) const { return origin(mesh_.triangles, h); }
  Index to(Index h) const { return target(mesh_.triangles, h); }
  Index twin(Index h) const { return half_edges_.twin[h]; }
  Corners corners(Index t) const { return corners_of(mesh_.points, mesh_.triangles[t]); }

  // Calls visit(triangle) for boundary edges (triangles on one side only) near a box.
  template <class Visit>
  void near_boundary(const Box<2>& box, Visit visit) {
    if (!boundary_tree_) build_boundary_tree();
    boundary_tree_->search([&](const Box<2>& other) { return touch(box, other); },
                           [&](Index i) { return visit(boundary_[i]), true; });
  }

  // Some triangle near a box of which good(triangle) is true.
  template <class Good>
  Index find_near(const Box<2>& box, Good good) {
    if (!triangle_tree_) build_triangle_tree();
    Index found = kNoIndex;
    triangle_tree_->search([&](const Box<2>& other) { return overlap(box, other); },
                           [&](Index t) {
                             if (good(t)) found = t;
                             return found == kNoIndex;
                           });
    return found;
  }

  // Calls visit(half-edge) for those that leave v, fan by fan as far as one can turn from the
  // first; visit returns true to stop.
  template <class Visit>
  void around(Index v, Visit visit) const {
    Index first = leaving_[v];
    if (first == kNoIndex) return;
    Index right = half_edges_.turn_right(first);
    for (; right != kNoIndex && right != leaving_[v]; right = half_edges_.turn_right(right))
      first = right;
    for (Index h = first; h != kNoIndex; h = half_edges_.turn_left(h))
      if (visit(h) || half_edges_.turn_left(h) == first) return;
  }

 private:
  void build_boundary_tree() {
    std::vector<Box<2>> boxes;
    for (Index h = 0; h < half_edges_.twin.size(); ++h) {
      if (half_edges_.twin[h] != kNoIndex) continue;
      boundary_.push_back(h);
      boxes.push_back(box_of(point(from(h)), point(to(h))));
    }
    boundary_tree_.emplace(boxes);
  }

  void build_triangle_tree() {
    std::vector<Box<2>> boxes;
    for (Index t = 0; t < triangles(); ++t) {
      const Corners c = corners(t);
      boxes.push_back(box_of(c[0], c[1], c[2]));
    }
    triangle_tree_.emplace(boxes);
  }

  const TriangleMesh& mesh_;
  HalfEdges half_edges_;
  std::vector<Index> leaving_;  // for each node the first half-edge that leaves it
  std::vector<Index> boundary_;
  std::optional<BoxTree<2>> boundary_tree_, triangle_tree_;
};

// Walks through the part of the fine mesh inside one coarse triangle after the other.
class Walker {
 public:
  explicit Walker(const TriangleMesh& fine)
      : fine_(fine), triangle_stamp_(fine.triangles.size(), 0), node_stamp_(fine.points.size()) {}

  // The fine triangles that meet `coarse`, which is counter-clockwise. nodes: the fine nodes at its
  // corners, or kNoIndex.
  const std::vector<Index>& meet(const Corners& coarse, const std::array<Index, 3>& nodes) {
    start(coarse);
    Index seed = seed_at_corners(nodes);
    if (seed == kNoIndex) seed = fine_.find_near(box(), [&](Index t) { return meets(t); });
    if (seed == kNoIndex) return met_;
    flood(seed);
    if (met_boundary_) flood_from_boundary();
    return met_;
  }

 private:
  // On which sides of the three lines of the coarse triangle a fine node lies: bit i where it is
  // strictly inside line i. All bits: inside the triangle.
  struct NodeStamp {
    std::uint32_t stamp = 0;
    std::uint32_t inside = 0;
  };
  static constexpr std::uint32_t kInside = 7;

  void start(const Corners& coarse) {
    coarse_ = coarse;
    ++stamp_;
    met_.clear();
    met_boundary_ = false;
  }

  Box<2> box() const { return box_of(coarse_[0], coarse_[1], coarse_[2]); }

  // A fine triangle at a common corner into which the coarse triangle reaches from there.
  Index seed_at_corners(const std::array<Index, 3>& nodes) const {
    Index seed = kNoIndex;
    for (int i = 0; i < 3 && seed == kNoIndex; ++i) {
      if (nodes[i] == kNoIndex || fine_.point(nodes[i]) != coarse_[i]) continue;
      fine_.around(nodes[i], [&](Index h) {
        if (!starts_in(h, coarse_[(i + 1) % 3])) return false;
        seed = h / 3;
        return true;
      });
    }
    return seed;
  }

  // Whether the ray from the origin of h to p runs through the triangle of h or along h itself.
  bool starts_in(Index h, Point2 p) const {
    const Point2 apex = fine_.point(fine_.from(h));
    const Point2 right = fine_.point(fine_.to(h));
    const Point2 left = fine_.point(fine_.from(HalfEdges::previous(h)));
    return side(apex, right, p) >= 0 && side(apex, p, left) > 0;
  }

  bool meets(Index t) const {
    const Corners c = fine_.corners(t);
    const int sign = orient2d(c[0], c[1], c[2]);
    return sign != 0 && interiors_overlap(counter_clockwise(c, sign), coarse_);
  }

  // Every triangle across an edge that meets the open coarse triangle meets it too, and no other
  // way leads on; so this finds all that are connected with the seed inside the coarse triangle.
  void flood(Index seed) {
    if (triangle_stamp_[seed] == stamp_) return;
    std::size_t next = met_.size();
    take(seed);
    for (; next < met_.size(); ++next)
      for (Index h = 3 * met_[next]; h < 3 * met_[next] + 3; ++h) cross(h);
  }

  void cross(Index h) {
    const Index twin = fine_.twin(h);
    if (twin != kNoIndex && triangle_stamp_[twin / 3] == stamp_) return;
    if (!edge_meets(h)) return;
    twin == kNoIndex ? void(met_boundary_ = true) : take(twin / 3);
  }

  void take(Index t) {
    triangle_stamp_[t] = stamp_;
    met_.push_back(t);
  }

  // If the flood ran into the boundary of the fine mesh inside the coarse triangle, there may be
  // parts on the other side; each has a boundary edge that meets the open coarse triangle.
  void flood_from_boundary() {
    fine_.near_boundary(box(), [&](Index h) {
      if (edge_meets(h)) flood(h / 3);
    });
  }

  // Whether an edge meets the open coarse triangle: no line through it, and no line of the
  // triangle, separates them.
  bool edge_meets(Index h) {
    const Index u = fine_.from(h), v = fine_.to(h);
    const std::uint32_t at_u = inside(u), at_v = inside(v);
    if (at_u == kInside || at_v == kInside) return true;
    if ((at_u | at_v) != kInside) return false;
    bool left = false, right = false;
    for (const Point2 p : coarse_) {
      const int sign = side(fine_.point(u), fine_.point(v), p);
      left |= sign > 0;
      right |= sign < 0;
    }
    return left && right;
  }

  std::uint32_t inside(Index v) {
    NodeStamp& node = node_stamp_[v];
    if (node.stamp != stamp_) node = {stamp_, classify(fine_.point(v))};
    return node.inside;
  }

  std::uint32_t classify(Point2 p) const {
    std::uint32_t bits = 0;
    for (int i = 0; i < 3; ++i)
      bits |= static_cast<std::uint32_t>(side(coarse_[i], coarse_[(i + 1) % 3], p) > 0) << i;
    return bits;
  }

  FineMesh fine_;
  Corners coarse_;
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> triangle_stamp_;
  std::vector<NodeStamp> node_stamp_;
  std::vector<Index> met_;
  bool met_boundary_ = false;
};

std::vector<double> longest_edges(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) lengths.push_back(longest_edge(corners_of(mesh.points, t)));
  return lengths;
}

Index largest(const std::vector<Index>& counts) {
  return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}

// The fine nodes at the corners of coarse triangle t, in the order of its counter-clockwise form.
std::array<Index, 3> nodes_at(const std::array<Index, 3>& t, int sign,
                              std::span<const Index> origin, std::span<const Index> local) {
  std::array<Index, 3> nodes;
  for (int i = 0; i < 3; ++i) {
    const Index v = t[i] < origin.size() ? origin[t[i]] : kNoIndex;
    nodes[i] = v < local.size() ? local[v] : kNoIndex;
  }
  if (sign < 0) std::swap(nodes[1], nodes[2]);
  return nodes;
}

}  // namespace

double Intersections::mean_per_coarse() const {
  if (per_coarse.empty()) return 0;
  return static_cast<double>(
             std::accumulate(per_coarse.begin(), per_coarse.end(), std::uint64_t{0})) /
         static_cast<double>(per_coarse.size());
}

Index Intersections::max_per_coarse() const { return largest(per_coarse); }

Index Intersections::max_per_fine() const { return largest(per_fine); }

Intersections count_intersections(const TriangleMesh& fine, const TriangleMesh& coarse,
                                  std::span<const Index> origin, const Progress& progress) {
  Intersections result;
  result.per_coarse.assign(coarse.triangles.size(), 0);
  result.per_fine.assign(fine.triangles.size(), 0);
  const LocalOrder order = local_order(fine);
  const std::vector<double> lengths = longest_edges(order.mesh);
  Walker walker(order.mesh);
  ProgressMeter meter(progress, "intersect", coarse.triangles.size(), 1 << 10);
  for (const Index t : local_order(coarse).given_triangle) {
    if (!meter.step()) break;
    const Corners corners = corners_of(coarse.points, coarse.triangles[t]);
    const int sign = orient2d(corners[0], corners[1], corners[2]);
    if (sign == 0) continue;
    const double length = longest_edge(corners);
    const auto nodes = nodes_at(coarse.triangles[t], sign, origin, order.local_node);
    for (const Index s : walker.meet(counter_clockwise(corners, sign), nodes)) {
      ++result.per_coarse[t];
      ++result.per_fine[order.given_triangle[s]];
      result.similarity = std::max({result.similarity, length / lengths[s], lengths[s] / length});
    }
  }
  return result;
}

}  // namespace wellspaced::audit
