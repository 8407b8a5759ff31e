// Axis-parallel boxes in space.
#pragma once

#include <algorithm>
#include <span>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {

/// The points between two corners. Requires: low <= high in every coordinate.
struct Box3 {
  Point3 low, high;

  /// The smallest box around some points. Requires: at least one point.
  static Box3 around(std::span<const Point3> points) {
    Box3 box{points[0], points[0]};
    for (const Point3 p : points) box.cover({p, p});
    return box;
  }
  void cover(const Box3& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y),
           std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y),
            std::max(high.z, other.high.z)};
  }
  /// How long it is in each direction.
  Point3 size() const { return high - low; }
};

}  // namespace wellspaced
