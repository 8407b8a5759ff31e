#include "wellspaced/kernel/concat.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "wellspaced/kernel/result.hpp"

namespace wellspaced {
namespace {

TEST(Concat, JoinsWordsOfAllKindsInOrder) {
  const std::string name = "lake";
  EXPECT_EQ(concat({name, ": ", std::string_view("holes", 4), '!', ""}), "lake: hole!");
  EXPECT_EQ(concat({}), "");
}

TEST(Concat, WritesIntegersWhole) {
  EXPECT_EQ(concat({0, ' ', -7, ' ', 3u, ' ', std::uint8_t{200}}), "0 -7 3 200");
  EXPECT_EQ(concat({std::numeric_limits<std::int64_t>::min()}), "-9223372036854775808");
  EXPECT_EQ(concat({std::numeric_limits<std::uint64_t>::max()}), "18446744073709551615");
}

TEST(Concat, WritesRealsAsTheShortestThatReadBackTheSame) {
  EXPECT_EQ(concat({0.1, ' ', 25.0, ' ', 1e22, ' ', -0.0}), "0.1 25 1e+22 -0");
  EXPECT_EQ(concat({-std::numeric_limits<double>::denorm_min()}), "-5e-324");
  EXPECT_EQ(concat({-std::numeric_limits<double>::max()}), "-1.7976931348623157e+308");
}

TEST(Concat, KeepsBytesThatAreZero) {
  EXPECT_EQ(concat({std::string_view("a\0b", 3), '\0'}).size(), 4u);
}

TEST(Append, AddsToWhatIsThere) {
  std::string text = "level ";
  append(text, {2, " of ", 5});
  append(text, {});
  EXPECT_EQ(text, "level 2 of 5");
}

TEST(Error, HoldsItsMessageWholeOrInPieces) {
  const Error whole(ErrorCode::kUsage, "no output");
  EXPECT_EQ(whole.message, "no output");
  EXPECT_TRUE(whole.ids.empty());
  const Error pieces{ErrorCode::kLimit, {"point ", 3}, {3}};
  EXPECT_EQ(pieces.code, ErrorCode::kLimit);
  EXPECT_EQ(pieces.message, "point 3");
  EXPECT_EQ(pieces.ids, std::vector<Index>{3});
  const Error two_words{ErrorCode::kUsage, {"no ", "output"}};
  EXPECT_EQ(two_words.message, whole.message);
}

}  // namespace
}  // namespace wellspaced
