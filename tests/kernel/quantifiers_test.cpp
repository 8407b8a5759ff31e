#include "wellspaced/kernel/quantifiers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace wellspaced {
namespace {

bool is_even(int x) { return x % 2 == 0; }

TEST(Quantifiers, HoldOfAnEmptyListAsInLogic) {
  const std::vector<int> none;
  EXPECT_FALSE(any_of(none, is_even));
  EXPECT_TRUE(none_of(none, is_even));
  EXPECT_TRUE(all_of(none, is_even));
  EXPECT_FALSE(is_among(1, none));
}

TEST(Quantifiers, TellSomeFromAllAndNone) {
  constexpr std::array<int, 3> kOdd{1, 3, 5}, kMixed{1, 2, 3}, kEven{2, 4, 6};
  EXPECT_FALSE(any_of(kOdd, is_even));
  EXPECT_TRUE(none_of(kOdd, is_even));
  EXPECT_TRUE(any_of(kMixed, is_even));
  EXPECT_FALSE(all_of(kMixed, is_even));
  EXPECT_FALSE(none_of(kMixed, is_even));
  EXPECT_TRUE(all_of(kEven, is_even));
  EXPECT_TRUE(is_among(3, kMixed));
  EXPECT_FALSE(is_among(4, kMixed));
}

TEST(Quantifiers, AskNoFurtherThanTheyMust) {
  const std::vector<int> list{1, 2, 3};
  std::vector<int> asked;
  const auto note = [&](int x) {
    asked.push_back(x);
    return is_even(x);
  };
  EXPECT_TRUE(any_of(list, note));
  EXPECT_EQ(asked, (std::vector<int>{1, 2}));
  asked.clear();
  EXPECT_FALSE(all_of(list, note));
  EXPECT_EQ(asked, (std::vector<int>{1}));
}

}  // namespace
}  // namespace wellspaced
