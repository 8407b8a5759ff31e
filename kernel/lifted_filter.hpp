// Rung 1 of incircle for searches around one point p, which share their arithmetic.
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/predicate_filter.hpp"

// As in predicate_filter.hpp.
#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(precise, on, push)
#pragma clang fp contract(off)  // which the line above switches on
#endif

namespace wellspaced::predicate_filter {

/// A point as p sees it: the difference, rounded once, and its square.
struct Lifted {
  double x, y, sq;
};

inline Lifted lifted(Point2 a, Point2 p) {
  const double x = a.x - p.x, y = a.y - p.y;
  return {x, y, x * x + y * y};
}

/// orient2d(a, b, p), estimated.
inline double edge_minor(Lifted a, Lifted b) { return a.x * b.y - a.y * b.x; }

/// incircle(a, b, c, p), estimated. Where its magnitude exceeds the bound, its sign is right.
struct IncircleEstimate {
  double determinant, bound;
};

/// r = 11, and P <= AB + BC + CA <= (A + B + C)^2 / 3 for the squared lengths A, B, C, as in
/// incircle_of_differences. The square overflows before the determinant does. It is cheaper than
/// the bound there, and wider where the distances from p differ much.
inline constexpr double kIncircleSquareBound = 0x1p-51;

/// ab, bc and ca are the minors of the edges. Each serves the triangles on both sides of its edge,
/// with opposite signs.
inline IncircleEstimate incircle_of_minors(Lifted a, Lifted b, Lifted c, double ab, double bc,
                                           double ca) {
  const double sum = (a.sq + b.sq + kIncircleUnderflow) + c.sq;
  return {a.sq * bc + b.sq * ca + c.sq * ab, kIncircleSquareBound * (sum * sum)};
}

}  // namespace wellspaced::predicate_filter

#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(pop)
#endif
