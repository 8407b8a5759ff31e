// Points far around others, so that no facet that matters is on their hull.
#pragma once

#include <algorithm>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {

inline constexpr Index kFarPoints = 8;

/// Appends the corners of a cube five times as large as the box of the points, or of some cube
/// around them if they are all the same. Requires: at least one point.
inline void add_far_points(std::vector<Point3>& points) {
  const Box3 box = Box3::around(points);
  const Point3 middle = 0.5 * (box.low + box.high), size = box.size();
  const double extent = std::max({size.x, size.y, size.z});
  const double reach = 2.5 * (extent > 0 ? extent : 1 + length(middle));
  for (Index i = 0; i < kFarPoints; ++i)
    points.push_back({middle.x + (i & 1 ? reach : -reach), middle.y + (i & 2 ? reach : -reach),
                      middle.z + (i & 4 ? reach : -reach)});
}

}  // namespace wellspaced
