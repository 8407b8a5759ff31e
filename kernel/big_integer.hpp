// Signed integers of varying length in a fixed buffer, for what no fixed width holds.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>

#include "wellspaced/kernel/fixed_integer.hpp"

namespace wellspaced {

__extension__ typedef unsigned __int128 UInt128;

// Arithmetic on magnitudes: limbs from the lowest, the last of them not 0. It is for any length, so
// that compilers meet it once, not for every pair of capacities.
namespace limbs {

struct Magnitude {
  const std::uint64_t* limb;
  int size;
};

/// The sign of a - b.
[[gnu::noinline]] inline int compare(Magnitude a, Magnitude b) {
  if (a.size != b.size) return a.size < b.size ? -1 : 1;
  for (int i = a.size - 1; i >= 0; --i) {
    if (a.limb[i] != b.limb[i]) return a.limb[i] < b.limb[i] ? -1 : 1;
  }
  return 0;
}

/// a + b, into as many limbs as are returned: a.size or one more. Requires: a >= b.
[[gnu::noinline]] inline int add(Magnitude a, Magnitude b, std::uint64_t* out) {
  std::uint64_t carry = 0;
  for (int i = 0; i < a.size; ++i) {
    const UInt128 t = UInt128{a.limb[i]} + (i < b.size ? b.limb[i] : 0) + carry;
    out[i] = static_cast<std::uint64_t>(t);
    carry = static_cast<std::uint64_t>(t >> 64);
  }
  if (carry != 0) out[a.size] = carry;
  return a.size + (carry != 0);
}

/// How many limbs are left without the zeros on top.
inline int trimmed(const std::uint64_t* limb, int size) {
  while (size > 0 && limb[size - 1] == 0) --size;
  return size;
}

/// a - b, into as many limbs as are returned. Requires: a >= b, and room for a.size of them.
[[gnu::noinline]] inline int subtract(Magnitude a, Magnitude b, std::uint64_t* out) {
  std::uint64_t borrow = 0;
  for (int i = 0; i < a.size; ++i) {
    const UInt128 t = UInt128{a.limb[i]} - (i < b.size ? b.limb[i] : 0) - borrow;
    out[i] = static_cast<std::uint64_t>(t);
    borrow = static_cast<std::uint64_t>(t >> 64) & 1;
  }
  return trimmed(out, a.size);
}

/// a * b by the schoolbook, into as many limbs as are returned. Requires: room for a.size + b.size,
/// none of them those of a or b.
[[gnu::noinline]] inline int multiply(Magnitude a, Magnitude b, std::uint64_t* out) {
  std::fill_n(out, a.size + b.size, 0);
  for (int i = 0; i < a.size; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size; ++j) {
      const UInt128 t = UInt128{a.limb[i]} * b.limb[j] + out[i + j] + carry;
      out[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    out[i + b.size] = carry;
  }
  return trimmed(out, a.size + b.size);
}

}  // namespace limbs

/// An integer in sign and magnitude of at most `Capacity` 64-bit limbs, the lowest first.
///
/// Only the limbs in use cost time, so a large capacity is cheap; nothing is allocated. A product
/// has the capacity of its factors together and never overflows; a sum has the larger capacity of
/// its terms.
/// Requires: that a sum fits its capacity, which callers show by counting bits.
template <int Capacity>
class BigInteger {
 public:
  BigInteger() {}  // the limbs beyond size_ are never read
  BigInteger(const BigInteger& a) { *this = a; }
  BigInteger& operator=(const BigInteger& a) {
    assign(a);
    return *this;
  }

  /// The same integer in another capacity. Requires: room for it.
  template <int N>
  explicit BigInteger(const BigInteger<N>& a) {
    assign(a);
  }

  /// magnitude * 2^shift. Requires: shift >= 0, and room for it.
  static BigInteger shifted(bool negative, std::uint64_t magnitude, int shift) {
    BigInteger result;
    if (magnitude == 0) return result;
    const int whole = shift / 64, bits = shift % 64;
    std::fill_n(result.limb_.begin(), whole, 0);
    result.size_ = whole;
    result.push(magnitude << bits);
    if (bits > 0 && (magnitude >> (64 - bits)) != 0) result.push(magnitude >> (64 - bits));
    result.negative_ = negative;
    return result;
  }

  /// a + b, or a - b.
  template <int N, int M>
  static BigInteger sum(const BigInteger<N>& a, const BigInteger<M>& b) {
    return signed_sum(a.magnitude(), a.negative(), b.magnitude(), b.negative());
  }
  template <int N, int M>
  static BigInteger difference(const BigInteger<N>& a, const BigInteger<M>& b) {
    return signed_sum(a.magnitude(), a.negative(), b.magnitude(), !b.negative());
  }

  /// a * b.
  template <int N, int M>
  static BigInteger product(const BigInteger<N>& a, const BigInteger<M>& b) {
    static_assert(N + M <= Capacity);
    BigInteger result;
    result.set_size(limbs::multiply(a.magnitude(), b.magnitude(), result.limb_.data()));
    result.set_sign(a.negative() != b.negative());
    return result;
  }

  int size() const { return size_; }
  std::uint64_t limb(int i) const { return limb_[i]; }
  limbs::Magnitude magnitude() const { return {limb_.data(), size_}; }
  bool negative() const { return negative_; }
  int sign() const { return size_ == 0 ? 0 : (negative_ ? -1 : 1); }

  /// The number of significant bits of the magnitude: 0 for 0.
  int bit_length() const {
    return size_ == 0 ? 0 : 64 * size_ - std::countl_zero(limb_[size_ - 1]);
  }

 private:
  template <int N>
  void assign(const BigInteger<N>& a) {
    set_size(a.size());
    std::copy_n(a.magnitude().limb, size_, limb_.data());
    negative_ = a.negative();
  }

  void set_size(int size) {
    assert(size <= Capacity);
    size_ = size;
  }
  void set_sign(bool negative) { negative_ = negative && size_ > 0; }

  void push(std::uint64_t limb) {
    assert(size_ < Capacity);
    limb_[size_++] = limb;
  }

  static BigInteger signed_sum(limbs::Magnitude a, bool a_negative, limbs::Magnitude b,
                               bool b_negative) {
    if (limbs::compare(a, b) < 0) return signed_sum(b, b_negative, a, a_negative);
    BigInteger result;
    std::uint64_t* const out = result.limb_.data();
    result.set_size(a_negative == b_negative ? limbs::add(a, b, out) : limbs::subtract(a, b, out));
    result.set_sign(a_negative);
    return result;
  }

  std::array<std::uint64_t, Capacity> limb_;
  int size_ = 0;
  bool negative_ = false;
};

template <int N, int M>
BigInteger<std::max(N, M)> operator+(const BigInteger<N>& a, const BigInteger<M>& b) {
  return BigInteger<std::max(N, M)>::sum(a, b);
}

template <int N, int M>
BigInteger<std::max(N, M)> operator-(const BigInteger<N>& a, const BigInteger<M>& b) {
  return BigInteger<std::max(N, M)>::difference(a, b);
}

template <int N, int M>
BigInteger<N + M> operator*(const BigInteger<N>& a, const BigInteger<M>& b) {
  return BigInteger<N + M>::product(a, b);
}

template <int N>
int sign_of(const BigInteger<N>& a) {
  return a.sign();
}

}  // namespace wellspaced
