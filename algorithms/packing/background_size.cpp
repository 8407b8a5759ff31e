#include "wellspaced/algorithms/packing/background_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace wellspaced {
namespace {

double doubled_area_of(Point2 a, Point2 b, Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

Result<BackgroundSize> BackgroundSize::build(std::span<const Point2> points,
                                             std::span<const double> values) {
  if (points.empty() || values.size() != points.size())
    return Error{ErrorCode::kUsage, "a background needs one size at each of its points", {}};
  std::vector<Index> bad;
  for (Index v = 0; v < values.size(); ++v)
    if (!(values[v] > 0) || !std::isfinite(values[v])) bad.push_back(v);
  if (!bad.empty()) {
    const std::string first = std::to_string(bad[0]);
    return Error{ErrorCode::kUsage,
                 {"the size at point ", first, " is not positive and finite"},
                 std::move(bad)};
  }
  Result<Delaunay2> delaunay = Delaunay2::build(points);
  if (!delaunay) return delaunay.error();
  BackgroundSize result(std::move(*delaunay), EuclideanCoarseningFunction(points, values, 1));
  result.sizes_ = result.envelope_.at_points();
  return result;
}

double BackgroundSize::operator()(Point2 x) {
  if (delaunay_.dimension() < 2) return envelope_(x);
  const Delaunay2::Location place = delaunay_.locate(x, last_);
  last_ = place.edge.triangle;
  if (place.place == Delaunay2::Place::kOutside) return envelope_(x);
  const auto& [i, j, k] = delaunay_.topology().vertices(last_);
  const Point2 a = delaunay_.points()[i], b = delaunay_.points()[j], c = delaunay_.points()[k];
  const double u = doubled_area_of(x, b, c), v = doubled_area_of(x, c, a),
               w = doubled_area_of(x, a, b);
  const double whole = u + v + w;
  if (!(whole > 0)) return std::min({sizes_[i], sizes_[j], sizes_[k]});
  const double size = (u * sizes_[i] + v * sizes_[j] + w * sizes_[k]) / whole;
  return std::max(size, std::min({sizes_[i], sizes_[j], sizes_[k]}));
}

}  // namespace wellspaced
