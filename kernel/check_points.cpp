#include "wellspaced/kernel/check_points.hpp"

#include <utility>
#include <vector>

#include "wellspaced/kernel/point_order.hpp"

namespace wellspaced {
namespace {

template <class Point>
Status check_each_point(std::span<const Point> points) {
  if (points.size() > kMaxOrderedPoints)
    return Error{ErrorCode::kLimit, "more than 2^28 points", {}};
  std::vector<Index> bad;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) bad.push_back(static_cast<Index>(i));
  if (bad.empty()) return Ok{};
  return Error{ErrorCode::kInvalidGeometry,
               {"point ", bad[0], " has a coordinate that is not finite"},
               std::move(bad)};
}

}  // namespace

Status check_points(std::span<const Point2> points) { return check_each_point(points); }
Status check_points(std::span<const Point3> points) { return check_each_point(points); }

}  // namespace wellspaced
