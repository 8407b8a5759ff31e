// The Hilbert curve of the plane and of space: the place on it of a cell of a grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace wellspaced::hilbert {

// The Hilbert curve of the plane as an automaton that reads four bits of x and of y at a time. The
// state says how the curve is turned in the current square: bit 0 swaps the axes, bit 1 mirrors
// both. By state << 8 | cell of 16 x 16: next state << 8 | place.
using PlaneCurve = std::array<std::uint16_t, 1024>;

constexpr PlaneCurve make_plane_curve() {
  PlaneCurve table{};
  for (unsigned start = 0; start < 4; ++start) {
    for (unsigned cell = 0; cell < 256; ++cell) {
      unsigned state = start, place = 0;
      for (int bit = 3; bit >= 0; --bit) {
        unsigned x = (cell >> (4 + bit)) & 1, y = (cell >> bit) & 1;
        if (state & 2) x ^= 1, y ^= 1;
        if (state & 1) std::swap(x, y);
        const unsigned quadrant = (3 * x) ^ y;
        place = place << 2 | quadrant;
        if (quadrant == 0) state ^= 1;
        if (quadrant == 3) state ^= 3;
      }
      table[start << 8 | cell] = static_cast<std::uint16_t>(state << 8 | place);
    }
  }
  return table;
}

inline constexpr PlaneCurve kPlaneCurve = make_plane_curve();

// The Hilbert curve of space as an automaton that reads two bits of x, y and z at a time (Hamilton,
// Compact Hilbert indices, 2006). The state 3 * entry + axis says how the curve is turned in the
// current cube: the corner where it enters, and the axis along which it leaves. By state << 6 |
// cell of 4 x 4 x 4: next state << 6 | place.
using SpaceCurve = std::array<std::uint16_t, 24 * 64>;

constexpr unsigned rotate3(unsigned bits, unsigned by) {
  return (bits << by | bits >> (3 - by)) & 7u;
}

constexpr SpaceCurve make_space_curve() {
  // By the octant's place on the untilted curve: its entry corner and its direction.
  constexpr std::array<unsigned, 8> kEntry{0, 0, 0, 3, 3, 6, 6, 5};
  constexpr std::array<unsigned, 8> kAxis{0, 1, 1, 2, 2, 1, 1, 0};
  SpaceCurve table{};
  for (unsigned start = 0; start < 24; ++start) {
    for (unsigned cell = 0; cell < 64; ++cell) {
      unsigned entry = start / 3, axis = start % 3, place = 0;
      for (unsigned bit = 2; bit-- > 0;) {
        const unsigned x = cell >> (4 + bit) & 1, y = cell >> (2 + bit) & 1, z = cell >> bit & 1;
        const unsigned turn = (axis + 1) % 3;
        const unsigned gray = rotate3((x | y << 1 | z << 2) ^ entry, 3 - turn);
        const unsigned octant = gray ^ gray >> 1 ^ gray >> 2;
        place = place << 3 | octant;
        entry ^= rotate3(kEntry[octant], turn);
        axis = (axis + kAxis[octant] + 1) % 3;
      }
      const unsigned state = 3 * entry + axis;
      table[start << 6 | cell] = static_cast<std::uint16_t>(state << 6 | place);
    }
  }
  return table;
}

inline constexpr SpaceCurve kSpaceCurve = make_space_curve();

/// The automaton reads so many bits of each coordinate at a time, at most kMaxAxisBits in all.
template <std::size_t Dimension>
inline constexpr int kStepBits = Dimension == 2 ? 4 : 2;
template <std::size_t Dimension>
inline constexpr int kMaxAxisBits = Dimension == 2 ? 16 : 10;

/// The place on the curve, from 0, of a cell of a grid with 2^axis_bits cells along each axis.
/// Cells with places next to each other have a side in common. Requires: axis_bits is a multiple of
/// kStepBits, up to kMaxAxisBits; cell[k] < 2^axis_bits. Cost: a look at a table each step.
inline std::uint32_t place(const std::array<std::uint32_t, 2>& cell, int axis_bits) {
  std::uint32_t result = 0, entry = 0;
  for (int shift = axis_bits - kStepBits<2>; shift >= 0; shift -= kStepBits<2>) {
    const std::uint32_t part = ((cell[0] >> shift) & 15u) << 4 | ((cell[1] >> shift) & 15u);
    entry = kPlaneCurve[(entry & ~255u) | part];
    result = result << 8 | (entry & 255u);
  }
  return result;
}

inline std::uint32_t place(const std::array<std::uint32_t, 3>& cell, int axis_bits) {
  std::uint32_t result = 0, entry = 0;
  for (int shift = axis_bits - kStepBits<3>; shift >= 0; shift -= kStepBits<3>) {
    const std::uint32_t part =
        ((cell[0] >> shift) & 3u) << 4 | ((cell[1] >> shift) & 3u) << 2 | ((cell[2] >> shift) & 3u);
    entry = kSpaceCurve[(entry & ~63u) | part];
    result = result << 6 | (entry & 63u);
  }
  return result;
}

}  // namespace wellspaced::hilbert
