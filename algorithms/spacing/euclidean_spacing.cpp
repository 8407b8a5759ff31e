#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"

#include <limits>

#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

std::vector<Index> by_ascending_value(std::span<const double> values) {
  std::vector<Index> order(values.size());
  for (Index v = 0; v < order.size(); ++v) order[v] = v;
  sort(order, [&](Index a, Index b) { return values[a] < values[b]; });
  return order;
}

}  // namespace

// By ascending weight a cone is lowest at its apex unless one before it is lower there; then it is
// the lowest nowhere, and none after it is lower at its apex.
EuclideanCoarseningFunction::EuclideanCoarseningFunction(std::span<const Point2> points,
                                                         std::span<const double> spacing,
                                                         double factor, const Progress& progress)
    : values_(scaled(spacing, factor)),
      tree_(points, std::vector<double>(points.size(), std::numeric_limits<double>::infinity())) {
  ProgressMeter meter(progress, "spacing", points.size(), 1 << 12);
  for (const Index v : by_ascending_value(values_)) {
    if (!meter.step()) return;
    const Index q = tree_.nearest(points[v], values_[v], [](Index) { return true; });
    const double lowest = q == kNoIndex ? values_[v] : weighted_distance(tree_.site(q), points[v]);
    if (lowest < values_[v])
      values_[v] = lowest;
    else
      tree_.lower_weight(v, values_[v]);
  }
}

double EuclideanCoarseningFunction::operator()(Point2 x) const {
  const Index q = source(x);
  return q == kNoIndex ? std::numeric_limits<double>::infinity()
                       : weighted_distance(tree_.site(q), x);
}

std::vector<double> euclidean_coarsened_spacing(std::span<const Point2> points,
                                                std::span<const double> spacing, double factor,
                                                const Progress& progress) {
  return EuclideanCoarseningFunction(points, spacing, factor, progress).at_points();
}

}  // namespace wellspaced
