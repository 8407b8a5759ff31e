// Rungs 2 and 3 of the predicates: the sign by integer arithmetic.
//
// Doubles are integers times powers of two. Brought to one common exponent, the predicates become
// determinants of integers, which no compiler flag can disturb. Rung 2 does them in a fixed number
// of machine words where the coordinates' significant bits span at most 125; it is the hot path on
// grids and cocircular points. Rung 3 takes any finite doubles.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "wellspaced/kernel/big_integer.hpp"
#include "wellspaced/kernel/fixed_integer.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::exact {

/// The magnitude of a double is significand * 2^(exponent - 1075), significand < 2^53.
struct Parts {
  std::uint64_t significand = 0;
  int exponent = 0;  ///< the biased exponent, 1 for subnormals and 0
  bool negative = false;
};

inline Parts parts(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52) & 0x7FF;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t implicit = std::uint64_t{biased != 0} << 52;
  return {fraction | implicit, biased + (biased == 0), (bits >> 63) != 0};
}

/// The largest biased exponent.
template <std::size_t N>
int largest_exponent(const std::array<double, N>& x) {
  std::uint64_t largest = 0;
  for (const double value : x) {
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(value) << 1;
    largest = magnitude > largest ? magnitude : largest;
  }
  const int biased = static_cast<int>(largest >> 53);
  return biased + (biased == 0);
}

/// Doubles as integers of `Bits` bits at the exponent of the largest: false if one has bits below.
template <int Bits, class Integer, std::size_t N>
bool to_integers(const std::array<double, N>& x, std::array<Integer, N>& out) {
  const int top = largest_exponent(x);
  Integer lost = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const Parts part = parts(x[i]);
    const Integer whole = static_cast<Integer>(part.significand) << (Bits - 53);
    const int shift = top - part.exponent < Bits ? top - part.exponent : Bits;
    const Integer kept = whole >> shift;
    lost |= whole ^ (kept << shift);
    const Integer sign = -static_cast<Integer>(part.negative);
    out[i] = (kept ^ sign) - sign;
  }
  return lost == 0;
}

/// The points minus the last one, coordinate by coordinate.
template <std::size_t Dimension, class Integer, std::size_t N>
auto differences(const std::array<Integer, N>& x) {
  std::array<Integer, N - Dimension> out;
  for (std::size_t i = 0; i < N - Dimension; ++i) out[i] = x[i] - x[N - Dimension + i % Dimension];
  return out;
}

inline int trailing_zeros(std::int64_t x) {
  return std::countr_zero(static_cast<std::uint64_t>(x));
}

inline int trailing_zeros(Int128 x) {
  const auto low = static_cast<std::int64_t>(x);
  return low != 0 ? trailing_zeros(low) : 64 + trailing_zeros(static_cast<std::int64_t>(x >> 64));
}

/// True if every x fits `bits` bits and a sign.
template <class Integer, std::size_t N>
bool fit(const std::array<Integer, N>& x, int bits) {
  Integer magnitudes = 0;
  for (const Integer value : x) magnitudes |= value ^ (value >> (sizeof(Integer) * 8 - 1));
  return (magnitudes >> bits) == 0;
}

/// Divides by the largest power of two that divides all, which changes no sign of a determinant
/// that is homogeneous. Returns false if all are 0.
template <class Integer, std::size_t N>
bool remove_common_factor(std::array<Integer, N>& x) {
  Integer any = 0;
  for (const Integer value : x) any |= value;
  if (any == 0) return false;
  const int zeros = trailing_zeros(any);
  for (Integer& value : x) value >>= zeros;
  return true;
}

template <class Integer, std::size_t N>
auto fixed_integers(const std::array<Integer, N>& x) {
  std::array<decltype(fixed_integer(x[0])), N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = fixed_integer(x[i]);
  return out;
}

// The determinants on differences, written once for every kind of number. A product `a * b` may be
// as wide as its factors (int64) or wider (FixedInteger, BigInteger); wide_product is always exact.
// kNarrowBits is the width up to which int64 differences leave room for all but the last product.

struct Orient2d {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 62;
  template <class T>
  static int sign(const std::array<T, 4>& v) {
    const auto& [ax, ay, bx, by] = v;
    return sign_of(wide_product(ax, by) - wide_product(ay, bx));
  }
};

struct Incircle {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 30;
  template <class T>
  static int sign(const std::array<T, 6>& v) {
    const auto& [ax, ay, bx, by, cx, cy] = v;
    return sign_of(wide_product(ax * ax + ay * ay, bx * cy - by * cx) +
                   wide_product(bx * bx + by * by, cx * ay - cy * ax) +
                   wide_product(cx * cx + cy * cy, ax * by - ay * bx));
  }
};

