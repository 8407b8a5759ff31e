// Seeded point sets in the plane, regular and degenerate, for tests of the kernel.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::test {

inline std::vector<Point2> uniform_points(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform();
    points.push_back({x, random.uniform()});
  }
  return points;
}

// Points with coordinates 0 .. side - 1: many duplicates, collinear and cocircular ones.
inline std::vector<Point2> lattice_points(int n, int side, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double x = static_cast<double>(random.below(side));
    points.push_back({x, static_cast<double>(random.below(side))});
  }
  return points;
}

// A point and its neighbours a few units in the last place away.
inline std::vector<Point2> one_ulp_neighbours(int n, std::uint64_t seed) {
  Random random(seed);
  const auto nudge = [&](double value) {
    for (std::uint64_t k = random.below(4); k > 0; --k) value = std::nextafter(value, 10.0);
    return value;
  };
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double x = nudge(0.5 + static_cast<double>(random.below(3)));
    points.push_back({x, nudge(0.5 + static_cast<double>(random.below(3)))});
  }
  return points;
}

// Nearly on the line y = x / 3: decided by rounding alone.
inline std::vector<Point2> nearly_collinear_points(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform();
    points.push_back({x, x / 3});
  }
  return points;
}

// On the circle of radius 65 about the origin with integer coordinates: 36 points, repeated.
inline std::vector<Point2> cocircular_points(int n, std::uint64_t seed) {
  std::vector<Point2> circle;
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65)
        circle.push_back({static_cast<double>(x), static_cast<double>(y)});
  Random random(seed);
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) points.push_back(circle[random.below(circle.size())]);
  return points;
}

inline std::vector<Point2> scaled(std::vector<Point2> points, int exponent) {
  for (Point2& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return points;
}

struct PointFamily {
  std::string name;
  std::vector<Point2> points;
};

// Every family once, of about n points.
inline std::vector<PointFamily> point_families(int n, std::uint64_t seed) {
  return {{"uniform", uniform_points(n, seed)},
          {"lattice4", lattice_points(n, 4, seed)},
          {"lattice9", lattice_points(n, 9, seed)},
          {"ulps", one_ulp_neighbours(n, seed)},
          {"line", nearly_collinear_points(n, seed)},
          {"circle", cocircular_points(n, seed)},
          {"tiny", scaled(lattice_points(n, 9, seed), -1074)},
          {"huge", scaled(lattice_points(n, 9, seed), 1018)}};
}

}  // namespace wellspaced::test
