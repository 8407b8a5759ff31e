#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

double distance_at_scale(Point2 a, Point2 b, double scale) {
  const double dx = a.x * scale - b.x * scale, dy = a.y * scale - b.y * scale;
  return std::sqrt(dx * dx + dy * dy) / scale;
}

}  // namespace

double scaled_distance(Point2 a, Point2 b) {
  const double reach = std::fmax(std::fabs(a.x / 4 - b.x / 4), std::fabs(a.y / 4 - b.y / 4));
  if (reach >= 0x1p450) return distance_at_scale(a, b, 0x1p-600);
  // A small difference may be that of large coordinates: it is taken before it is scaled.
  const Point2 difference{a.x - b.x, a.y - b.y};
  return distance_at_scale(difference, {0, 0}, 0x1p600);
}

}  // namespace wellspaced
