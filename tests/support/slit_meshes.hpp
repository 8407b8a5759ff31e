// Grid meshes that are cut open along horizontal slits.
#pragma once

#include <algorithm>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::test {

/// Cuts a grid_mesh along its row `y` from column x0 to column x1: the nodes between, and the one
/// in column 0 if the slit starts there, get a twin, which the triangles above take.
/// Requires: x0 + 2 <= x1 < columns - 1; no earlier slit in a row next to this one.
inline void cut_slit(TriangleMesh& mesh, Index columns, Index y, Index x0, Index x1) {
  const auto first_twin = static_cast<Index>(mesh.points.size());
  const Index begin = y * columns + (x0 == 0 ? 0 : x0 + 1), end = y * columns + x1;
  for (Index v = begin; v < end; ++v) {
    const Point2 p = mesh.points[v];
    mesh.points.push_back(p);
  }
  for (auto& triangle : mesh.triangles) {
    const bool above = std::ranges::any_of(
        triangle, [&](Index v) { return v >= (y + 1) * columns && v < (y + 2) * columns; });
    if (!above) continue;
    for (Index& v : triangle)
      if (v >= begin && v < end) v = first_twin + (v - begin);
  }
}

}  // namespace wellspaced::test
