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

double distance_to_segment(Point2 p, Point2 a, Point2 b) {
  const double length = distance(a, b);
  if (length == 0) return distance(p, a);
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
  const double along = (p.x - a.x) * ux + (p.y - a.y) * uy;
  if (along <= 0) return distance(p, a);
  if (along >= length) return distance(p, b);
  return std::fabs((p.x - a.x) * uy - (p.y - a.y) * ux);
}

}  // namespace wellspaced
