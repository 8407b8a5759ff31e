// Checks a planar triangle mesh on its own terms, without the library but for its exact predicates.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::test {

/// What a valid mesh looks like from afar. A hole, like an outer boundary, is a boundary loop; two
/// loops that touch in a node count as two.
struct MeshShape {
  std::size_t components = 0;  ///< of triangles that share edges
  std::size_t loops = 0;       ///< of the boundary
  friend bool operator==(const MeshShape&, const MeshShape&) = default;
};

class MeshChecker {
 public:
  explicit MeshChecker(const TriangleMesh& mesh) : mesh_(mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Index a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
        if (!triangle_of_.insert({{a, b}, t}).second)
          complain("two triangles on one side of edge", a, b);
      }
    for (const auto& [edge, t] : triangle_of_)
      if (!triangle_of_.contains({edge[1], edge[0]})) boundary_.push_back(edge);
    for (const Segment& s : mesh.segments) segments_.insert(std::minmax(s.a, s.b));
  }

  /// The complaints, none for a mesh whose triangles tile a domain without overlap, with every
  /// boundary edge among the segments and every segment an edge.
  const std::vector<std::string>& check_validity() {
    check_orientation();
    check_stars();
    check_segments();
    check_boundary_crossings();
    return complaints_;
  }

  /// Complains about every unconstrained edge whose opposite node lies inside the circle.
  const std::vector<std::string>& check_constrained_delaunay() {
    for (const auto& [edge, t] : triangle_of_) {
      const auto other = triangle_of_.find({edge[1], edge[0]});
      if (other == triangle_of_.end() || segments_.contains(std::minmax(edge[0], edge[1])))
        continue;
      const auto& [a, b, c] = mesh_.triangles[t];
      if (incircle(at(a), at(b), at(c), at(apex(other->second, edge))) > 0)
        complain("not Delaunay", edge[0], edge[1]);
    }
    return complaints_;
  }

  MeshShape shape() const { return {count_components(), count_loops()}; }

  /// Twice the area, summed over the triangles.
  double twice_area() const {
    double sum = 0;
    for (const auto& [a, b, c] : mesh_.triangles)
      sum += (at(b).x - at(a).x) * (at(c).y - at(a).y) - (at(b).y - at(a).y) * (at(c).x - at(a).x);
    return sum;
  }

 private:
  using Edge = std::array<Index, 2>;

  Point2 at(Index v) const { return mesh_.points[v]; }
  void complain(const std::string& what, Index a, Index b) {
    complaints_.push_back(what + " " + std::to_string(a) + "-" + std::to_string(b));
  }
  Index apex(std::size_t t, Edge edge) const {
    for (const Index v : mesh_.triangles[t])
      if (v != edge[0] && v != edge[1]) return v;
    return kNoIndex;
  }

  void check_orientation() {
    for (const auto& [a, b, c] : mesh_.triangles)
      if (orient2d(at(a), at(b), at(c)) <= 0)
        complain("triangle is not counter-clockwise at", a, b);
  }

  // The triangles around a node overlap nowhere when the ray to the right of it meets one of them
  // at most. Then the mesh is an immersion of a surface, and, its boundary being simple, embedded.
  void check_stars() {
    std::map<Index, int> hits;
    for (const auto& triangle : mesh_.triangles)
      for (int i = 0; i < 3; ++i) {
        const Index v = triangle[i];
        hits[v] += ray_enters(at(v), at(triangle[(i + 1) % 3]), at(triangle[(i + 2) % 3]));
      }
    for (const auto& [v, count] : hits)
      if (count > 1) complain("triangles overlap around node", v, v);
  }
  // Whether the direction (1, 0) lies in the angle from b to c around a, b's ray included.
  static bool ray_enters(Point2 a, Point2 b, Point2 c) {
    const bool b_below = b.y < a.y || (b.y == a.y && b.x > a.x);
    const bool c_above = c.y > a.y || (c.y == a.y && c.x < a.x);
    const bool b_is_left = b.y == a.y && b.x < a.x;
    return b_below && c_above && !b_is_left;
  }

  void check_segments() {
    for (const Edge& e : boundary_)
      if (!segments_.contains(std::minmax(e[0], e[1])))
        complain("no segment on boundary", e[0], e[1]);
    for (const auto& [a, b] : segments_)
      if (!triangle_of_.contains({a, b}) && !triangle_of_.contains({b, a}))
        complain("segment is no edge", a, b);
  }

  // Coincident edges on distinct nodes are the lips of a slit.
  void check_boundary_crossings() {
    std::vector<Edge> edges = boundary_;
    const auto low = [&](const Edge& e) { return std::min(at(e[0]).x, at(e[1]).x); };
    const auto high = [&](const Edge& e) { return std::max(at(e[0]).x, at(e[1]).x); };
    std::sort(edges.begin(), edges.end(),
              [&](const Edge& a, const Edge& b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size() && low(edges[j]) <= high(edges[i]); ++j)
        if (meet_inside(edges[i], edges[j]) || meet_inside(edges[j], edges[i]))
          complain("boundary edges meet", edges[i][0], edges[j][0]);
  }
  // They cross, or an end of f lies inside e.
  bool meet_inside(const Edge& e, const Edge& f) const {
    const Point2 a = at(e[0]), b = at(e[1]), c = at(f[0]), d = at(f[1]);
    if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0)
      return true;
    return lies_inside(c, a, b) || lies_inside(d, a, b);
  }
  static bool lies_inside(Point2 p, Point2 a, Point2 b) {
    const auto key = [](Point2 q) { return std::pair{q.x, q.y}; };
    return orient2d(a, b, p) == 0 && std::min(key(a), key(b)) < key(p) &&
           key(p) < std::max(key(a), key(b));
  }

  std::size_t count_components() const {
    std::vector<std::size_t> root(mesh_.triangles.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t t) {
      while (root[t] != t) t = root[t] = root[root[t]];
      return t;
    };
    std::size_t components = root.size();
    for (const auto& [edge, t] : triangle_of_) {
      const auto other = triangle_of_.find({edge[1], edge[0]});
      if (other == triangle_of_.end() || find(t) == find(other->second)) continue;
      root[find(t)] = find(other->second);
      --components;
    }
    return components;
  }

  // Follows the boundary through the fans of triangles.
  std::size_t count_loops() const {
    std::set<Edge> left(boundary_.begin(), boundary_.end());
    std::size_t loops = 0;
    for (; !left.empty(); ++loops)
      for (Edge e = *left.begin(); left.erase(e) > 0;) e = next_on_boundary(e);
    return loops;
  }
  Edge next_on_boundary(Edge e) const {
    const Index v = e[1];
    Index w = apex(triangle_of_.at(e), e);
    for (auto inner = triangle_of_.find({w, v}); inner != triangle_of_.end();
         inner = triangle_of_.find({w, v}))
      w = apex(inner->second, {w, v});
    return {v, w};
  }

  const TriangleMesh& mesh_;
  std::map<Edge, std::size_t> triangle_of_;
  std::vector<Edge> boundary_;
  std::set<std::pair<Index, Index>> segments_;
  std::vector<std::string> complaints_;
};

}  // namespace wellspaced::test
