#include "wellspaced/algorithms/mesh/coincident_points.hpp"

#include <algorithm>

namespace wellspaced {
namespace {

bool before(const Point2& p, const Point2& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

bool before(const Point3& p, const Point3& q) {
  if (p.x != q.x) return p.x < q.x;
  return p.y < q.y || (p.y == q.y && p.z < q.z);
}

template <class Point>
struct NumberedPoint {
  Point point;
  Index number;
};

template <class Point>
std::vector<Index> find_first(std::span<const Point> points) {
  std::vector<NumberedPoint<Point>> sorted;
  sorted.reserve(points.size());
  for (const Point& p : points) sorted.push_back({p, static_cast<Index>(sorted.size())});
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return before(a.point, b.point) || (a.point == b.point && a.number < b.number);
  });
  std::vector<Index> first(points.size());
  Index leader = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || !(sorted[i].point == sorted[i - 1].point)) leader = sorted[i].number;
    first[sorted[i].number] = leader;
  }
  return first;
}

}  // namespace

std::vector<Index> first_coincident(std::span<const Point2> points) { return find_first(points); }
std::vector<Index> first_coincident(std::span<const Point3> points) { return find_first(points); }

}  // namespace wellspaced
