// Our own seeded random numbers: the same on every compiler and machine.
#pragma once

#include <cstdint>

namespace wellspaced {

/// The splitmix64 step as a hash of 64 bits to 64 bits (Steele, Lea and Flood 2014).
constexpr std::uint64_t splitmix64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// A generator with one word of state: splitmix64 of a counter.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(splitmix64(seed)) {}

  std::uint64_t bits() { return splitmix64(state_++); }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in 0 .. bound - 1. Requires: bound > 0. The bias is below bound / 2^64.
  std::uint64_t below(std::uint64_t bound) { return bits() % bound; }

 private:
  std::uint64_t state_;
};

}  // namespace wellspaced
