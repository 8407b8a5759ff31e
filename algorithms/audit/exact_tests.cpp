#include "wellspaced/algorithms/audit/exact_tests.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

namespace wellspaced::audit {
namespace {

// Polynomials in differences to the last point, written for every kind of number that the kernel's
// exact arithmetic has. Up to kNarrowBits, 64 bits hold all but the last product.

struct ScalarProduct {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 62;
  template <class T>
  static int sign(const std::array<T, 4>& v) {
    const auto& [px, py, qx, qy] = v;
    return sign_of(wide_product(px, qx) + wide_product(py, qy));
  }
};

struct DifferenceOfSquares {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 61;
  template <class T>
  static int sign(const std::array<T, 4>& v) {
    const auto& [ux, uy, vx, vy] = v;
    return sign_of((wide_product(ux, ux) + wide_product(uy, uy)) -
                   (wide_product(vx, vx) + wide_product(vy, vy)));
  }
};

// With p, q, b, c relative to a, the circumcentre is (x, y) / (2 b x c). Its side times 2 b x c is
// 2 (b x c) (p x q) + (q - p) x (x, y).
struct CircumcentreSide {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 19;
  template <class T>
  static int sign(const std::array<T, 8>& v) {
    const auto& [px, py, qx, qy, bx, by, cx, cy] = v;
    const auto b_sq = bx * bx + by * by;
    const auto c_sq = cx * cx + cy * cy;
    const auto x = b_sq * cy - c_sq * by;
    const auto y = c_sq * bx - b_sq * cx;
    const auto half = wide_product(bx * cy - by * cx, px * qy - py * qx);
    const auto q_cross = wide_product(y, qx) - wide_product(x, qy);
    const auto p_cross = wide_product(y, px) - wide_product(x, py);
    return sign_of((half + half) + (q_cross - p_cross));
  }
};

// The same in floating point, or 0 for "cannot tell". Every product is reached through at most 12
// roundings, so 2^-46 of the sum of their magnitudes bounds the error, as long as the differences
// are neither so small nor so large that something under- or overflows.
int circumcentre_side_by_filter(const std::array<double, 8>& v) {
  for (const double d : v)
    if (d != 0 && !(std::fabs(d) > 0x1p-200 && std::fabs(d) < 0x1p200)) return 0;
  const auto [px, py, qx, qy, bx, by, cx, cy] = v;
  const double b_sq = bx * bx + by * by, c_sq = cx * cx + cy * cy;
  const double area = bx * cy - by * cx, offset = px * qy - py * qx;
  const double x = b_sq * cy - c_sq * by, y = c_sq * bx - b_sq * cx;
  const double side = 2 * area * offset + (y * (qx - px) - x * (qy - py));
  const double area_size = std::fabs(bx * cy) + std::fabs(by * cx);
  const double offset_size = std::fabs(px * qy) + std::fabs(py * qx);
  const double x_size = b_sq * std::fabs(cy) + c_sq * std::fabs(by);
  const double y_size = b_sq * std::fabs(cx) + c_sq * std::fabs(bx);
  const double size = 2 * area_size * offset_size + y_size * (std::fabs(qx) + std::fabs(px)) +
                      x_size * (std::fabs(qy) + std::fabs(py));
  return predicate_filter::certified_sign(side, 0x1p-46 * size);
}

}  // namespace

int exact_angle_sign(Point2 apex, Point2 p, Point2 q) {
  return exact::sign<ScalarProduct>(std::array{p.x, p.y, q.x, q.y, apex.x, apex.y});
}

int bisector_side(Point2 u, Point2 v, Point2 x) {
  const double ux = u.x - x.x, uy = u.y - x.y, vx = v.x - x.x, vy = v.y - x.y;
  const double u_sq = ux * ux + uy * uy, v_sq = vx * vx + vy * vy;
  const int sign =
      predicate_filter::certified_sign(u_sq - v_sq, 0x1p-48 * (u_sq + v_sq) + 0x1p-1000);
  if (sign != 0) return sign;
  return exact::sign<DifferenceOfSquares>(std::array{u.x, u.y, v.x, v.y, x.x, x.y});
}

int circumcentre_side(Point2 p, Point2 q, Point2 a, Point2 b, Point2 c) {
  const int sign = circumcentre_side_by_filter(
      {p.x - a.x, p.y - a.y, q.x - a.x, q.y - a.y, b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y});
  if (sign != 0) return sign;
  return exact::sign<CircumcentreSide>(
      std::array{p.x, p.y, q.x, q.y, b.x, b.y, c.x, c.y, a.x, a.y});
}

}  // namespace wellspaced::audit
