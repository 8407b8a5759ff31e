// Point sets of space on which triangulators fail: seeded, small, exact where they say so.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::test {

struct PointSet3 {
  std::string name;
  std::vector<Point3> points;
};

inline std::vector<Point3> uniform3(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

/// Whole coordinates 0 .. below - 1: few, so many are cospherical, coplanar or equal.
inline std::vector<Point3> whole3(std::size_t count, std::uint64_t below, std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] { return static_cast<double>(random.below(below)); };
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {draw(), draw(), draw()};
  return points;
}

inline std::vector<Point3> lattice3(int nx, int ny, int nz, double step = 1) {
  std::vector<Point3> points;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (int k = 0; k < nz; ++k) points.push_back({i * step, j * step, k * step});
  return points;
}

/// Near the unit sphere: as near as rounding lets them.
inline std::vector<Point3> rounded_sphere3(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points;
  while (points.size() < count) {
    const Point3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double r = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (r > 0.1 && r < 1) points.push_back({p.x / r, p.y / r, p.z / r});
  }
  return points;
}

/// Whole points exactly on the sphere of squared radius 325 about the origin.
inline std::vector<Point3> exact_sphere3() {
  std::vector<Point3> points;
  for (int x = -18; x <= 18; ++x)
    for (int y = -18; y <= 18; ++y)
      for (int z = -18; z <= 18; ++z)
        if (x * x + y * y + z * z == 325) points.push_back({double(x), double(y), double(z)});
  return points;
}

/// (t, t^2, t^3): every two points are joined by an edge.
inline std::vector<Point3> moment_curve3(int count) {
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) {
    const double t = i - count / 2;
    points.push_back({t, t * t, t * t * t});
  }
  return points;
}

/// Two lines that do not meet: count * count tets.
inline std::vector<Point3> skew_lines3(int count) {
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) points.push_back({double(i), 0, 0});
  for (int i = 0; i < count; ++i) points.push_back({0, double(i), 1});
  return points;
}

/// Points of a lattice of the plane x + 2 y + 3 z = 0 and one off it.
inline std::vector<Point3> coplanar_and_apex3(int side) {
  std::vector<Point3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.push_back({-2.0 * i - 3.0 * j, double(i), double(j)});
  points.push_back({1, 2, 3});
  return points;
}

/// Schoenhardt's polyhedron: a prism twisted until it can not be cut into tets without a new point
/// (its points can).
inline std::vector<Point3> schoenhardt3() {
  const double s = 0.8660254037844386, c = 0.5;
  return {{1, 0, 0}, {-c, s, 0}, {-c, -s, 0}, {s, c, 1}, {-s, c, 1}, {0, -1, 1}};
}

inline std::vector<Point3> scaled(std::vector<Point3> points, double by) {
  for (Point3& p : points) p = {p.x * by, p.y * by, p.z * by};
  return points;
}

inline void shuffle(std::vector<Point3>& points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

/// Neighbours by one unit in the last place around (1, 1, 1).
inline std::vector<Point3> one_ulp_apart3(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] { return 1 + static_cast<double>(random.below(4)) * 0x1p-52; };
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {draw(), draw(), draw()};
  return points;
}

/// Points of an 11 x 11 x 2 slab, whose upper layer lies `height` above the lower.
inline std::vector<Point3> thin_slab3(double height) {
  std::vector<Point3> points = lattice3(11, 11, 2);
  for (Point3& p : points) p.z *= height;
  return points;
}

/// Slivers: four points near the equator of a sphere, moved off it by `height`, many times over.
inline std::vector<Point3> slivers3(int count, double height) {
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) {
    const double x = 3.0 * i;
    points.insert(points.end(), {{x + 1, 0, height}, {x - 1, 0, height}, {x, 1, 0}, {x, -1, 0}});
  }
  return points;
}

/// The families, each with fewer than 700 points.
inline std::vector<PointSet3> degenerate_sets3() {
  std::vector<PointSet3> sets{
      {"uniform", uniform3(300, 1)},
      {"whole numbers below 3", whole3(60, 3, 2)},
      {"whole numbers below 10", whole3(500, 10, 3)},
      {"lattice", lattice3(6, 6, 6)},
      {"lattice of tenths", lattice3(6, 6, 6, 0.1)},
      {"rounded sphere", rounded_sphere3(300, 4)},
      {"exact sphere", exact_sphere3()},
      {"moment curve", moment_curve3(40)},
      {"skew lines", skew_lines3(30)},
      {"coplanar points and apex", coplanar_and_apex3(12)},
      {"Schoenhardt's points", schoenhardt3()},
      {"one ulp apart", one_ulp_apart3(100, 5)},
      {"thin slab", thin_slab3(1e-9)},
      {"slab of subnormal height", thin_slab3(5e-324)},
      {"slivers", slivers3(20, 1e-12)},
      {"uniform, subnormal", scaled(uniform3(200, 6), 0x1p-1060)},
      {"uniform, huge", scaled(uniform3(200, 7), 0x1p1023)},
  };
  for (int k = -15; k < 15; ++k)
    sets.push_back({"lattice at 2^" + std::to_string(70 * k),
                    scaled(lattice3(4, 4, 4), std::ldexp(1.0, 70 * k))});
  std::vector<Point3> clustered = uniform3(200, 8);
  for (std::size_t i = 0; i < clustered.size(); ++i)
    clustered[i] = scaled({clustered[i]}, std::ldexp(1.0, -5 * static_cast<int>(i)))[0];
  sets.push_back({"one cluster in another down to 2^-1000", clustered});
  std::vector<Point3> repeated = whole3(400, 4, 9);
  sets.push_back({"repeated", repeated});
  return sets;
}

}  // namespace wellspaced::test
