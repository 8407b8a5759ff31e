// Which of two weighted sites is nearer to a point, exactly.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A site whose distance from a point x counts as weight + |place - x|: a cone over the plane.
struct WeightedSite {
  Point2 place;
  double weight = 0;
};

/// The weighted distance of x from a site, within 3 units in the last place.
double weighted_distance(const WeightedSite& site, Point2 x);

/// The sign of (a.weight + |a.place - x|) - (b.weight + |b.place - x|): negative when a is nearer
/// to x than b. Exact for all finite doubles; exchanging a and b reverses it.
int weighted_distance_order(const WeightedSite& a, const WeightedSite& b, Point2 x);

}  // namespace wellspaced