struct Orient3d {
  static constexpr std::size_t kDimension = 3;
  static constexpr int kNarrowBits = 30;
  template <class T>
  static int sign(const std::array<T, 9>& v) {
    const auto& [ax, ay, az, bx, by, bz, cx, cy, cz] = v;
    return sign_of(wide_product(by * cz - bz * cy, ax) + wide_product(cy * az - cz * ay, bx) +
                   wide_product(ay * bz - az * by, cx));
  }
};

struct Insphere {
  static constexpr std::size_t kDimension = 3;
  static constexpr int kNarrowBits = 20;
  template <class T>
  static int sign(const std::array<T, 12>& v) {
    const auto& [ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz] = v;
    const auto ab = ax * by - ay * bx;
    const auto bc = bx * cy - by * cx;
    const auto cd = cx * dy - cy * dx;
    const auto da = dx * ay - dy * ax;
    const auto ac = ax * cy - ay * cx;
    const auto bd = bx * dy - by * dx;
    const auto abc = bc * az - ac * bz + ab * cz;
    const auto bcd = cd * bz - bd * cz + bc * dz;
    const auto cda = da * cz + ac * dz + cd * az;
    const auto dab = ab * dz + bd * az + da * bz;
    return sign_of(wide_product(abc, dx * dx + dy * dy + dz * dz) -
                   wide_product(dab, cx * cx + cy * cy + cz * cz) +
                   wide_product(cda, bx * bx + by * by + bz * bz) -
                   wide_product(bcd, ax * ax + ay * ay + az * az));
  }
};

template <class Determinant, std::size_t N>
int sign_of_differences(std::array<std::int64_t, N> v) {
  if (!remove_common_factor(v)) return 0;
  if (fit(v, Determinant::kNarrowBits)) return Determinant::sign(v);
  return Determinant::sign(fixed_integers(v));
}

template <class Determinant, std::size_t N>
int sign_of_differences(std::array<Int128, N> v) {
  if (!remove_common_factor(v)) return 0;
  if (!fit(v, 62)) return Determinant::sign(fixed_integers(v));
  std::array<std::int64_t, N> narrow;
  for (std::size_t i = 0; i < N; ++i) narrow[i] = static_cast<std::int64_t>(v[i]);
  return sign_of_differences<Determinant>(narrow);
}

/// Rung 2: nothing if the coordinates' bits span more than 125.
template <class Determinant, std::size_t N>
std::optional<int> fixed_sign(const std::array<double, N>& x) {
  constexpr std::size_t kDimension = Determinant::kDimension;
  std::array<std::int64_t, N> narrow;
  if (to_integers<61>(x, narrow)) {
    return sign_of_differences<Determinant>(differences<kDimension>(narrow));
  }
  std::array<Int128, N> wide;
  if (to_integers<125>(x, wide)) {
    return sign_of_differences<Determinant>(differences<kDimension>(wide));
  }
  return std::nullopt;
}

/// 2046 + 53 bits hold every finite double at the least exponent; 33 limbs also hold a difference.
using BigCoordinate = BigInteger<33>;

inline BigCoordinate big_coordinate(double x, int exponent) {
  const Parts part = parts(x);
  if (part.significand == 0) return {};
  return BigCoordinate::shifted(part.negative, part.significand, part.exponent - exponent);
}

/// The least biased exponent of those that are not 0.
template <std::size_t N>
int smallest_exponent(const std::array<double, N>& x) {
  int smallest = 2046;
  for (const double value : x) {
    const Parts part = parts(value);
    if (part.significand != 0 && part.exponent < smallest) smallest = part.exponent;
  }
  return smallest;
}

/// Rung 3: any finite doubles.
template <class Determinant, std::size_t N>
int big_sign(const std::array<double, N>& x) {
  const int exponent = smallest_exponent(x);
  std::array<BigCoordinate, N> integers;
  for (std::size_t i = 0; i < N; ++i) integers[i] = big_coordinate(x[i], exponent);
  return Determinant::sign(differences<Determinant::kDimension>(integers));
}

template <class Determinant, std::size_t N>
int sign(const std::array<double, N>& x) {
  const std::optional<int> fixed = fixed_sign<Determinant>(x);
  return fixed ? *fixed : big_sign<Determinant>(x);
}

inline int orient2d(Point2 a, Point2 b, Point2 c) {
  return sign<Orient2d>(std::array{a.x, a.y, b.x, b.y, c.x, c.y});
}

inline int incircle(Point2 a, Point2 b, Point2 c, Point2 d) {
  return sign<Incircle>(std::array{a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
}

inline int orient3d(Point3 a, Point3 b, Point3 c, Point3 d) {
  return sign<Orient3d>(std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
}

inline int insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) {
  return sign<Insphere>(
      std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z});
}

}  // namespace wellspaced::exact
