#include "wellspaced/algorithms/mesh/coincident_points.hpp"

#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

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
  sort(sorted, [](const auto& a, const auto& b) {
    return a.point < b.point || (a.point == b.point && a.number < b.number);
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
