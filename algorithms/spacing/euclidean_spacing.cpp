#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"

#include <limits>

#include "wellspaced/algorithms/spacing/spacing_function.hpp"

namespace wellspaced {

EuclideanCoarseningFunction::EuclideanCoarseningFunction(std::span<const Point2> points,
                                                         std::span<const double> spacing,
                                                         double factor)
    : tree_(points, scaled(spacing, factor)) {}

double EuclideanCoarseningFunction::operator()(Point2 x) const {
  const Index q = source(x);
  return q == kNoIndex ? std::numeric_limits<double>::infinity()
                       : weighted_distance(tree_.site(q), x);
}

std::vector<double> EuclideanCoarseningFunction::at_points() const {
  std::vector<double> values(tree_.size());
  tree_.for_each_along_curve([&](Index v) { values[v] = (*this)(tree_.site(v).place); });
  return values;
}

std::vector<double> euclidean_coarsened_spacing(std::span<const Point2> points,
                                                std::span<const double> spacing, double factor) {
  return EuclideanCoarseningFunction(points, spacing, factor).at_points();
}

}  // namespace wellspaced
