// Domains in space for tests of meshing.
#pragma once

#include <array>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

inline Pls::Facet polygon(std::vector<Index> corners, int marker = 0) {
  return {{std::move(corners)}, {}, marker};
}

/// Adds the eight corners of a box, x fastest; returns the number of the first.
inline Index add_corners(Pls& domain, Point3 low, Point3 high) {
  const auto first = static_cast<Index>(domain.points.size());
  for (int i = 0; i < 8; ++i)
    domain.points.push_back(
        {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return first;
}

/// The sides of a box as corners of add_corners: bottom, top, front, back, left, right.
inline constexpr std::array<std::array<Index, 4>, 6> kBoxSides = {
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};

/// Adds a box whose sides have the markers 1 to 6.
inline Index add_box(Pls& domain, Point3 low, Point3 high) {
  const Index first = add_corners(domain, low, high);
  int marker = 0;
  for (const auto& [a, b, c, d] : kBoxSides)
    domain.facets.push_back(polygon({first + a, first + b, first + c, first + d}, ++marker));
  return first;
}

inline Pls box(Point3 low, Point3 high) {
  Pls domain;
  add_box(domain, low, high);
  return domain;
}

inline Pls unit_cube() { return box({0, 0, 0}, {1, 1, 1}); }

/// The unit cube with two triangles a side.
inline Pls triangulated_cube() {
  Pls domain;
  add_corners(domain, {0, 0, 0}, {1, 1, 1});
  for (const auto& [a, b, c, d] : kBoxSides) {
    domain.facets.push_back(polygon({a, b, c}));
    domain.facets.push_back(polygon({d, c, a}));  // turns the other way
  }
  return domain;
}

/// A square tube, 3 wide and 3 high with a bore of 1, of triangles.
inline Pls triangulated_tube() {
  Pls domain;
  for (int ring = 0; ring < 4; ++ring) {  // outer and inner below, outer and inner above
    const double low = ring % 2, high = 3 - low, z = ring < 2 ? 0 : 3;
    domain.points.insert(domain.points.end(),
                         {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}});
  }
  const auto strip = [&](Index ring, Index other) {
    for (Index i = 0; i < 4; ++i) {
      const Index a = 4 * ring + i, b = 4 * ring + (i + 1) % 4;
      const Index c = 4 * other + (i + 1) % 4, d = 4 * other + i;
      domain.facets.push_back(polygon({a, b, c}));
      domain.facets.push_back(polygon({a, c, d}));
    }
  };
  strip(0, 1), strip(2, 3), strip(0, 2), strip(1, 3);
  return domain;
}

/// A prism over a polygon of the plane, from z = 0 to `height`.
inline Pls prism(const std::vector<Point2>& base, double height) {
  Pls domain;
  const auto n = static_cast<Index>(base.size());
  std::vector<Index> bottom, top;
  for (Index i = 0; i < n; ++i) bottom.push_back(i), top.push_back(n + i);
  for (const Point2 p : base) domain.points.push_back({p.x, p.y, 0});
  for (const Point2 p : base) domain.points.push_back({p.x, p.y, height});
  domain.facets = {polygon(bottom, 1), polygon(top, 2)};
  for (Index i = 0; i < n; ++i)
    domain.facets.push_back(polygon({i, (i + 1) % n, n + (i + 1) % n, n + i}, 3));
  return domain;
}

/// Three unit cubes around a corner.
inline Pls l_prism() { return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1); }

/// A box of 2 x 2 x 1 and on it one of 1 x 1 x 1, with the face that they share.
inline Pls two_boxes() {
  Pls domain = box({0, 0, 0}, {2, 2, 1});
  const Index upper = add_box(domain, {0.5, 0.5, 1}, {1.5, 1.5, 2});
  Pls::Facet& top = domain.facets[1];
  top.polygons.push_back({upper, upper + 1, upper + 3, upper + 2});
  top.holes = {{1, 1, 1}};
  return domain;
}

/// A cube of side 4 with a segment, a square and a point inside, all far from each other.
inline Pls furnished_box() {
  Pls domain = box({0, 0, 0}, {4, 4, 4});
  domain.points.insert(
      domain.points.end(),
      {{1, 1, 1}, {2, 1, 1}, {1, 3, 1}, {1, 3, 2}, {2, 3, 2}, {2, 3, 1}, {3, 1, 3}});
  domain.segments.push_back({8, 9, 7});
  domain.facets.push_back(polygon({10, 11, 12, 13}, 8));
  return domain;
}

/// Turns a domain by a rotation with rational coefficients and moves it, so that its coordinates
/// are rounded and its facets not exactly flat.
inline Pls turned(Pls domain) {
  const auto turn = [](Point3 p) {
    return Point3{(2 * p.x - 2 * p.y + p.z) / 3 + 0.3, (2 * p.x + p.y - 2 * p.z) / 3 - 0.7,
                  (p.x + 2 * p.y + 2 * p.z) / 3 + 1.1};
  };
  for (Point3& p : domain.points) p = turn(p);
  for (Point3& p : domain.holes) p = turn(p);
  for (Pls::Region& r : domain.regions) r.seed = turn(r.seed);
  for (Pls::Facet& facet : domain.facets)
    for (Point3& p : facet.holes) p = turn(p);
  return domain;
}

}  // namespace wellspaced::test
