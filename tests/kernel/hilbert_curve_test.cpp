#include "wellspaced/kernel/hilbert_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace wellspaced {
namespace {

template <std::size_t Dimension>
using Cell = std::array<std::uint32_t, Dimension>;

// The cells of a grid in the order of their places; empty if two share a place.
template <std::size_t Dimension>
std::vector<Cell<Dimension>> cells_along_curve(int axis_bits) {
  const std::size_t count = std::size_t{1} << (Dimension * axis_bits);
  std::vector<Cell<Dimension>> cells(count);
  std::vector<bool> taken(count);
  for (std::size_t number = 0; number < count; ++number) {
    Cell<Dimension> cell;
    for (std::size_t k = 0; k < Dimension; ++k)
      cell[k] = number >> (k * axis_bits) & ((1u << axis_bits) - 1);
    const std::size_t place = hilbert::place(cell, axis_bits);
    if (place >= count || taken[place]) return {};
    taken[place] = true;
    cells[place] = cell;
  }
  return cells;
}

template <std::size_t Dimension>
std::int64_t steps_between(const Cell<Dimension>& a, const Cell<Dimension>& b) {
  std::int64_t steps = 0;
  for (std::size_t k = 0; k < Dimension; ++k) steps += std::abs(std::int64_t{a[k]} - b[k]);
  return steps;
}

template <std::size_t Dimension>
void expect_curve(int axis_bits) {
  const auto cells = cells_along_curve<Dimension>(axis_bits);
  ASSERT_FALSE(cells.empty()) << axis_bits;
  for (std::size_t i = 1; i < cells.size(); ++i)
    ASSERT_EQ(steps_between(cells[i - 1], cells[i]), 1) << axis_bits << " bits, place " << i;
}

TEST(HilbertCurve, PassesThroughEachCellOfThePlaneAndOnOverASide) {
  for (const int axis_bits : {4, 8}) expect_curve<2>(axis_bits);
}

TEST(HilbertCurve, PassesThroughEachCellOfSpaceAndOnOverASide) {
  for (const int axis_bits : {2, 4, 6}) expect_curve<3>(axis_bits);
}

TEST(HilbertCurve, EndsInACornerOfTheFinestGrid) {
  EXPECT_EQ(hilbert::place(Cell<2>{0, 0}, 16), 0u);
  EXPECT_EQ(hilbert::place(Cell<3>{0, 0, 0}, 10), 0u);
  EXPECT_EQ(std::max(hilbert::place(Cell<2>{65535, 0}, 16), hilbert::place(Cell<2>{0, 65535}, 16)),
            0xffffffffu);
}

}  // namespace
}  // namespace wellspaced
