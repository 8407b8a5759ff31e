// Rungs 2 and 3 of the predicates: the sign by integer arithmetic.
//
// Doubles are integers times powers of two. Brought to one scale, the predicates become
// determinants of integers, which no compiler flag can disturb. Rung 2 computes them in a fixed
// number of machine words, where the coordinates' bits span at most 119; it is the hot path on
// grids, circles and spheres. Rung 3 takes any finite doubles.
//
// All functions take the points' coordinates one after the other, the point that the others are
// taken relative to last.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "wellspaced/kernel/big_integer.hpp"
#include "wellspaced/kernel/bit_cast.hpp"
#include "wellspaced/kernel/fixed_integer.hpp"

// As in predicate_filter.hpp.
#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(precise, on, push)
#pragma clang fp contract(off)  // which the line above switches on
#endif

namespace wellspaced::exact {

// ---- The determinants, on coordinate differences, written once for every kind of number.
//
// The product a * b may be as wide as its factors (int64) or wider (Digits, BigInteger);
// wide_product never overflows. Why nothing else does, for differences of magnitude at most
//   2^kNarrowBits as int64: every sum but the last is below 2^63, the last below 2^127;
//   2^61 as Digits<1, 62>: a 2 x 2 minor and a sum of squares are columns below 2^125, their digits
//     below 2^62; in a 3 x 3 minor the columns are below 3 * 2^124, its digits below 2^62; in the
//     insphere determinant no column exceeds 4 * 1.75 * 2^124;
//   2^120 as Digits<2, 60>: likewise, with last digits below 2^61 (2 x 2), 3 * 2^60 (squares) and
//     3 * 2^61 (3 x 3), and no column of the last sum above 1.2 * 2^126.

struct Orient2d {
  static constexpr std::size_t kDimension = 2;
  static constexpr int kNarrowBits = 61;
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

/// a^2 - b^2, as the sum over the coordinates.
template <std::size_t Dimension>
struct CompareDistances {
  static constexpr std::size_t kDimension = Dimension;
  static constexpr int kNarrowBits = 61;
  template <class T>
  static int sign(const std::array<T, 2 * Dimension>& v) {
    auto sum = wide_product(v[0], v[0]) - wide_product(v[Dimension], v[Dimension]);
    for (std::size_t i = 1; i < Dimension; ++i)
      sum = sum + (wide_product(v[i], v[i]) - wide_product(v[Dimension + i], v[Dimension + i]));
    return sign_of(sum);
  }
};

/// The points minus the last one, coordinate by coordinate.
template <std::size_t Dimension, class Integer, std::size_t N>
auto differences(const std::array<Integer, N>& x) {
  std::array<Integer, N - Dimension> out;
  for (std::size_t i = 0; i < N - Dimension; ++i) out[i] = x[i] - x[N - Dimension + i % Dimension];
  return out;
}

// ---- Rung 2.

/// The largest biased exponent, at least `least`.
template <std::size_t N>
int largest_exponent(const std::array<double, N>& x, int least) {
  std::uint64_t largest = 0;
  for (const double value : x) {
    const std::uint64_t magnitude = bit_cast<std::uint64_t>(value) << 1;
    largest = magnitude > largest ? magnitude : largest;
  }
  const int biased = static_cast<int>(largest >> 53);
  return biased > least ? biased : least;
}

/// 2^(biased - 1023). Requires: 1 <= biased <= 2046.
inline double power_of_two(int biased) {
  return bit_cast<double>(static_cast<std::uint64_t>(biased) << 52);
}

/// The bits in which two doubles differ, the sign aside, in which only zeros differ here.
inline std::uint64_t changed_bits(double a, double b) {
  return (bit_cast<std::uint64_t>(a) ^ bit_cast<std::uint64_t>(b)) << 1;
}

// Doubles to integers at one scale, the largest to just below 2^60, or 2^119. Returns false if one
// would lose bits: then the way back gives other bits than it had, whatever lost them, be it
// rounding, underflow or a processor that flushes subnormals.

template <std::size_t N>
bool to_integers(const std::array<double, N>& x, std::array<std::int64_t, N>& out) {
  const int top = largest_exponent(x, 60);
  const double up = power_of_two(2105 - top), down = power_of_two(top - 59);
  std::uint64_t lost = 0;
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = static_cast<std::int64_t>(x[i] * up);
    lost |= changed_bits(x[i], static_cast<double>(out[i]) * down);
  }
  return lost == 0;
}

template <std::size_t N>
bool to_integers(const std::array<double, N>& x, std::array<Int128, N>& out) {
  const int top = largest_exponent(x, 120);
  const double up = power_of_two(2104 - top), down = power_of_two(top - 58);
  const double up_again = power_of_two(2164 - top), down_again = power_of_two(top - 118);
  std::uint64_t lost = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const auto high = static_cast<std::int64_t>(x[i] * up);
    const double high_part = static_cast<double>(high) * down;
    const auto low = static_cast<std::int64_t>((x[i] - high_part) * up_again);
    lost |= changed_bits(x[i], high_part + static_cast<double>(low) * down_again);
    out[i] = (Int128{high} << 60) + low;
  }
  return lost == 0;
}

