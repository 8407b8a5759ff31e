// Morton codes: cells of a square halved again and again, numbered along the Z curve.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace wellspaced {

/// The cells of depth d are a grid of 2^d x 2^d. The code of a cell interleaves the bits of its
/// column (even places) and row (odd places), so a cell's last two bits say which quarter of its
/// parent it is, and code >> 2 is the parent.
using MortonCode = std::uint64_t;

/// Rows and columns of the deepest grid have so many bits.
inline constexpr int kMortonDepth = 31;

namespace morton {

inline constexpr MortonCode kColumns = 0x5555555555555555u;
inline constexpr MortonCode kRows = ~kColumns;

/// Puts the low 32 bits of x at the even places.
constexpr MortonCode spread(std::uint32_t x) {
  MortonCode code = x;
  code = (code | code << 16) & 0x0000FFFF0000FFFFu;
  code = (code | code << 8) & 0x00FF00FF00FF00FFu;
  code = (code | code << 4) & 0x0F0F0F0F0F0F0F0Fu;
  code = (code | code << 2) & 0x3333333333333333u;
  return (code | code << 1) & kColumns;
}

/// Takes the bits at the even places together: the inverse of spread.
constexpr std::uint32_t gather(MortonCode code) {
  code &= kColumns;
  code = (code | code >> 1) & 0x3333333333333333u;
  code = (code | code >> 2) & 0x0F0F0F0F0F0F0F0Fu;
  code = (code | code >> 4) & 0x00FF00FF00FF00FFu;
  code = (code | code >> 8) & 0x0000FFFF0000FFFFu;
  return static_cast<std::uint32_t>(code | code >> 16);
}

constexpr MortonCode encode(std::uint32_t column, std::uint32_t row) {
  return spread(column) | spread(row) << 1;
}
constexpr std::uint32_t column(MortonCode code) { return gather(code); }
constexpr std::uint32_t row(MortonCode code) { return gather(code >> 1); }

/// The cell `step` (-1, 0 or 1) columns on, in the same row; wraps around at the grid's border.
constexpr MortonCode step_column(MortonCode code, int step) {
  if (step == 0) return code;
  const MortonCode moved = step > 0 ? (code | kRows) + 1 : (code & kColumns) - 1;
  return (moved & kColumns) | (code & kRows);
}
constexpr MortonCode step_row(MortonCode code, int step) {
  if (step == 0) return code;
  const MortonCode moved = step > 0 ? (code | kColumns) + 2 : (code & kRows) - 2;
  return (moved & kRows) | (code & kColumns);
}

/// The first cell of the deepest grid in a cell of depth d.
constexpr MortonCode first_in(MortonCode code, int depth) {
  return code << 2 * (kMortonDepth - depth);
}
/// The cell of depth d that has a cell of the deepest grid.
constexpr MortonCode ancestor(MortonCode deepest, int depth) {
  return deepest >> 2 * (kMortonDepth - depth);
}
/// How many cells of the deepest grid a cell of depth d has: 4^(31 - d).
constexpr MortonCode cells_in(int depth) { return MortonCode{1} << 2 * (kMortonDepth - depth); }

/// The depth of the deepest cell that has both cells of the deepest grid.
constexpr int common_depth(MortonCode a, MortonCode b) {
  return a == b ? kMortonDepth : (std::countl_zero(a ^ b) - 2) / 2;
}
/// The depth of the largest cell whose first cell of the deepest grid is `start`.
constexpr int coarsest_depth(MortonCode start) {
  return start == 0 ? 0 : kMortonDepth - std::countr_zero(start) / 2;
}

}  // namespace morton
}  // namespace wellspaced
