// How good a triangle of a level is: its circumcircle against its shortest side.
#pragma once

#include <algorithm>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/circumcircle.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"

namespace wellspaced {

inline double squared_distance(Point2 a, Point2 b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return x * x + y * y;
}

/// In floating point: nothing of the topology may be decided by it.
struct TriangleShape {
  Circle circle;
  double shortest_sq = 0;  ///< the square of the shortest side

  /// The squared sine of the smallest angle, by the law of sines; 0 where that cannot be said.
  double sine_sq() const {
    const double value = shortest_sq / (4 * circle.radius_sq);
    return value > 0 ? value : 0;
  }
};

inline TriangleShape shape_of(Point2 a, Point2 b, Point2 c) {
  return {circumcircle(a, b, c),
          std::min({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)})};
}

/// Of three vertices. Requires: none is the ghost.
inline TriangleShape shape_of(const Delaunay2& delaunay, const std::array<Index, 3>& vertices) {
  const auto& points = delaunay.points();
  return shape_of(points[vertices[0]], points[vertices[1]], points[vertices[2]]);
}

}  // namespace wellspaced
