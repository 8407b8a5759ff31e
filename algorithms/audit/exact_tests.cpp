#include "wellspaced/algorithms/audit/exact_tests.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced::audit {
namespace {

// Polynomials in differences to the last point, written for every kind of number that the kernel's
// exact arithmetic has.

struct ScalarProduct {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 62;
  template <class T>
  static int sign(const std::array<T, 4>& v) {
    const auto& [px, py, qx, qy] = v;
    return sign_of(wide_product(px, qx) + wide_product(py, qy));
  }
};

// With p, q, b, c relative to a, the circumcentre is (x, y) / (2 b x c). Its side times 2 b x c is
// 2 (b x c) (p x q) + (q - p) x (x, y).
struct CircumcentreSide {
  static constexpr std::size_t kDimension = 2;
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
// roundings, so 2^-46 of the sum of their magnitudes, the size, bounds the error. A product that
// underflows on the way errs by 2^-1074 times at most three differences, which is nothing beside
// that as long as no difference is huge and the size is not tiny.
int circumcentre_side_by_filter(const std::array<double, 8>& v) {
  double largest = 0;
  for (const double d : v) largest = std::max(largest, std::fabs(d));
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
  if (!(largest < 0x1p200 && size > 0x1p-400)) return 0;
  return predicate_filter::certified_sign(side, 0x1p-46 * size);
}

// Vectors of any kind of number.
template <class T>
struct Vector {
  T x, y, z;
};
template <class T>
Vector(T, T, T) -> Vector<T>;  // not implied before clang 17

template <class T>
auto cross(const Vector<T>& a, const Vector<T>& b) {
  return Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T, class U>
auto dot(const Vector<T>& a, const Vector<U>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T, class U>
auto scaled(const T& factor, const Vector<U>& a) {
  return Vector{factor * a.x, factor * a.y, factor * a.z};
}

// With p, q, r, b, c, d relative to a, the circumcentre is n / (2 b . c x d), and its side of the
// plane with normal m, times that, is m . n - 2 (b . c x d) (p . q x r).
struct CircumcentreSide3 {
  static constexpr std::size_t kDimension = 3;
  template <class T>
  static auto value(const std::array<T, 18>& v) {
    const Vector<T> p{v[0], v[1], v[2]}, q{v[3], v[4], v[5]}, r{v[6], v[7], v[8]};
    const Vector<T> b{v[9], v[10], v[11]}, c{v[12], v[13], v[14]}, d{v[15], v[16], v[17]};
    const auto c_d = cross(c, d), d_b = cross(d, b), b_c = cross(b, c), q_r = cross(q, r);
    const auto m = q_r + cross(r, p) + cross(p, q);
    const auto n = scaled(dot(b, b), c_d) + scaled(dot(c, c), d_b) + scaled(dot(d, d), b_c);
    const auto half = dot(c_d, b) * dot(q_r, p);
    return dot(m, n) - (half + half);
  }
  template <class T>
  static int sign(const std::array<T, 18>& v) {
    return sign_of(value(v));
  }
};

// With b, c, d relative to a and n = b x c, the centre is (|c|^2 n x b + |b|^2 c x n) / (2 |n|^2).
struct FaceSphereSide {
  static constexpr std::size_t kDimension = 3;
  template <class T>
  static auto value(const std::array<T, 9>& v) {
    const Vector<T> b{v[0], v[1], v[2]}, c{v[3], v[4], v[5]}, d{v[6], v[7], v[8]};
    const auto n = cross(b, c);
    const auto towards =
        dot(c, c) * dot(cross_wide(n, b), d) - dot(b, b) * dot(cross_wide(n, c), d);
    return towards - dot(n, n) * dot(d, d);
  }
  template <class T>
  static int sign(const std::array<T, 9>& v) {
    return sign_of(value(v));
  }

 private:
  template <class T, class U>
  static auto cross_wide(const Vector<T>& a, const Vector<U>& b) {
    return Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

// A product of 6 differences is reached through at most 24 roundings; there are fewer than 2^10
// products in a polynomial, each at most the sixth power of the largest difference, so 2^-36 of
// that power bounds the error, if it neither overflows nor vanishes.
bool bounds_degree_6(double largest) { return largest > 0x1p-100 && largest < 0x1p100; }
double bound_of_degree_6(double largest) {
  const double cube = largest * largest * largest;
  return 0x1p-36 * cube * cube;
}

double largest_of(const std::array<Point3, 3>& vectors) {
  double largest = 0;
  for (const Point3& v : vectors)
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return largest;
}

}  // namespace

int exact_angle_sign(Point2 apex, Point2 p, Point2 q) {
  return exact::sign<ScalarProduct>(std::array{p.x, p.y, q.x, q.y, apex.x, apex.y});
}

int circumcentre_side(Point2 p, Point2 q, Point2 a, Point2 b, Point2 c) {
  const int sign = circumcentre_side_by_filter(
      {p.x - a.x, p.y - a.y, q.x - a.x, q.y - a.y, b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y});
  if (sign != 0) return sign;
  return exact::big_sign<CircumcentreSide>(
      std::array{p.x, p.y, q.x, q.y, b.x, b.y, c.x, c.y, a.x, a.y});
}

Circumcentre3::Circumcentre3(const std::array<Point3, 4>& tet) : tet_(tet) {
  const Point3 b = tet[1] - tet[0], c = tet[2] - tet[0], d = tet[3] - tet[0];
  const Point3 c_d = wellspaced::cross(c, d);
  numerator_ = wellspaced::dot(b, b) * c_d + wellspaced::dot(c, c) * wellspaced::cross(d, b) +
               wellspaced::dot(d, d) * wellspaced::cross(b, c);
  volume_ = wellspaced::dot(c_d, b);
  largest_ = largest_of({b, c, d});
}

int Circumcentre3::side(const std::array<Point3, 3>& plane) const {
  const Point3 a = tet_[0], p = plane[0] - a, q = plane[1] - a, r = plane[2] - a;
  const double largest = std::max(largest_, largest_of({p, q, r}));
  if (bounds_degree_6(largest)) {
    const Point3 q_r = wellspaced::cross(q, r);
    const Point3 m = q_r + wellspaced::cross(r, p) + wellspaced::cross(p, q);
    const double half = volume_ * wellspaced::dot(q_r, p);
    const int sign = predicate_filter::certified_sign(
        wellspaced::dot(m, numerator_) - (half + half), bound_of_degree_6(largest));
    if (sign != 0) return sign;
  }
  const auto& [u, v, w] = plane;
  const auto& [o, b, c, d] = tet_;
  return exact::big_sign<CircumcentreSide3>(std::array{u.x, u.y, u.z, v.x, v.y, v.z, w.x,
                                                       w.y, w.z, b.x, b.y, b.z, c.x, c.y,
                                                       c.z, d.x, d.y, d.z, o.x, o.y, o.z});
}

int face_sphere_side(Point3 a, Point3 b, Point3 c, Point3 d) {
  const double largest = largest_of({b - a, c - a, d - a});
  const std::array coordinates{b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, a.x, a.y, a.z};
  if (bounds_degree_6(largest)) {
    const double value =
        FaceSphereSide::value(exact::differences<FaceSphereSide::kDimension>(coordinates));
    const int sign = predicate_filter::certified_sign(value, bound_of_degree_6(largest));
    if (sign != 0) return sign;
  }
  return exact::big_sign<FaceSphereSide>(coordinates);
}

}  // namespace wellspaced::audit
