#include "wellspaced/kernel/elementary.hpp"

#include <cmath>
#include <limits>

namespace wellspaced {
namespace {

constexpr double kTwoPi = 6.283185307179586476925286766559;
constexpr double kLog2 = 0.693147180559945309417232121458;

// The Taylor series below are summed from the smallest term, by Horner's rule; the first term
// left out is under 2^-56 of the sum over the reduced range.

// sin x for |x| <= pi/4.
double sine_near_zero(double x) {
  const double square = x * x;
  double tail = 1;
  for (int k = 16; k >= 2; k -= 2) tail = 1 - tail * square / (k * (k + 1));
  return x * tail;
}

// cos x for |x| <= pi/4.
double cosine_near_zero(double x) {
  const double square = x * x;
  double sum = 1;
  for (int k = 17; k >= 1; k -= 2) sum = 1 - sum * square / (k * (k + 1));
  return sum;
}

}  // namespace

Point2 circle_point(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  const double angle = kTwoPi * (turns - quarters / 4);
  const double c = cosine_near_zero(angle), s = sine_near_zero(angle);
  switch (static_cast<long long>(quarters) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double power_of_two(double exponent) {
  const double whole = std::floor(exponent + 0.5);
  const double x = kLog2 * (exponent - whole);
  double sum = 1;
  for (int k = 17; k >= 1; --k) sum = 1 + sum * x / k;
  return std::ldexp(sum, static_cast<int>(whole));
}

double binary_logarithm(double x) {
  if (!(x > 0) || std::isinf(x))
    return x == 0 ? -std::numeric_limits<double>::infinity() : std::sqrt(x);
  constexpr double kHalfRoot = 0.70710678118654752440084436210485;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < kHalfRoot) mantissa *= 2, --exponent;
  // ln m = 2 artanh((m - 1) / (m + 1)), whose argument is below 0.172.
  const double s = (mantissa - 1) / (mantissa + 1), square = s * s;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k + square * sum;
  return exponent + 2 * s * sum / kLog2;
}

}  // namespace wellspaced
