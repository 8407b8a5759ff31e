// Numbers of twice the precision of a double, for where a bound on an error must be small.
#pragma once

#include <cmath>

namespace wellspaced::audit {

/// The unevaluated sum of two doubles. Sums and products err by about 2^-100 of the magnitudes that
/// go in (Dekker 1971), unless they over- or underflow.
struct Twofold {
  double high = 0, low = 0;
};

inline Twofold sum_exactly(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}
inline Twofold operator+(Twofold a, Twofold b) {
  const Twofold sum = sum_exactly(a.high, b.high);
  return sum_exactly(sum.high, sum.low + (a.low + b.low));
}
inline Twofold operator-(Twofold a, Twofold b) { return a + Twofold{-b.high, -b.low}; }
inline Twofold operator*(Twofold a, Twofold b) {
  const double product = a.high * b.high, rest = std::fma(a.high, b.high, -product);
  return sum_exactly(product, rest + (a.high * b.low + a.low * b.high));
}

/// For code that is written for doubles and Twofolds alike.
inline double value_of(double x) { return x; }
inline double value_of(Twofold x) { return x.high; }
template <class T>
T difference_of(double a, double b);
template <>
inline double difference_of<double>(double a, double b) {
  return a - b;
}
template <>
inline Twofold difference_of<Twofold>(double a, double b) {
  return sum_exactly(a, -b);
}

}  // namespace wellspaced::audit