inline int trailing_zeros(std::int64_t x) {
  return std::countr_zero(static_cast<std::uint64_t>(x));
}

inline int trailing_zeros(Int128 x) {
  const auto low = static_cast<std::int64_t>(x);
  return low != 0 ? trailing_zeros(low) : 64 + trailing_zeros(static_cast<std::int64_t>(x >> 64));
}

inline Digits<1, 62> one_digit(std::int64_t x) { return {{x}}; }

inline Digits<2, 60> two_digits(Int128 x) {
  return {{low_digit<60>(x), static_cast<std::int64_t>(x >> 60)}};
}

template <class Function, class Integer, std::size_t N>
auto map(Function f, const std::array<Integer, N>& x) {
  std::array<decltype(f(x[0])), N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = f(x[i]);
  return out;
}

template <class Integer, std::size_t N>
void shift_right(std::array<Integer, N>& x, int bits) {
  for (Integer& value : x) value >>= bits;
}

// Differences of magnitude at most 2^61. On grids they have many trailing zeros in common, and
// without these they are narrow.
template <class Determinant, std::size_t N>
int sign_of_differences(std::array<std::int64_t, N>& v) {
  std::int64_t any = 0;
  for (const std::int64_t value : v) any |= value;
  if (any == 0) return 0;
  const int zeros = trailing_zeros(any);
  if (zeros < 61 - Determinant::kNarrowBits) return Determinant::sign(map(one_digit, v));
  shift_right(v, zeros);
  return Determinant::sign(v);
}

// Differences below 2^120. Those of near points may well fit 61 bits.
template <class Determinant, std::size_t N>
int sign_of_differences(std::array<Int128, N>& v) {
  Int128 any = 0, magnitudes = 0;
  for (const Int128 value : v) {
    any |= value;
    magnitudes |= value ^ (value >> 127);
  }
  if (any == 0) return 0;
  const int zeros = trailing_zeros(any);
  if (((magnitudes >> zeros) >> 61) != 0) return Determinant::sign(map(two_digits, v));
  shift_right(v, zeros);
  auto narrow = map([](Int128 x) { return static_cast<std::int64_t>(x); }, v);
  return sign_of_differences<Determinant>(narrow);
}

/// The sign, or nothing if the coordinates' bits span more than 119, or where subnormals matter.
template <class Determinant, std::size_t N>
std::optional<int> fixed_sign(const std::array<double, N>& x) {
  constexpr std::size_t kDimension = Determinant::kDimension;
  std::array<std::int64_t, N> narrow;
  if (to_integers(x, narrow)) {
    auto v = differences<kDimension>(narrow);
    return sign_of_differences<Determinant>(v);
  }
  std::array<Int128, N> wide;
  if (to_integers(x, wide)) {
    auto v = differences<kDimension>(wide);
    return sign_of_differences<Determinant>(v);
  }
  return std::nullopt;
}

// ---- Rung 3.

/// The magnitude of a double is significand * 2^(exponent - 1075), significand < 2^53.
struct Parts {
  std::uint64_t significand = 0;
  int exponent = 0;  ///< the biased exponent, 1 for subnormals and 0
  bool negative = false;
};

inline Parts parts(double x) {
  const auto bits = bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52) & 0x7FF;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t implicit = std::uint64_t{biased != 0} << 52;
  return {fraction | implicit, biased + (biased == 0), (bits >> 63) != 0};
}

/// At the least exponent every finite double fits 2046 + 53 bits; 33 limbs also hold a difference.
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

template <std::size_t N>
std::array<BigCoordinate, N> big_coordinates(const std::array<double, N>& x) {
  const int exponent = smallest_exponent(x);
  return map([exponent](double value) { return big_coordinate(value, exponent); }, x);
}

/// The sign, for any finite doubles.
template <class Determinant, std::size_t N>
int big_sign(const std::array<double, N>& x) {
  return Determinant::sign(differences<Determinant::kDimension>(big_coordinates(x)));
}

// ---- Both.

template <class Determinant, std::size_t N>
int sign(const std::array<double, N>& x) {
  const std::optional<int> fixed = fixed_sign<Determinant>(x);
  return fixed ? *fixed : big_sign<Determinant>(x);
}

inline int compare_distances(const std::array<double, 6>& x) {
  return sign<CompareDistances<2>>(x);
}
inline int compare_distances(const std::array<double, 9>& x) {
  return sign<CompareDistances<3>>(x);
}
inline int orient2d(const std::array<double, 6>& x) { return sign<Orient2d>(x); }
inline int incircle(const std::array<double, 8>& x) { return sign<Incircle>(x); }
inline int orient3d(const std::array<double, 12>& x) { return sign<Orient3d>(x); }
inline int insphere(const std::array<double, 15>& x) { return sign<Insphere>(x); }

}  // namespace wellspaced::exact

#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(pop)
#endif
