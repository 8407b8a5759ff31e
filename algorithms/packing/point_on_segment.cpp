#include "wellspaced/algorithms/packing/point_on_segment.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/kernel/plane/crossing.hpp"

namespace wellspaced {

Point2 point_on_segment(Point2 a, Point2 b, double t) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const Point2 low{std::min(a.x, b.x), std::min(a.y, b.y)};
  const Point2 high{std::max(a.x, b.x), std::max(a.y, b.y)};
  if (std::fabs(dx) >= std::fabs(dy)) {
    const double x = std::clamp(a.x + t * dx, low.x, high.x);
    if (dy == 0) return {x, a.y};
    return round_crossing({a, b, {x, low.y}, {x, high.y}}).points[0];
  }
  const double y = std::clamp(a.y + t * dy, low.y, high.y);
  if (dx == 0) return {a.x, y};
  return round_crossing({a, b, {low.x, y}, {high.x, y}}).points[0];
}

}  // namespace wellspaced
