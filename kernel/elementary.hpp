// Elementary functions whose every bit is the same on every compiler and machine.
#pragma once

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The point of the unit circle at `turns` full turns from (1, 0), counter-clockwise: the cosine
/// and sine of 2 pi `turns`. Multiples of a quarter turn are exact.
/// Requires: |turns| < 2^50. Error: below 2 units in the last place of 1.
Point2 circle_point(double turns);

/// 2 to the power `exponent`: exact for whole exponents, else within 2 units in the last place.
/// Requires: -1022 <= exponent < 1024.
double power_of_two(double exponent);

/// The logarithm to base 2: exact for powers of two, else within 1e-15 * max(1, |log2 x|).
/// Degenerate: 0 gives -infinity, infinity itself, a negative number or NaN gives NaN.
double binary_logarithm(double x);

}  // namespace wellspaced
