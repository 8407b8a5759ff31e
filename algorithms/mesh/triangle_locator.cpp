#include "wellspaced/algorithms/mesh/triangle_locator.hpp"

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

std::vector<Box2> triangle_boxes(std::span<const Point2> points,
                                 std::span<const std::array<Index, 3>> triangles) {
  std::vector<Box2> boxes;
  boxes.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    boxes.push_back(Box2::around(std::array{points[a], points[b], points[c]}));
  return boxes;
}

}  // namespace

TriangleLocator::TriangleLocator(std::span<const Point2> points,
                                 std::span<const std::array<Index, 3>> triangles)
    : points_(points), triangles_(triangles), boxes_(triangle_boxes(points, triangles)) {}

std::vector<Index> TriangleLocator::triangles_at(Point2 x) const {
  std::vector<Index> found;
  boxes_.for_each_meeting({x, x}, [&](std::size_t t) {
    if (contains(static_cast<Index>(t), x)) found.push_back(static_cast<Index>(t));
  });
  sort(found);
  return found;
}

bool TriangleLocator::contains(Index triangle, Point2 x) const {
  const auto& [a, b, c] = triangles_[triangle];
  return orient2d(points_[a], points_[b], x) >= 0 && orient2d(points_[b], points_[c], x) >= 0 &&
         orient2d(points_[c], points_[a], x) >= 0;
}

}  // namespace wellspaced
