// Rung 1 of the predicates: the sign by floating point, or 0 for "cannot tell".
//
// Each filter evaluates its determinant D in plain doubles and compares |D| with a bound E on its
// rounding error that follows from the coordinate differences at hand, so nothing is precomputed
// and no scale is assumed. A sign other than 0 is proven; 0 says only that |D| <= E.
//
// Why the bounds hold. Let u = 2^-53, so that one operation errs by at most a factor 1 + 1.001 u,
// also where a compiler keeps excess precision or contracts a*b + c to a fused operation (which
// only leaves out roundings). A product that is reached through r roundings has a relative error of
// at most (1 + 1.001 u)^r - 1 < 1.01 r u, so that |D - exact| <= 1.01 r u P, where P (the
// permanent) is the sum of the magnitudes of all products. E is a cheap upper bound on that. Sums
// and differences of doubles never underflow inexactly; a product that underflows errs by at most
// 2^-1074 in addition, and each bound carries a term that outgrows what becomes of it. Overflow
// anywhere leaves D infinite or not a number, and then nothing is certified.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "wellspaced/kernel/mesh.hpp"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__)
#error \
    "wellspaced's exact predicates need IEEE arithmetic: compile without -ffast-math and its parts"
#endif

// clang has no macro for -funsafe-math-optimizations and -fassociative-math alone; there these
// functions are compiled without them.
#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(precise, on, push)
#pragma clang fp contract(off)  // which the line above switches on
#endif

