// Signed integers of a fixed number of 64-bit limbs, on the stack, for exact determinants.
#pragma once

#include <array>
#include <cstdint>

#ifndef __SIZEOF_INT128__
#error "wellspaced needs a compiler with 128-bit integers (gcc or clang on a 64-bit target)"
#endif

namespace wellspaced {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// The exact product. Cost: one machine multiplication.
constexpr Int128 wide_product(std::int64_t a, std::int64_t b) { return Int128{a} * b; }

constexpr int sign_of(std::int64_t a) { return (a > 0) - (a < 0); }
constexpr int sign_of(Int128 a) { return (a > 0) - (a < 0); }

/// A two's complement integer of `Limbs` 64-bit limbs, the lowest first.
///
/// Sums and differences keep the width and wrap around like machine integers; a product is as wide
/// as its factors together, so it never overflows. Callers choose widths that leave room for sums.
template <int Limbs>
struct FixedInteger {
  static_assert(Limbs >= 1);
  std::array<std::uint64_t, Limbs> limb;

  constexpr bool negative() const { return static_cast<std::int64_t>(limb[Limbs - 1]) < 0; }
};

/// The limb that repeats the sign: all ones for a negative integer, else 0.
template <int N>
constexpr std::uint64_t sign_limb(const FixedInteger<N>& a) {
  return std::uint64_t{0} - (a.limb[N - 1] >> 63);
}

constexpr FixedInteger<1> fixed_integer(std::int64_t a) {
  return {{static_cast<std::uint64_t>(a)}};
}

constexpr FixedInteger<2> fixed_integer(Int128 a) {
  return {{static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(a >> 64)}};
}

template <int N>
constexpr FixedInteger<N> operator+(const FixedInteger<N>& a, const FixedInteger<N>& b) {
  FixedInteger<N> sum{};
  std::uint64_t carry = 0;
  for (int i = 0; i < N; ++i) {
    const UInt128 t = UInt128{a.limb[i]} + b.limb[i] + carry;
    sum.limb[i] = static_cast<std::uint64_t>(t);
    carry = static_cast<std::uint64_t>(t >> 64);
  }
  return sum;
}

template <int N>
constexpr FixedInteger<N> operator-(const FixedInteger<N>& a, const FixedInteger<N>& b) {
  FixedInteger<N> difference{};
  std::uint64_t borrow = 0;
  for (int i = 0; i < N; ++i) {
    const UInt128 t = UInt128{a.limb[i]} - b.limb[i] - borrow;
    difference.limb[i] = static_cast<std::uint64_t>(t);
    borrow = static_cast<std::uint64_t>(t >> 64) & 1;
  }
  return difference;
}

/// Subtracts b * 2^(64 * (N - M)) & mask from a, modulo 2^(64 * N).
template <int N, int M>
constexpr void subtract_from_top(FixedInteger<N>& a, const FixedInteger<M>& b, std::uint64_t mask) {
  std::uint64_t borrow = 0;
  for (int i = 0; i < M; ++i) {
    const UInt128 t = UInt128{a.limb[N - M + i]} - (b.limb[i] & mask) - borrow;
    a.limb[N - M + i] = static_cast<std::uint64_t>(t);
    borrow = static_cast<std::uint64_t>(t >> 64) & 1;
  }
}

/// The exact product: schoolbook on the limbs as unsigned, then a correction for negative factors.
template <int N, int M>
constexpr FixedInteger<N + M> operator*(const FixedInteger<N>& a, const FixedInteger<M>& b) {
  FixedInteger<N + M> product{};
  for (int i = 0; i < N; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < M; ++j) {
      const UInt128 t = UInt128{a.limb[i]} * b.limb[j] + product.limb[i + j] + carry;
      product.limb[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    product.limb[i + M] = carry;
  }
  subtract_from_top(product, b, sign_limb(a));
  subtract_from_top(product, a, sign_limb(b));
  return product;
}

template <int N, int M>
constexpr FixedInteger<N + M> wide_product(const FixedInteger<N>& a, const FixedInteger<M>& b) {
  return a * b;
}

template <int N>
constexpr int sign_of(const FixedInteger<N>& a) {
  if (a.negative()) return -1;
  std::uint64_t any = 0;
  for (const std::uint64_t limb : a.limb) any |= limb;
  return any != 0;
}

}  // namespace wellspaced
