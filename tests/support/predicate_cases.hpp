// Each predicate as a case: its points as one array of coordinates, its rungs, a slow reference of
// its own, and seeded generators of lines that are hard for it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "tests/support/slow_integer.hpp"
#include "wellspaced/kernel/exact_predicates.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

// The same lines under every flag; as in predicate_filter.hpp.
#ifdef __clang__
#pragma float_control(precise, on, push)
#endif

namespace wellspaced::testing {

// ---- The reference: determinants of the points themselves, with a column of ones, not of
// differences as in the library.

/// The exponent of the lowest bit that any of the coordinates may have.
template <std::size_t N>
int lowest_exponent(const std::array<double, N>& x) {
  int lowest = 1024;
  for (const double value : x) {
    if (value != 0) lowest = std::min(lowest, std::max(std::ilogb(value) - 52, -1074));
  }
  return lowest;
}

/// One row a point: its coordinates, its squared length if asked for, 1.
enum class Rows { kFlat, kLifted };

template <std::size_t Dimension, std::size_t N>
int slow_sign(const std::array<double, N>& x, Rows rows) {
  const int unit = lowest_exponent(x);
  SlowMatrix matrix;
  for (std::size_t i = 0; i < N; i += Dimension) {
    std::vector<SlowInteger> row;
    SlowInteger lift;
    for (std::size_t k = 0; k < Dimension; ++k) {
      row.push_back(SlowInteger::from_double(x[i + k], unit));
      lift = lift + row.back() * row.back();
    }
    if (rows == Rows::kLifted) row.push_back(lift);
    row.push_back(1);
    matrix.push_back(row);
  }
  return slow_determinant(matrix).sign();
}

// ---- The cases.

template <std::size_t Dimension, std::size_t Points, class D>
struct PredicateCase {
  static constexpr std::size_t kDimension = Dimension;
  static constexpr std::size_t kPoints = Points;
  using Determinant = D;
  using Coordinates = std::array<double, Dimension * Points>;

  static std::optional<int> fixed(const Coordinates& x) { return exact::fixed_sign<D>(x); }
  static int big(const Coordinates& x) { return exact::big_sign<D>(x); }
};

inline Point2 point2(const double* x) { return {x[0], x[1]}; }
inline Point3 point3(const double* x) { return {x[0], x[1], x[2]}; }

struct Orient2dCase : PredicateCase<2, 3, exact::Orient2d> {
  static constexpr const char* kName = "orient2d";
  static constexpr Rows kRows = Rows::kFlat;
  template <class F>
  static int apply(F f, const Coordinates& x) {
    return f(point2(&x[0]), point2(&x[2]), point2(&x[4]));
  }
  static int filter(const Coordinates& x) { return apply(predicate_filter::orient2d, x); }
  static int sign(const Coordinates& x) {
    return orient2d(point2(&x[0]), point2(&x[2]), point2(&x[4]));
  }
};

struct IncircleCase : PredicateCase<2, 4, exact::Incircle> {
  static constexpr const char* kName = "incircle";
  static constexpr Rows kRows = Rows::kLifted;
  template <class F>
  static int apply(F f, const Coordinates& x) {
    return f(point2(&x[0]), point2(&x[2]), point2(&x[4]), point2(&x[6]));
  }
  static int filter(const Coordinates& x) { return apply(predicate_filter::incircle, x); }
  static int sign(const Coordinates& x) { return apply(incircle, x); }
};

struct Orient3dCase : PredicateCase<3, 4, exact::Orient3d> {
  static constexpr const char* kName = "orient3d";
  static constexpr Rows kRows = Rows::kFlat;
  template <class F>
  static int apply(F f, const Coordinates& x) {
    return f(point3(&x[0]), point3(&x[3]), point3(&x[6]), point3(&x[9]));
  }
  static int filter(const Coordinates& x) { return apply(predicate_filter::orient3d, x); }
  static int sign(const Coordinates& x) { return apply(orient3d, x); }
};

struct InsphereCase : PredicateCase<3, 5, exact::Insphere> {
  static constexpr const char* kName = "insphere";
  static constexpr Rows kRows = Rows::kLifted;
  template <class F>
  static int apply(F f, const Coordinates& x) {
    return f(point3(&x[0]), point3(&x[3]), point3(&x[6]), point3(&x[9]), point3(&x[12]));
  }
  static int filter(const Coordinates& x) { return apply(predicate_filter::insphere, x); }
  static int sign(const Coordinates& x) { return apply(insphere, x); }
};

template <class Case>
int slow_sign(const typename Case::Coordinates& x) {
  return slow_sign<Case::kDimension>(x, Case::kRows);
}

// ---- The generators. They use single operations only, so that the same doubles come out under
// every flag and on every machine.

/// What makes a line hard.
enum class Family {
  kUniform,         ///< nothing: multiples of 2^-53 in [-1, 1]
  kGrid,            ///< integers of 0 to 3
  kDegenerate,      ///< exactly on a line, plane, circle or sphere, any power of two as the scale
  kNudged,          ///< degenerate, one coordinate moved by an ulp
  kRounded,         ///< degenerate, then divided by an odd number: each coordinate rounds
  kSpread,          ///< degenerate, one coordinate moved by a far smaller power of two
  kMixedExponents,  ///< every coordinate at a scale of its own, some 0
  kDuplicates,      ///< uniform, with equal points
  kTangent,         ///< rounded from a circle or sphere through the last point, the others at
                    ///< distances from it that span hundreds of powers of two
  kStretched,       ///< nudged from a line or plane, each axis at a scale of its own
};
inline constexpr int kFamilies = 10;

template <class Case>
class LineGenerator {
 public:
  using Coordinates = typename Case::Coordinates;
  explicit LineGenerator(std::uint64_t seed) : random_(seed) {}

