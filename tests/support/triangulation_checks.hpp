// What must hold of a Delaunay2, checked by the predicates and nothing else of the kernel.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::test {

// Its real triangles, each with the lowest corner first, ascending.
inline std::vector<std::array<Index, 3>> triangles_of(const Delaunay2& dt) {
  std::vector<std::array<Index, 3>> triangles;
  for (Index t = 0; t < dt.topology().size(); ++t) {
    if (dt.topology().is_ghost(t)) continue;
    std::array<Index, 3> v = dt.topology().vertices(t);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    triangles.push_back(v);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// Links are mutual, triangles positive, hull edges convex, and no unconstrained edge fails the
// in-circle test; edge_from() finds every vertex. These local facts imply that the triangulation
// covers the convex hull once and is constrained Delaunay.
inline ::testing::AssertionResult is_constrained_delaunay(const Delaunay2& dt) {
  using Edge = Delaunay2::Edge;
  const Triangulation2& mesh = dt.topology();
  const std::vector<Point2>& p = dt.points();
  const auto fail = [](const char* what, Index t) {
    return ::testing::AssertionFailure() << what << " at triangle " << t;
  };
  if (!mesh.is_valid()) return ::testing::AssertionFailure() << "the links are not mutual";
  for (Index t = 0; t < mesh.size(); ++t) {
    const auto& v = mesh.vertices(t);
    if (mesh.is_ghost(t)) {
      const Edge hull{t, mesh.corner_of(t, Triangulation2::kGhost)};
      const Index beyond = mesh.apex(mesh.mirror({t, Triangulation2::next(hull.i)}));
      if (orient2d(p[mesh.origin(hull)], p[mesh.destination(hull)], p[beyond]) > 0)
        return fail("the hull is not convex", t);
      continue;
    }
    if (orient2d(p[v[0]], p[v[1]], p[v[2]]) <= 0) return fail("not counter-clockwise", t);
    for (unsigned i = 0; i < 3; ++i) {
      const Index far = mesh.apex(mesh.mirror({t, i}));
      if (mesh.is_constrained({t, i}) || far == Triangulation2::kGhost) continue;
      if (incircle(p[v[0]], p[v[1]], p[v[2]], p[far]) > 0) return fail("not Delaunay", t);
    }
  }
  std::size_t vertices = 0;
  for (Index v = 0; v < p.size(); ++v) {
    if (!dt.is_vertex(v)) continue;
    ++vertices;
    const Edge e = dt.edge_from(v);
    if (e.triangle >= mesh.size() || mesh.origin(e) != v) return fail("edge_from fails", v);
  }
  if (mesh.size() != 2 * vertices - 2)
    return ::testing::AssertionFailure() << mesh.size() << " triangles for " << vertices;
  return ::testing::AssertionSuccess();
}

// The number of distinct points.
inline std::size_t distinct(const std::vector<Point2>& points) {
  std::set<std::pair<double, double>> set;
  for (const Point2 p : points) set.insert({p.x + 0.0, p.y + 0.0});
  return set.size();
}

// All triples whose circle is empty of the others: the Delaunay triangles and, in ties, more.
// Cost: n^4.
inline std::vector<std::array<Index, 3>> empty_circle_triangles(const std::vector<Point2>& p) {
  std::vector<std::array<Index, 3>> found;
  const Index n = static_cast<Index>(p.size());
  for (Index a = 0; a < n; ++a)
    for (Index b = a + 1; b < n; ++b)
      for (Index c = a + 1; c < n; ++c) {
        if (c == b || orient2d(p[a], p[b], p[c]) <= 0) continue;
        bool empty = true;
        for (Index d = 0; d < n && empty; ++d) empty = incircle(p[a], p[b], p[c], p[d]) <= 0;
        if (empty) found.push_back({a, b, c});
      }
  return found;
}

}  // namespace wellspaced::test
