// Whether points may be triangulated.
#pragma once

#include <cmath>
#include <span>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

inline bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }
inline bool is_finite(Point3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Whether all points are finite, and few enough to be ordered.
/// Errors: kInvalidGeometry for a NaN or infinite coordinate (ids: the points); kLimit beyond
/// kMaxOrderedPoints.
Status check_points(std::span<const Point2> points);
Status check_points(std::span<const Point3> points);

}  // namespace wellspaced