  Coordinates line(Family family) {
    switch (family) {
      case Family::kUniform:
        return uniform();
      case Family::kGrid:
        return grid();
      case Family::kDegenerate:
        return scaled(degenerate());
      case Family::kNudged:
        return nudged(scaled(degenerate()));
      case Family::kRounded:
        return rounded(degenerate());
      case Family::kSpread:
        return spread(degenerate());
      case Family::kMixedExponents:
        return mixed();
      case Family::kDuplicates:
        return duplicates();
      case Family::kTangent:
        return tangent();
      case Family::kStretched:
        return stretched(nudged(on_a_flat()));
    }
    return {};
  }

  Random& random() { return random_; }

 private:
  static constexpr std::size_t kDimension = Case::kDimension;
  using Integers = std::array<std::int64_t, 3>;

  // Uniform in -2^bits .. 2^bits.
  std::int64_t integer(int bits) {
    return static_cast<std::int64_t>(random_.below((std::uint64_t{2} << bits) + 1)) -
           (std::int64_t{1} << bits);
  }

  Integers integers(int bits) { return {integer(bits), integer(bits), integer(bits)}; }

  double& any(Coordinates& x) { return x[random_.below(x.size())]; }

  Coordinates uniform() {
    Coordinates x;
    for (double& value : x) value = std::ldexp(static_cast<double>(integer(53)), -53);
    return x;
  }

  Coordinates grid() {
    Coordinates x;
    for (double& value : x) value = static_cast<double>(random_.below(4));
    return x;
  }

  Coordinates degenerate() {
    const bool round = Case::kRows == Rows::kLifted && random_.below(4) != 0;
    return round ? on_a_sphere() : on_a_flat();
  }

  // o + s u + t v: on one line in the plane, on one plane in space.
  Coordinates on_a_flat() {
    const int bits = static_cast<int>(random_.below(25));
    const Integers origin = integers(2 * bits), u = integers(bits), v = integers(bits);
    Coordinates x;
    for (std::size_t i = 0; i < x.size(); i += kDimension) {
      const std::int64_t s = integer(bits), t = kDimension == 3 ? integer(bits) : 0;
      for (std::size_t k = 0; k < kDimension; ++k) {
        x[i + k] = static_cast<double>(origin[k] + s * u[k] + t * v[k]);
      }
    }
    return x;
  }

