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

/// Two numbers, with which a processor calculates at once where it can.
using Two = double __attribute__((vector_size(2 * sizeof(double))));

inline Two firsts(Two a, Two b) { return Two{a[0], b[0]}; }
inline Two seconds(Two a, Two b) { return Two{a[1], b[1]}; }

inline double squared_length(Two a) { return a[0] * a[0] + a[1] * a[1]; }

/// Two points as p sees them: the differences, each coordinate rounded once, and their squares.
struct LiftedPair {
  Two x, y, sq;
};

/// From the differences.
inline LiftedPair lifted(Two a, Two b) {
  const Two x = firsts(a, b), y = seconds(a, b);
  return {x, y, x * x + y * y};
}

/// orient2d(a, b, p), estimated.
inline double edge_minor(Two a, Two b) { return a[0] * b[1] - a[1] * b[0]; }
inline Two edge_minors(const LiftedPair& a, const LiftedPair& b) { return a.x * b.y - a.y * b.x; }

/// As in orient2d_of_differences, r = 4; and P <= (A + B) / 2 for the squared lengths A and B,
/// which overflow before the minor does. It is cheaper than the bound there, and wider where the
/// distances from p differ much.
inline constexpr double kOrient2dSquareBound = 0x5p-54;

/// Where the magnitude of an edge's minor exceeds this, its sign is that of orient2d. A Number is a
/// double or Two.
template <class Number>
Number edge_minor_bound(Number a_sq, Number b_sq) {
  return kOrient2dSquareBound * (a_sq + b_sq) + kOrient2dUnderflow;
}

/// incircle(a, b, c, p), estimated, for two triples. Where a magnitude exceeds its bound, the sign
/// is right.
struct IncircleEstimates {
  Two determinants, bounds;
};

/// r = 11, and P <= AB + BC + CA <= (A + B + C)^2 / 3 for the squared lengths A, B, C, as in
/// incircle_of_differences. The square overflows before the determinant does. It is cheaper than
/// the bound there, and wider where the distances from p differ much.
inline constexpr double kIncircleSquareBound = 0x1p-51;

/// ab, bc and ca are the minors of the edges. Each serves the triangles on both sides of its edge,
/// with opposite signs.
inline IncircleEstimates incircles_of_minors(const LiftedPair& a, const LiftedPair& b,
                                             const LiftedPair& c, Two ab, Two bc, Two ca) {
  const Two sum = (a.sq + b.sq + kIncircleUnderflow) + c.sq;
  return {a.sq * bc + b.sq * ca + c.sq * ab, kIncircleSquareBound * (sum * sum)};
}

}  // namespace wellspaced::predicate_filter

#if defined(__clang__) && !defined(__wasm__)
#pragma float_control(pop)
#endif
