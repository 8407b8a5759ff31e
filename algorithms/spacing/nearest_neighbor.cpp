#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"

#include <limits>

#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {

NearestNeighborFunction::NearestNeighborFunction(std::span<const Point2> points) : tree_(points) {}

double NearestNeighborFunction::operator()(Point2 x) const {
  const Index first = tree_.nearest(x);
  const Index second = first == kNoIndex ? kNoIndex : nearest_elsewhere(x, tree_.site(first).place);
  return second == kNoIndex ? std::numeric_limits<double>::infinity()
                            : distance(x, tree_.site(second).place);
}

Index NearestNeighborFunction::neighbor_of(Index v) const {
  const Point2 p = tree_.site(v).place;
  return nearest_elsewhere(p, p);
}

std::vector<double> NearestNeighborFunction::at_points(const Progress& progress) const {
  std::vector<double> values(tree_.size(), std::numeric_limits<double>::infinity());
  ProgressMeter meter(progress, "spacing", tree_.size(), 1 << 12);
  tree_.for_each_along_curve([&](Index v) {
    if (!meter.step()) return;
    const Index neighbor = neighbor_of(v);
    if (neighbor != kNoIndex) values[v] = distance(tree_.site(v).place, tree_.site(neighbor).place);
  });
  return values;
}

Index NearestNeighborFunction::nearest_elsewhere(Point2 x, Point2 excluded) const {
  return tree_.nearest(x, std::numeric_limits<double>::max(),
                       [&](Index i) { return tree_.site(i).place != excluded; });
}

std::vector<double> nearest_neighbor_spacing(std::span<const Point2> points,
                                             const Progress& progress) {
  return NearestNeighborFunction(points).at_points(progress);
}

}  // namespace wellspaced
