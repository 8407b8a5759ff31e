// An edge in units of its own length, to be asked about many points near it.
#pragma once

#include <array>
#include <cmath>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Requires: a != b. No product over- or underflows.
struct MeasuredEdge {
  Point2 a, b;
  double length = distance(a, b);

  bool has_in_diametral_circle(Point2 p) const {
    const double ax = (a.x - p.x) / length, ay = (a.y - p.y) / length;
    const double bx = (b.x - p.x) / length, by = (b.y - p.y) / length;
    return ax * bx + ay * by < 0;
  }
  bool has_between_perpendiculars(Point2 p) const {
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    return ux * (p.x - a.x) + uy * (p.y - a.y) > 0 && ux * (p.x - b.x) + uy * (p.y - b.y) < 0;
  }
  double distance_of_line_from(Point2 p) const {
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    return std::fabs(ux * (p.y - a.y) - uy * (p.x - a.x));
  }
  /// A box around all points nearer than margin * length to the edge.
  Box2 box_with_margin(double margin) const {
    const Box2 box = Box2::around(std::array{a, b});
    const double m = margin * length;
    return {{box.low.x - m, box.low.y - m}, {box.high.x + m, box.high.y + m}};
  }
};

}  // namespace wellspaced
