// What makes a tetrahedralization Delaunay, checked from the definition and exactly.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "tests/support/slow_integer.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced::test {

inline int sign_of_tet(const std::vector<Point3>& p, const std::array<Index, 4>& v) {
  return -orient3d(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
}

/// The distinct points, each by its lowest number.
inline std::vector<Index> distinct_points(const std::vector<Point3>& points) {
  std::vector<Index> order;
  for (Index i = 0; i < points.size(); ++i) order.push_back(i);
  const auto key = [&](Index i) {
    return std::array{points[i].x + 0.0, points[i].y + 0.0, points[i].z + 0.0};
  };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  order.erase(
      std::unique(order.begin(), order.end(), [&](Index a, Index b) { return key(a) == key(b); }),
      order.end());
  std::sort(order.begin(), order.end());
  return order;
}

/// Links agree, no tet is inverted or flat, and across every facet the other tet's corner is not
/// inside the sphere, or below the hull: locally Delaunay and convex, and so (Delaunay's lemma) the
/// Delaunay triangulation of the convex hull.
inline void expect_locally_delaunay(const Delaunay3& d) {
  const Triangulation3& topology = d.topology();
  const auto& p = d.points();
  ASSERT_TRUE(topology.is_valid());
  Index inverted = 0, not_empty = 0, not_convex = 0;
  for (Index t = 0; t < topology.size(); ++t) {
    const auto& v = topology.vertices(t);
    if (!topology.is_ghost(t)) inverted += sign_of_tet(p, v) <= 0;
    for (unsigned i = 0; i < 4; ++i) {
      const Index w = topology.apex(topology.mirror({t, i}));
      if (w == Triangulation3::kGhost) continue;
      if (!topology.is_ghost(t))
        not_empty += insphere(p[v[1]], p[v[0]], p[v[2]], p[v[3]], p[w]) > 0;
      else if (i < 3)
        not_convex += orient3d(p[v[0]], p[v[1]], p[v[2]], p[w]) < 0;
    }
  }
  EXPECT_EQ(inverted, 0u);
  EXPECT_EQ(not_empty, 0u);
  EXPECT_EQ(not_convex, 0u);
}

/// Every distinct point is a vertex of some tet, and no other number is.
inline void expect_all_points_used(const Delaunay3& d) {
  std::set<Index> used;
  for (Index t = 0; t < d.topology().size(); ++t)
    for (const Index v : d.topology().vertices(t))
      if (v != Triangulation3::kGhost) used.insert(v);
  const std::vector<Index> distinct = distinct_points(d.points());
  EXPECT_TRUE(std::equal(used.begin(), used.end(), distinct.begin(), distinct.end()));
  EXPECT_EQ(d.duplicate_count(), d.points().size() - distinct.size());
}

/// Euler's formula for the sphere that the tets and ghosts make: V - E + F - T = 0.
inline void expect_euler(const Delaunay3& d) {
  const Triangulation3& topology = d.topology();
  std::set<Index> vertices;
  std::set<std::pair<Index, Index>> edges;
  for (Index t = 0; t < topology.size(); ++t) {
    const auto& v = topology.vertices(t);
    vertices.insert(v.begin(), v.end());
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = 0; j < i; ++j) edges.insert(std::minmax(v[i], v[j]));
  }
  const long tets = topology.size(), facets = 2 * tets;
  EXPECT_EQ(static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) + facets - tets,
            0);
}

using ::wellspaced::testing::SlowInteger;

/// Six times the signed volume of (a, b, c, d) in units of 2^(3 unit).
inline SlowInteger slow_volume(Point3 a, Point3 b, Point3 c, Point3 d, int unit) {
  ::wellspaced::testing::SlowMatrix rows;
  const auto whole = [unit](double x) { return SlowInteger::from_double(x, unit); };
  for (const Point3 q : {b, c, d})
    rows.push_back({whole(q.x) - whole(a.x), whole(q.y) - whole(a.y), whole(q.z) - whole(a.z)});
  return ::wellspaced::testing::slow_determinant(rows);
}

/// The tets fill the hull: their volumes add up to what the hull facets enclose.
inline void expect_volume_of_hull(const Delaunay3& d, int unit) {
  const auto& p = d.points();
  const Triangulation3& topology = d.topology();
  SlowInteger tets, hull;
  for (Index t = 0; t < topology.size(); ++t) {
    const auto& v = topology.vertices(t);
    if (topology.is_ghost(t))  // its facet turns counter-clockwise seen from outside
      hull = hull + slow_volume(p[0], p[v[0]], p[v[1]], p[v[2]], unit);
    else
      tets = tets + slow_volume(p[v[0]], p[v[1]], p[v[2]], p[v[3]], unit);
  }
  EXPECT_TRUE(tets == hull);
}

inline void expect_delaunay(const Delaunay3& d, int unit = -1074) {
  expect_locally_delaunay(d);
  expect_all_points_used(d);
  expect_euler(d);
  expect_volume_of_hull(d, unit);
}

/// The Delaunay cells from the definition: the points on each empty sphere through four points that
/// are not coplanar. Cost: n^5.
inline std::set<std::vector<Index>> cells_by_definition(const std::vector<Point3>& p) {
  const std::vector<Index> all = distinct_points(p);
  std::set<std::vector<Index>> cells;
  for (const Index a : all)
    for (const Index b : all)
      for (const Index c : all)
        for (const Index d : all) {
          if (!(a < b && b < c && c < d)) continue;
          const int side = orient3d(p[a], p[b], p[c], p[d]);
          if (side == 0) continue;
          std::vector<Index> on;
          bool is_empty = true;
          for (const Index e : all) {
            const int in = e == a || e == b || e == c || e == d
                               ? 0
                               : side * insphere(p[a], p[b], p[c], p[d], p[e]);
            if (in > 0) is_empty = false;
            if (in == 0) on.push_back(e);
          }
          if (is_empty) cells.insert(on);
        }
  return cells;
}

}  // namespace wellspaced::test
