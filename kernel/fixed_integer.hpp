// Signed integers of a fixed number of digits, on the stack, for exact determinants.
//
// A determinant is a sum of few products, so carries can wait. A product is left as the columns of
// the schoolbook, each a 128-bit sum; columns are added column by column; and carries run only when
// a sum becomes a factor in its turn, or when its sign is asked. All of it is plain signed 128-bit
// arithmetic without branches, which compilers turn into good code on every 64-bit machine.
#pragma once

#include <array>
#include <cstdint>

#ifndef __SIZEOF_INT128__
#error "wellspaced needs a compiler with 128-bit integers (gcc or clang on a 64-bit target)"
#endif

namespace wellspaced {

__extension__ typedef __int128 Int128;

/// The exact product.
constexpr Int128 wide_product(std::int64_t a, std::int64_t b) { return Int128{a} * b; }

constexpr int sign_of(Int128 a) { return (a > 0) - (a < 0); }

/// The integer sum of digit[i] * 2^(Bits * i). All digits but the last are in 0 .. 2^Bits - 1; the
/// last carries the sign and may be larger.
template <int Count, int Bits>
struct Digits {
  std::array<std::int64_t, Count> digit;
};

/// The integer sum of column[i] * 2^(Bits * i), carries pending.
///
/// Requires, of every sum and product: that no column outgrows 127 bits, and that what is carried
/// out of the last column fits 64 bits. Callers show it by counting; see exact_predicates.hpp.
template <int Count, int Bits>
struct Columns {
  std::array<Int128, Count> column;
};

template <int Bits>
constexpr std::int64_t low_digit(Int128 column) {
  return static_cast<std::int64_t>(column) & ((std::int64_t{1} << Bits) - 1);
}

/// Runs the carries.
template <int N, int Bits>
constexpr Digits<N + 1, Bits> digits(const Columns<N, Bits>& a) {
  Digits<N + 1, Bits> result{};
  Int128 carry = 0;
  for (int i = 0; i < N; ++i) {
    const Int128 column = a.column[i] + carry;
    result.digit[i] = low_digit<Bits>(column);
    carry = column >> Bits;
  }
  result.digit[N] = static_cast<std::int64_t>(carry);
  return result;
}

template <int N, int Bits>
constexpr const Digits<N, Bits>& digits(const Digits<N, Bits>& a) {
  return a;
}

template <int N, int M, int Bits>
constexpr Columns<N + M - 1, Bits> product(const Digits<N, Bits>& a, const Digits<M, Bits>& b) {
  Columns<N + M - 1, Bits> result{};
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < M; ++j) result.column[i + j] += Int128{a.digit[i]} * b.digit[j];
  }
  return result;
}

template <int N, int M, int Bits>
constexpr auto operator*(const Digits<N, Bits>& a, const Digits<M, Bits>& b) {
  return product(a, b);
}
template <int N, int M, int Bits>
constexpr auto operator*(const Columns<N, Bits>& a, const Digits<M, Bits>& b) {
  return product(digits(a), b);
}
template <int N, int M, int Bits>
constexpr auto operator*(const Columns<N, Bits>& a, const Columns<M, Bits>& b) {
  return product(digits(a), digits(b));
}

template <int N, int Bits>
constexpr Columns<N, Bits> operator+(const Columns<N, Bits>& a, const Columns<N, Bits>& b) {
  Columns<N, Bits> sum{};
  for (int i = 0; i < N; ++i) sum.column[i] = a.column[i] + b.column[i];
  return sum;
}

template <int N, int Bits>
constexpr Columns<N, Bits> operator-(const Columns<N, Bits>& a, const Columns<N, Bits>& b) {
  Columns<N, Bits> difference{};
  for (int i = 0; i < N; ++i) difference.column[i] = a.column[i] - b.column[i];
  return difference;
}

template <int N, int Bits>
constexpr int sign_of(const Columns<N, Bits>& a) {
  Int128 top = 0;
  std::int64_t below = 0;
  for (int i = 0; i < N; ++i) {
    below |= i == 0 ? 0 : low_digit<Bits>(top);
    top = (i == 0 ? 0 : top >> Bits) + a.column[i];
  }
  return top != 0 ? sign_of(top) : below != 0;
}

template <class A, class B>
constexpr auto wide_product(const A& a, const B& b) -> decltype(a * b) {
  return a * b;
}

}  // namespace wellspaced
