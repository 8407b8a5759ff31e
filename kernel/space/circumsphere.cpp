#include "wellspaced/kernel/space/circumsphere.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// Half a difference times a power of two: neither overflows nor loses bits that matter.
Point3 scaled_half_difference(Point3 a, Point3 b, int exponent) {
  const auto scaled = [exponent](double u, double v) {
    return std::ldexp(u / 2, exponent) - std::ldexp(v / 2, exponent);
  };
  return {scaled(a.x, b.x), scaled(a.y, b.y), scaled(a.z, b.z)};
}

double largest(Point3 a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }

}  // namespace

Result<Sphere> circumsphere(Point3 a, Point3 b, Point3 c, Point3 d) {
  if (orient3d(a, b, c, d) == 0)
    return Error{ErrorCode::kInvalidGeometry, "coplanar points have no circumsphere", {}};
  // Scaled so that the longest edge at a is about 1.
  const double size =
      std::max({largest(scaled_half_difference(b, a, 0)), largest(scaled_half_difference(c, a, 0)),
                largest(scaled_half_difference(d, a, 0)), 0x1p-1074});
  const int exponent = -std::ilogb(size);
  const Point3 u = scaled_half_difference(b, a, exponent);
  const Point3 v = scaled_half_difference(c, a, exponent);
  const Point3 w = scaled_half_difference(d, a, exponent);
  const Point3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), volume = dot(u, vw);
  // The offset of the centre from a is this over the volume: u is half an edge.
  const Point3 offset{(uu * vw.x + vv * wu.x + ww * uv.x) / volume,
                      (uu * vw.y + vv * wu.y + ww * uv.y) / volume,
                      (uu * vw.z + vv * wu.z + ww * uv.z) / volume};
  const Sphere sphere{{a.x + std::ldexp(offset.x, -exponent), a.y + std::ldexp(offset.y, -exponent),
                       a.z + std::ldexp(offset.z, -exponent)},
                      std::ldexp(std::sqrt(dot(offset, offset)), -exponent)};
  if (!std::isfinite(largest(sphere.centre)) || !std::isfinite(sphere.radius) || sphere.radius == 0)
    return Error{
        ErrorCode::kInvalidGeometry, "the circumsphere is beyond the range of doubles", {}};
  return sphere;
}

}  // namespace wellspaced
