// What the measures of triangles and of tetrahedra have in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "wellspaced/algorithms/audit/vectors.hpp"

namespace wellspaced::audit {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kPi = 3.141592653589793;

/// A quotient of a positive number and one that may vanish.
inline double ratio(double a, double b) { return b > 0 ? a / b : kInfinity; }

/// A power of two, 2^-1000 to 2^1000, that brings a magnitude near 1. Requires: it is positive.
inline double scale_to_one(double magnitude) {
  return std::ldexp(1.0, -std::clamp(std::ilogb(magnitude), -1000, 1000));
}

/// The same for coordinates whose powers might overflow or vanish; else 1.
inline double scale_for(double magnitude) {
  if (magnitude == 0 || (magnitude > 0x1p-100 && magnitude < 0x1p100)) return 1;
  return scale_to_one(magnitude);
}

/// That for the largest coordinate of some points.
template <class Points>
double scale_of(const Points& points) {
  double largest = 0;
  for (const auto& p : points)
    for (const double x : coordinates_of(p)) largest = std::max(largest, std::fabs(x));
  return scale_for(largest);
}

}  // namespace wellspaced::audit
