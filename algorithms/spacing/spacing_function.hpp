// Spacing functions: how far apart the points of a mesh are, or are to be, at every place.
//
// Two kinds, taken everywhere alike: one value a node (a span of doubles), and a function of the
// place. Either may come from this folder or from the user:
//
//   function                               Lipschitz constant                          header
//   NN, the nearest neighbour (2.2.4)      1, Euclidean                     nearest_neighbor.hpp
//   el, the longest edge (2.1.2)           none: it jumps from triangle to triangle edge_length.hpp
//   half the shortest edge (8.3)           1/2, along edges                    graph_spacing.hpp
//   f_{g,C,P}, coarsened (5.3.2)           1: Euclidean                    euclidean_spacing.hpp
//                                          1: inside the domain             geodesic_spacing.hpp
//                                          1: along edges, mu otherwise        graph_spacing.hpp
//   t_{g,C,P}, threshold (5.3.3)           that of g, at least              threshold_spacing.hpp
//   lfs, the local feature size (2.2.5)    1                            local_feature_size.hpp
//
// A function of the user's needs no Lipschitz constant: its coarsening function has one.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A spacing at every place of a domain, > 0.
using SpacingFunction = std::function<double(Point2)>;

/// A function's values at some points.
inline std::vector<double> sampled(const SpacingFunction& function,
                                   std::span<const Point2> points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Point2 p : points) values.push_back(function(p));
  return values;
}

/// The product factor * g, one value a node.
inline std::vector<double> scaled(std::span<const double> g, double factor) {
  std::vector<double> values(g.begin(), g.end());
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace wellspaced
