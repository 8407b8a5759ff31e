#include "wellspaced/kernel/plane/morton.hpp"

#include <gtest/gtest.h>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

TEST(Morton, InterleavesColumnAndRow) {
  EXPECT_EQ(morton::encode(0b11, 0), 0b0101u);
  EXPECT_EQ(morton::encode(0, 0b11), 0b1010u);
  EXPECT_EQ(morton::encode(0b101, 0b011), 0b011011u);
}

TEST(Morton, DecodesWhatItEncodes) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto column = static_cast<std::uint32_t>(random.bits());
    const auto row = static_cast<std::uint32_t>(random.bits());
    EXPECT_EQ(morton::column(morton::encode(column, row)), column);
    EXPECT_EQ(morton::row(morton::encode(column, row)), row);
  }
}

TEST(Morton, StepsToTheNextCellInEveryDirection) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const auto column = static_cast<std::uint32_t>(1 + random.below((1u << 31) - 2));
    const auto row = static_cast<std::uint32_t>(1 + random.below((1u << 31) - 2));
    const MortonCode code = morton::encode(column, row);
    for (const int step : {-1, 0, 1}) {
      const auto by = static_cast<std::uint32_t>(step);
      EXPECT_EQ(morton::step_column(code, step), morton::encode(column + by, row));
      EXPECT_EQ(morton::step_row(code, step), morton::encode(column, row + by));
    }
  }
}

TEST(Morton, KnowsTheDeepestCommonCell) {
  EXPECT_EQ(morton::common_depth(5, 5), 31);
  EXPECT_EQ(morton::common_depth(4, 7), 30);
  EXPECT_EQ(morton::common_depth(3, 4), 29);
  EXPECT_EQ(morton::common_depth(0, morton::cells_in(0) - 1), 0);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const MortonCode a = random.below(morton::cells_in(0));
    const MortonCode b = a ^ random.below(MortonCode{1} << random.below(62));
    const int depth = morton::common_depth(a, b);
    EXPECT_EQ(morton::ancestor(a, depth), morton::ancestor(b, depth));
    if (depth < kMortonDepth)
      EXPECT_NE(morton::ancestor(a, depth + 1), morton::ancestor(b, depth + 1));
  }
}

TEST(Morton, KnowsTheLargestCellThatStartsAtACell) {
  EXPECT_EQ(morton::coarsest_depth(0), 0);
  EXPECT_EQ(morton::coarsest_depth(1), 31);
  EXPECT_EQ(morton::coarsest_depth(8), 30);
  EXPECT_EQ(morton::coarsest_depth(morton::cells_in(1)), 1);
  EXPECT_EQ(morton::coarsest_depth(2 * morton::cells_in(1)), 1);
}

}  // namespace
}  // namespace wellspaced
