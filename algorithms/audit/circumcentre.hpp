// Circumcentres with a bound on their error.
#pragma once

#include <array>
#include <cmath>
#include <tuple>

#include "wellspaced/algorithms/audit/shape_tools.hpp"
#include "wellspaced/algorithms/audit/twofold.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"

namespace wellspaced::audit {

/// A centre, and how far the true one may be from it; infinite where nothing is known.
template <std::size_t D>
struct RoundedCentre {
  Vec<D> place{};
  double error = 0;
};

/// The offset of a circumcentre from the first corner, and the determinant of the edges from there.
template <std::size_t D>
struct CentreOffset {
  Vec<D> offset{};
  double determinant = 0;
};

template <class T, std::size_t D>
using EdgeVectors = std::array<std::array<T, D>, D>;

template <class T>
CentreOffset<2> centre_offset(const EdgeVectors<T, 2>& edges) {
  const auto& [b, c] = edges;
  const T bb = b[0] * b[0] + b[1] * b[1], cc = c[0] * c[0] + c[1] * c[1];
  const double determinant = value_of(b[0] * c[1] - b[1] * c[0]), twice = 2 * determinant;
  return {{value_of(c[1] * bb - b[1] * cc) / twice, value_of(b[0] * cc - c[0] * bb) / twice},
          determinant};
}

template <class T>
CentreOffset<3> centre_offset(const EdgeVectors<T, 3>& edges) {
  const auto& [b, c, d] = edges;
  const auto dot = [](const auto& u, const auto& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto cross = [](const auto& u, const auto& v) {
    return std::array<T, 3>{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                            u[0] * v[1] - u[1] * v[0]};
  };
  const T bb = dot(b, b), cc = dot(c, c), dd = dot(d, d);
  const auto cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
  CentreOffset<3> result;
  result.determinant = value_of(dot(b, cd));
  for (std::size_t i = 0; i < 3; ++i)
    result.offset[i] = value_of(bb * cd[i] + cc * db[i] + dd * bc[i]) / (2 * result.determinant);
  return result;
}

/// The centre computed with numbers of type T, of the given relative precision. The numerators err
/// by the product of the edges' lengths times their sum, the determinant by the product, each times
/// the precision; together with a last rounding.
template <class T, std::size_t D>
RoundedCentre<D> circumcentre_by(const std::array<Vec<D>, D + 1>& corners, double precision) {
  EdgeVectors<T, D> edges;
  double volume = 1, perimeter = 0;
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t i = 0; i < D; ++i)
      edges[k][i] = difference_of<T>(corners[k + 1][i], corners[0][i]);
    const double length = distance_of(corners[k + 1], corners[0]);
    volume *= length, perimeter += length;
  }
  const auto [offset, determinant] = centre_offset<T>(edges);
  const double size = std::fabs(determinant), noise = precision * volume;
  const double reach = norm(offset);
  if (!(noise < size / 2) || !std::isfinite(reach)) return {corners[0], kInfinity};
  return {step(corners[0], 1, offset),
          2 * noise / size * (perimeter + reach) + 0x1p-48 * (reach + norm(corners[0]))};
}

/// The centre of the circle or sphere through the corners: in doubles, or more precisely where
/// these do not tell it to a millionth of the edges.
template <std::size_t D>
RoundedCentre<D> circumcentre(const std::array<Vec<D>, D + 1>& corners) {
  const RoundedCentre<D> centre = circumcentre_by<double, D>(corners, 0x1p-46);
  if (centre.error < 0x1p-20 * distance_of(corners[1], corners[0])) return centre;
  return circumcentre_by<Twofold, D>(corners, 0x1p-92);
}

}  // namespace wellspaced::audit
