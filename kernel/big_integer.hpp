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
    return signed_sum(a, b, b.negative());
  }
  template <int N, int M>
  static BigInteger difference(const BigInteger<N>& a, const BigInteger<M>& b) {
    return signed_sum(a, b, !b.negative());
  }

  /// a * b, by the schoolbook.
  template <int N, int M>
  static BigInteger product(const BigInteger<N>& a, const BigInteger<M>& b) {
    static_assert(N + M <= Capacity);
    BigInteger result;
    result.size_ = a.size() + b.size();
    std::fill_n(result.limb_.begin(), result.size_, 0);
    for (int i = 0; i < a.size(); ++i) result.add_multiple(b, a.limb(i), i);
    result.negative_ = a.negative() != b.negative();
    result.trim();
    return result;
  }

  int size() const { return size_; }
  std::uint64_t limb(int i) const { return limb_[i]; }
  bool negative() const { return negative_; }
  int sign() const { return size_ == 0 ? 0 : (negative_ ? -1 : 1); }

  /// The number of significant bits of the magnitude: 0 for 0.
  int bit_length() const {
    return size_ == 0 ? 0 : 64 * size_ - std::countl_zero(limb_[size_ - 1]);
  }

 private:
  template <int N>
  void assign(const BigInteger<N>& a) {
    assert(a.size() <= Capacity);
    size_ = a.size();
    for (int i = 0; i < size_; ++i) limb_[i] = a.limb(i);
    negative_ = a.negative();
  }

  void push(std::uint64_t limb) {
    assert(size_ < Capacity);
    limb_[size_++] = limb;
  }

  template <int N, int M>
  static BigInteger signed_sum(const BigInteger<N>& a, const BigInteger<M>& b, bool b_negative) {
    BigInteger result;
    const bool a_larger = compare_magnitudes(a, b) >= 0;
    result.negative_ = a_larger ? a.negative() : b_negative;
    if (a.negative() == b_negative) {
      a_larger ? result.set_magnitude_sum(a, b) : result.set_magnitude_sum(b, a);
    } else {
      a_larger ? result.set_magnitude_difference(a, b) : result.set_magnitude_difference(b, a);
    }
    result.trim();
    return result;
  }

  // |a| + |b|. Requires: |a| >= |b|, so that a has the more limbs.
  template <int N, int M>
  void set_magnitude_sum(const BigInteger<N>& a, const BigInteger<M>& b) {
    size_ = 0;
    std::uint64_t carry = 0;
    for (int i = 0; i < a.size(); ++i) {
      const UInt128 t = UInt128{a.limb(i)} + (i < b.size() ? b.limb(i) : 0) + carry;
      push(static_cast<std::uint64_t>(t));
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    if (carry != 0) push(carry);
  }

  // |a| - |b|. Requires: |a| >= |b|.
  template <int N, int M>
  void set_magnitude_difference(const BigInteger<N>& a, const BigInteger<M>& b) {
    size_ = 0;
    std::uint64_t borrow = 0;
    for (int i = 0; i < a.size(); ++i) {
      const UInt128 t = UInt128{a.limb(i)} - (i < b.size() ? b.limb(i) : 0) - borrow;
      push(static_cast<std::uint64_t>(t));
      borrow = static_cast<std::uint64_t>(t >> 64) & 1;
    }
  }

  // Adds |b| * factor * 2^(64 * at) to the magnitude, whose limb after those of b is still 0.
  template <int M>
  void add_multiple(const BigInteger<M>& b, std::uint64_t factor, int at) {
    if (factor == 0) return;
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size(); ++j) {
      const UInt128 t = UInt128{factor} * b.limb(j) + limb_[at + j] + carry;
      limb_[at + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    limb_[at + b.size()] = carry;
  }

  void trim() {
    while (size_ > 0 && limb_[size_ - 1] == 0) --size_;
    if (size_ == 0) negative_ = false;
  }

  std::array<std::uint64_t, Capacity> limb_;
  int size_ = 0;
  bool negative_ = false;
};

/// The sign of |a| - |b|.
template <int N, int M>
int compare_magnitudes(const BigInteger<N>& a, const BigInteger<M>& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (int i = a.size() - 1; i >= 0; --i) {
    if (a.limb(i) != b.limb(i)) return a.limb(i) < b.limb(i) ? -1 : 1;
  }
  return 0;
}

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
