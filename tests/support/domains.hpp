// Planar domains for tests of meshing.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

/// Closed polygons as a domain; polygon k has the marker k + 1.
inline Pslg polygons(const std::vector<std::vector<Point2>>& loops) {
  Pslg domain;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const Index first = static_cast<Index>(domain.points.size());
    const Index n = static_cast<Index>(loops[k].size());
    domain.points.insert(domain.points.end(), loops[k].begin(), loops[k].end());
    for (Index i = 0; i < n; ++i)
      domain.segments.push_back({first + i, first + (i + 1) % n, static_cast<int>(k) + 1});
  }
  return domain;
}

inline std::vector<Point2> rectangle(Point2 low, Point2 high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

inline Pslg unit_square() { return polygons({rectangle({0, 0}, {1, 1})}); }

/// All corners 90 degrees: a plate with a step, a small hole near its edge, and a crack.
inline Pslg stepped_plate() {
  Pslg domain = polygons(
      {{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {0, 3}}, rectangle({3.5, 0.3}, {3.7, 0.4})});
  const Index k = static_cast<Index>(domain.points.size());
  domain.points.push_back({0.5, 2});
  domain.points.push_back({1.25, 2});
  domain.segments.push_back({k, k + 1, 3});
  return domain;
}

}  // namespace wellspaced::test