  // o + an image of one vector under a permutation and signs: on one circle or sphere.
  Coordinates on_a_sphere() {
    const int bits = static_cast<int>(random_.below(51));
    const Integers origin = integers(bits), radius = integers(bits);
    Coordinates x;
    for (std::size_t i = 0; i < x.size(); i += kDimension) {
      Integers image = radius;
      for (std::size_t k = 0; k + 1 < kDimension; ++k) {
        std::swap(image[k], image[k + random_.below(kDimension - k)]);
      }
      for (std::size_t k = 0; k < kDimension; ++k) {
        x[i + k] = static_cast<double>(origin[k] + (random_.below(2) != 0 ? image[k] : -image[k]));
      }
    }
    return x;
  }

  // Half of the time by a power of two that leaves 53 bits room everywhere in -1074 .. 1023.
  Coordinates scaled(Coordinates x) {
    if (random_.below(2) == 0) return x;
    const int exponent = static_cast<int>(random_.below(2045)) - 1074;
    for (double& value : x) value = std::ldexp(value, exponent);
    for (const double value : x) {
      if (!std::isfinite(value)) return uniform();
    }
    return x;
  }

  Coordinates nudged(Coordinates x) {
    double& value = any(x);
    value = std::nextafter(value, random_.below(2) != 0 ? 1e308 : -1e308);
    return x;
  }

  Coordinates rounded(Coordinates x) {
    const auto divisor = static_cast<double>(3 + 2 * random_.below(50));
    for (double& value : x) value = value / divisor;
    return x;
  }

  Coordinates spread(Coordinates x) {
    any(x) = 0;
    x = rounded(x);
    for (double& value : x) {
      if (value != 0) continue;
      value = 1 + static_cast<double>(random_.below(8));
      value = std::ldexp(value, -static_cast<int>(random_.below(1075)));
    }
    return x;
  }

  Coordinates mixed() {
    Coordinates x;
    for (double& value : x) {
      const int exponent = static_cast<int>(random_.below(2044)) - 1126;  // below 2^971
      value = std::ldexp(static_cast<double>(integer(53)), exponent);
      if (random_.below(8) == 0) value = 0;
    }
    return x;
  }

  Coordinates duplicates() {
    Coordinates x = random_.below(2) != 0 ? uniform() : mixed();
    const std::size_t from = random_.below(Case::kPoints) * kDimension;
    const std::size_t to = random_.below(Case::kPoints) * kDimension;
    for (std::size_t k = 0; k < kDimension; ++k) x[to + k] = x[from + k];
    return x;
  }

  // Products of two axes may underflow, and the third make up for it.
  Coordinates stretched(Coordinates x) {
    std::array<int, kDimension> exponent;
    for (int& e : exponent) e = static_cast<int>(random_.below(1900)) - 1000;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::ldexp(x[i], exponent[i % kDimension]);
    return x;
  }

  // q / |q|^2 is on a circle or sphere through 0 for all q on a line or plane off 0.
  Coordinates tangent() {
    Coordinates x{};
    const int exponent = static_cast<int>(random_.below(160));
    for (std::size_t i = 0; i + kDimension < x.size(); i += kDimension) {
      // Near points are so near that the product of two squared distances underflows.
      int spread = static_cast<int>(random_.below(8));
      if (random_.below(2) != 0) spread = exponent + 275 + static_cast<int>(random_.below(60));
      for (std::size_t k = 0; k + 1 < kDimension; ++k) {
        x[i + k] = std::ldexp(static_cast<double>(integer(53)), spread - 53);
      }
      x[i + kDimension - 1] = 1;
      volatile double length_sq = 0;  // not contracted, so the same everywhere
      for (std::size_t k = 0; k < kDimension; ++k) {
        const volatile double square = x[i + k] * x[i + k];
        length_sq = length_sq + square;
      }
      for (std::size_t k = 0; k < kDimension; ++k) {
        x[i + k] = std::ldexp(x[i + k] / length_sq, exponent);
      }
    }
    return x;
  }

  Random random_;
};

}  // namespace wellspaced::testing

#ifdef __clang__
#pragma float_control(pop)
#endif
