#include "wellspaced/kernel/angle.hpp"

#include <cmath>

namespace wellspaced {
namespace {

constexpr double kDegreesPerRadian = 57.295779513082320876798154814105;

// arctan x in degrees for |x| <= sqrt(2) - 1: the Taylor series, by Horner's rule.
double small_arctangent_deg(double x) {
  const double square = x * x;
  double sum = 0;
  for (int k = 43; k >= 1; k -= 2) sum = 1.0 / k - square * sum;
  return kDegreesPerRadian * x * sum;
}

// arctan x in degrees for 0 <= x <= 1: arctan x = 45 - arctan((1 - x) / (1 + x)).
double arctangent_deg(double x) {
  constexpr double kTangentOf22_5 = 0.41421356237309504880168872420970;
  if (x <= kTangentOf22_5) return small_arctangent_deg(x);
  return 45 - small_arctangent_deg((1 - x) / (1 + x));
}

}  // namespace

double arccotangent_deg(double cotangent) {
  const double size = std::fabs(cotangent);
  const double acute = size > 1 ? arctangent_deg(1 / size) : 90 - arctangent_deg(size);
  return cotangent < 0 ? 180 - acute : acute;
}

}  // namespace wellspaced
