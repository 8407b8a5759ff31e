// Integers of any length, written for plainness alone: what the tests trust. It shares nothing with
// the library's integers: base 2^32 in a vector, one operation at a time.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

namespace wellspaced::testing {

class SlowInteger {
 public:
  SlowInteger(std::int64_t value = 0) : negative_(value < 0) {
    auto magnitude = static_cast<std::uint64_t>(value);
    if (negative_) magnitude = 0 - magnitude;
    for (; magnitude != 0; magnitude >>= 32) digits_.push_back(static_cast<Digit>(magnitude));
  }

  /// x / 2^unit. Requires: that it is an integer.
  static SlowInteger from_double(double x, int unit) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);  // |fraction| in [1/2, 1), or 0
    const auto significand = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int shift = significand == 0 ? 0 : exponent - 53 - unit;
    return shift >= 0 ? SlowInteger(significand) << shift : SlowInteger(significand >> -shift);
  }

  int sign() const { return digits_.empty() ? 0 : (negative_ ? -1 : 1); }
  SlowInteger operator-() const { return with_sign(digits_, !negative_); }

  friend SlowInteger operator+(const SlowInteger& a, const SlowInteger& b) {
    if (a.negative_ == b.negative_) return with_sign(add(a.digits_, b.digits_), a.negative_);
    if (less(a.digits_, b.digits_)) return with_sign(subtract(b.digits_, a.digits_), b.negative_);
    return with_sign(subtract(a.digits_, b.digits_), a.negative_);
  }
  friend SlowInteger operator-(const SlowInteger& a, const SlowInteger& b) { return a + (-b); }

  friend SlowInteger operator*(const SlowInteger& a, const SlowInteger& b) {
    Digits product(a.digits_.size() + b.digits_.size() + 1, 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.digits_.size() || carry != 0; ++j) {
        const std::uint64_t digit = j < b.digits_.size() ? b.digits_[j] : 0;
        carry += product[i + j] + digit * a.digits_[i];
        product[i + j] = static_cast<Digit>(carry);
        carry >>= 32;
      }
    }
    return with_sign(product, a.negative_ != b.negative_);
  }

  friend SlowInteger operator<<(const SlowInteger& a, int shift) {
    SlowInteger result = a * SlowInteger(std::int64_t{1} << (shift % 32));
    if (result.sign() != 0) result.digits_.insert(result.digits_.begin(), shift / 32, 0);
    return result;
  }

  friend bool operator==(const SlowInteger& a, const SlowInteger& b) { return (a - b).sign() == 0; }
  friend std::strong_ordering operator<=>(const SlowInteger& a, const SlowInteger& b) {
    return (a - b).sign() <=> 0;
  }

 private:
  using Digit = std::uint32_t;
  using Digits = std::vector<Digit>;

  static SlowInteger with_sign(Digits digits, bool negative) {
    SlowInteger result;
    while (!digits.empty() && digits.back() == 0) digits.pop_back();
    result.negative_ = negative && !digits.empty();
    result.digits_ = std::move(digits);
    return result;
  }

  static bool less(const Digits& a, const Digits& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }

  static Digits add(const Digits& a, const Digits& b) {
    Digits sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()) || carry != 0; ++i) {
      carry += std::uint64_t{i < a.size() ? a[i] : 0} + (i < b.size() ? b[i] : 0);
      sum.push_back(static_cast<Digit>(carry));
      carry >>= 32;
    }
    return sum;
  }

  // Requires: a >= b.
  static Digits subtract(const Digits& a, const Digits& b) {
    Digits difference;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const std::int64_t d = std::int64_t{a[i]} - (i < b.size() ? b[i] : 0) - borrow;
      borrow = d < 0;
      difference.push_back(static_cast<Digit>(d + (borrow << 32)));
    }
    return difference;
  }

  bool negative_ = false;
  Digits digits_;
};

using SlowMatrix = std::vector<std::vector<SlowInteger>>;

/// The determinant, by expansion along the rows: that of the last rows on each set of columns, from
/// those on the sets with one column less.
inline SlowInteger slow_determinant(const SlowMatrix& m) {
  std::vector<SlowInteger> on_columns(std::size_t{1} << m.size());
  on_columns[0] = 1;
  for (unsigned set = 1; set < on_columns.size(); ++set) {
    const auto& row = m[m.size() - static_cast<std::size_t>(std::popcount(set))];
    bool negative = false;
    for (unsigned column = 0; column < m.size(); ++column) {
      if ((set >> column) % 2 == 0) continue;
      const SlowInteger term = row[column] * on_columns[set ^ (1u << column)];
      on_columns[set] = negative ? on_columns[set] - term : on_columns[set] + term;
      negative = !negative;
    }
  }
  return on_columns.back();
}

}  // namespace wellspaced::testing
