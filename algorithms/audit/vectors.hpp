// Places as coordinate arrays, for what is written once for the plane and for space.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

template <std::size_t D>
using Vec = std::array<double, D>;

inline Vec<2> coordinates_of(Point2 p) { return {p.x, p.y}; }
inline Vec<3> coordinates_of(Point3 p) { return {p.x, p.y, p.z}; }
inline Point2 point_at(const Vec<2>& v) { return {v[0], v[1]}; }
inline Point3 point_at(const Vec<3>& v) { return {v[0], v[1], v[2]}; }

template <std::size_t D>
Vec<D> difference(const Vec<D>& a, const Vec<D>& b) {
  Vec<D> v;
  for (std::size_t i = 0; i < D; ++i) v[i] = a[i] - b[i];
  return v;
}

/// a + t b
template <std::size_t D>
Vec<D> step(const Vec<D>& a, double t, const Vec<D>& b) {
  Vec<D> v;
  for (std::size_t i = 0; i < D; ++i) v[i] = a[i] + t * b[i];
  return v;
}

template <std::size_t D>
double product(const Vec<D>& a, const Vec<D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t D>
double norm(const Vec<D>& a) {
  return std::sqrt(product(a, a));
}

template <std::size_t D>
double distance_of(const Vec<D>& a, const Vec<D>& b) {
  return norm(difference(a, b));
}

inline Vec<3> cross_product(const Vec<3>& a, const Vec<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace wellspaced::audit
