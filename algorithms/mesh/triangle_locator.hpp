// Which triangles of a mesh contain a point?
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Finds triangles by a tree of their boxes: for meshes of any shape, with holes and slits.
/// Requires: points and triangles outlive it; indices in range.
/// Cost: O(n log n) to build, a query O(log n) where few triangles overlap a place.
class TriangleLocator {
 public:
  TriangleLocator(std::span<const Point2> points, std::span<const std::array<Index, 3>> triangles);

  /// The closed triangles that contain x, ascending; exact.
  /// Requires: counter-clockwise triangles.
  std::vector<Index> triangles_at(Point2 x) const;

 private:
  bool contains(Index triangle, Point2 x) const;

  std::span<const Point2> points_;
  std::span<const std::array<Index, 3>> triangles_;
  BoxTree boxes_;
};

}  // namespace wellspaced