namespace wellspaced::predicate_filter {

/// The sign of a determinant that errs by at most `bound` unless it overflowed, or 0.
inline int certified_sign(double determinant, double bound) {
  const double magnitude = std::fabs(determinant);
  if (!(magnitude > bound) || magnitude > std::numeric_limits<double>::max()) return 0;
  return determinant > 0 ? 1 : -1;
}

/// r = 4; E also covers the rounding of E itself.
inline constexpr double kOrient2dBound = 0x5p-53;
inline constexpr double kOrient2dUnderflow = 0x1p-1070;

/// The sign of orient2d for a' = a - c and b' = b - c, each rounded once, or 0.
inline int orient2d_of_differences(double ax, double ay, double bx, double by) {
  const double left = ax * by, right = ay * bx;
  const double bound = kOrient2dBound * (std::fabs(left) + std::fabs(right)) + kOrient2dUnderflow;
  return certified_sign(left - right, bound);
}

inline int orient2d(Point2 a, Point2 b, Point2 c) {
  return orient2d_of_differences(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y);
}

/// r = 11, and P <= AB + BC + CA for the squared lengths A, B, C of the differences, because
/// |ax by| + |ay bx| <= (A + B) / 2.
inline constexpr double kIncircleBound = 0x1p-49;
inline constexpr double kIncircleUnderflow = 0x1p-500;

/// The sign of incircle for a' = a - d, b' = b - d, c' = c - d, each rounded once, or 0.
inline int incircle_of_differences(double ax, double ay, double bx, double by, double cx,
                                   double cy) {
  const double a_sq = ax * ax + ay * ay;
  const double b_sq = bx * bx + by * by;
  const double c_sq = cx * cx + cy * cy;
  const double determinant =
      a_sq * (bx * cy - by * cx) + b_sq * (cx * ay - cy * ax) + c_sq * (ax * by - ay * bx);
  const double bound =
      kIncircleBound *
      ((a_sq + kIncircleUnderflow) * ((b_sq + c_sq) + kIncircleUnderflow) + b_sq * c_sq);
  return certified_sign(determinant, bound);
}

inline int incircle(Point2 a, Point2 b, Point2 c, Point2 d) {
  return incircle_of_differences(a.x - d.x, a.y - d.y, b.x - d.x, b.y - d.y, c.x - d.x, c.y - d.y);
}

/// r = 8, and P <= 6 X Y Z for the largest |x|, |y|, |z| of the differences. The factor that the
/// minors are multiplied with comes last, for it multiplies what underflows in them.
inline constexpr double kOrient3dBound = 6 * 0x9p-53;
inline constexpr double kOrient3dUnderflow = 0x1p-1060;

inline double largest_magnitude(double a, double b, double c) {
  const double ab = std::fabs(a) > std::fabs(b) ? std::fabs(a) : std::fabs(b);
  return ab > std::fabs(c) ? ab : std::fabs(c);
}

/// The sign of orient3d for a' = a - d, b' = b - d, c' = c - d, each rounded once, or 0.
inline int orient3d_of_differences(Point3 a, Point3 b, Point3 c) {
  const double determinant =
      a.x * (b.y * c.z - b.z * c.y) + b.x * (c.y * a.z - c.z * a.y) + c.x * (a.y * b.z - a.z * b.y);
  const double x = largest_magnitude(a.x, b.x, c.x);
  const double y = largest_magnitude(a.y, b.y, c.y);
  const double z = largest_magnitude(a.z, b.z, c.z);
  const double bound = x * (kOrient3dBound * (y * z) + kOrient3dUnderflow) + kOrient3dUnderflow;
  return certified_sign(determinant, bound);
}

inline Point3 difference(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

inline int orient3d(Point3 a, Point3 b, Point3 c, Point3 d) {
  return orient3d_of_differences(difference(a, d), difference(b, d), difference(c, d));
}

/// orient3d of a point against the four facets of a tet, and a bound on what they err by.
struct TetSides {
  std::array<double, 4> determinant;
  double bound;

  /// Bit i: the sign of entry i is certain; and negative besides.
  struct Signs {
    unsigned certain = 0, negative = 0;
  };
  Signs signs() const {
    Signs signs;
    for (unsigned i = 0; i < 4; ++i) {
      const double magnitude = std::fabs(determinant[i]);
      const unsigned certain =
          (magnitude > bound) & (magnitude <= std::numeric_limits<double>::max());
      signs.certain |= certain << i;
      signs.negative |= (certain & (determinant[i] < 0)) << i;
    }
    return signs;
  }
};

/// For a' = a - p, ..., d' = d - p, each rounded once: entry i has the sign of orient3d(u, v, w, p)
/// for the facet (u, v, w) opposite corner i, counter-clockwise seen from outside if the tet is
/// positive; so all are positive where p lies inside.
inline TetSides sides_of_differences(Point3 a, Point3 b, Point3 c, Point3 d) {
  const double ab = a.x * b.y - a.y * b.x;
  const double bc = b.x * c.y - b.y * c.x;
  const double cd = c.x * d.y - c.y * d.x;
  const double da = d.x * a.y - d.y * a.x;
  const double ac = a.x * c.y - a.y * c.x;
  const double bd = b.x * d.y - b.y * d.x;
  const double x = largest_magnitude(a.x, b.x, largest_magnitude(c.x, d.x, 0));
  const double y = largest_magnitude(a.y, b.y, largest_magnitude(c.y, d.y, 0));
  const double z = largest_magnitude(a.z, b.z, largest_magnitude(c.z, d.z, 0));
  return {{b.z * cd - c.z * bd + d.z * bc, -(c.z * da + d.z * ac + a.z * cd),
           d.z * ab + a.z * bd + b.z * da, -(a.z * bc - b.z * ac + c.z * ab)},
          z * (kOrient3dBound * (x * y) + kOrient3dUnderflow) + kOrient3dUnderflow};
}

inline TetSides sides(Point3 a, Point3 b, Point3 c, Point3 d, Point3 p) {
  return sides_of_differences(difference(a, p), difference(b, p), difference(c, p),
                              difference(d, p));
}

/// r = 17. A 3 x 3 permanent with rows of lengths p, q, r is at most 6 / sqrt(27) pqr (Carlen, Lieb
/// and Loss 2006), so P <= 1.155 pqrs (p + q + r + s) <= 2.31 sqrt(ABCD (A + B + C + D)) with the
/// squared lengths A, B, C, D. The comparison is between squares, to spare the root:
/// (2.31 * 17.2 u)^2 < 2^-95.3. Below the limit on the sum, what underflows stays below 2^-710.
inline constexpr double kInsphereSquaredBound = 0x1p-95;
inline constexpr double kInsphereUnderflow = 0x1p-700;
inline constexpr double kInsphereLargestSum = 0x1p150;

/// The determinant of insphere, and what it takes to trust its sign.
struct InsphereEstimate {
  double determinant, bound_sq, sum_sq;

  /// Without a branch, for callers that test many. False where a difference exceeds 2^75.
  bool is_certain() const {
    return (determinant * determinant > bound_sq) & (sum_sq < kInsphereLargestSum);
  }
  int sign() const { return is_certain() ? (determinant > 0 ? 1 : -1) : 0; }
};

/// The estimate for a' = a - e, ..., d' = d - e, each rounded once.
inline InsphereEstimate insphere_of_differences(Point3 a, Point3 b, Point3 c, Point3 d) {
  const double ab = a.x * b.y - a.y * b.x;
  const double bc = b.x * c.y - b.y * c.x;
  const double cd = c.x * d.y - c.y * d.x;
  const double da = d.x * a.y - d.y * a.x;
  const double ac = a.x * c.y - a.y * c.x;
  const double bd = b.x * d.y - b.y * d.x;
  const double abc = a.z * bc - b.z * ac + c.z * ab;
  const double bcd = b.z * cd - c.z * bd + d.z * bc;
  const double cda = c.z * da + d.z * ac + a.z * cd;
  const double dab = d.z * ab + a.z * bd + b.z * da;
  const double a_sq = a.x * a.x + a.y * a.y + a.z * a.z;
  const double b_sq = b.x * b.x + b.y * b.y + b.z * b.z;
  const double c_sq = c.x * c.x + c.y * c.y + c.z * c.z;
  const double d_sq = d.x * d.x + d.y * d.y + d.z * d.z;
  const double determinant = (d_sq * abc - c_sq * dab) + (b_sq * cda - a_sq * bcd);
  const double sum_sq = (a_sq + b_sq) + (c_sq + d_sq);
  const double bound_sq =
      kInsphereSquaredBound * ((a_sq * b_sq) * (c_sq * d_sq)) * sum_sq + kInsphereUnderflow;
  return {determinant, bound_sq, sum_sq};
}

inline int insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) {
  return insphere_of_differences(difference(a, e), difference(b, e), difference(c, e),
                                 difference(d, e))
      .sign();
}

/// r = 6, and P is the sum of both squares; E also covers the rounding of E itself.
inline constexpr double kDistanceBound = 0x1p-50;
inline constexpr double kDistanceUnderflow = 0x1p-1070;

/// The sign of |a|^2 - |b|^2 for these values, each of a sum of squares of differences, or 0.
inline int compare_squares(double a_sq, double b_sq) {
  return certified_sign(a_sq - b_sq, kDistanceBound * (a_sq + b_sq) + kDistanceUnderflow);
}

inline int compare_distances(Point2 p, Point2 a, Point2 b) {
  const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
  return compare_squares(ax * ax + ay * ay, bx * bx + by * by);
}

inline int compare_distances(Point3 p, Point3 a, Point3 b) {
  const Point3 u = difference(a, p), v = difference(b, p);
  return compare_squares(u.x * u.x + u.y * u.y + u.z * u.z, v.x * v.x + v.y * v.y + v.z * v.z);
}

}  // namespace wellspaced::predicate_filter

#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(pop)
#endif
