#include "wellspaced/io/text/scanner.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wellspaced {
namespace {

std::vector<std::vector<double>> all_lines(std::string_view text) {
  Scanner scanner(text, "file");
  std::vector<std::vector<double>> lines;
  while (scanner.next_line()) {
    lines.emplace_back();
    while (scanner.ok() && scanner.more()) lines.back().push_back(scanner.number("number"));
  }
  EXPECT_TRUE(scanner.ok()) << scanner.error().message;
  return lines;
}

Error first_error(std::string_view text) {
  Scanner scanner(text, "file");
  while (scanner.next_line()) scanner.number("x");
  EXPECT_FALSE(scanner.ok());
  return scanner.ok() ? Error{} : scanner.error();
}

TEST(Scanner, SplitsLinesAtBlanksAndSkipsCommentsAndEmptyLines) {
  const std::vector<std::vector<double>> expected = {{1, 2}, {3}, {4, 5}};
  EXPECT_EQ(all_lines("1 2\n3\n4 5\n"), expected);
  EXPECT_EQ(all_lines("1 2\n3\n4 5"), expected) << "no last newline";
  EXPECT_EQ(all_lines("1 2\r\n3\r\n\r\n4 5\r\n"), expected) << "CRLF";
  EXPECT_EQ(all_lines("\t1\t\t2  \n\n \n\f3\v\n4 5"), expected) << "all kinds of blanks";
  EXPECT_EQ(all_lines("# 9\n1 2 # 9 9\n3#\n#\n4 5 #"), expected) << "comments";
  EXPECT_EQ(all_lines("\xEF\xBB\xBF"
                      "1 2\n3\n4 5"),
            expected)
      << "byte order mark";
}

TEST(Scanner, SeesNothingInAnEmptyText) {
  EXPECT_TRUE(all_lines("").empty());
  EXPECT_TRUE(all_lines("\n\r\n  # nothing").empty());
}

TEST(Scanner, NamesFileAndLineOfTheFirstFailure) {
  EXPECT_EQ(first_error("1\n\n# c\r\nabc\nxyz\n").message, "file:4: the x 'abc' is not a number");
  EXPECT_EQ(first_error("1e999").message, "file:1: the x '1e999' is too large for a double");
  EXPECT_EQ(first_error("abc").code, ErrorCode::kUnreadable);
}

TEST(Scanner, RefusesNanAndInfinityAsInvalidGeometry) {
  for (const char* text : {"nan", "-inf", "1\n2\n-nan", "infinity"}) {
    const Error error = first_error(text);
    EXPECT_EQ(error.code, ErrorCode::kInvalidGeometry) << text;
    EXPECT_NE(error.message.find("is not finite"), std::string::npos) << text;
  }
}

TEST(Scanner, StopsAtTheFirstFailureAndReadsZerosFromThereOn) {
  Scanner scanner("1 x 3\n4 5 6\n", "file");
  EXPECT_TRUE(scanner.next_line());
  EXPECT_EQ(scanner.number("a"), 1);
  EXPECT_EQ(scanner.number("b"), 0);
  EXPECT_EQ(scanner.number("c"), 0);
  EXPECT_EQ(scanner.integer("d"), 0);
  EXPECT_FALSE(scanner.next_line());
  EXPECT_NE(scanner.error().message.find("the b"), std::string::npos);
}

TEST(Scanner, SaysWhatIsMissing) {
  Scanner short_line("1\n", "file");
  short_line.next_line();
  short_line.number("x");
  short_line.number("y");
  EXPECT_EQ(short_line.error().message, "file:1: the y is missing");
  Scanner short_file("1\n", "file");
  short_file.next_line();
  EXPECT_FALSE(short_file.require_line("point 2"));
  EXPECT_EQ(short_file.error().message, "file:1: the file ends where point 2 should follow");
}

TEST(Scanner, RefusesCountsThatTheFileCannotKeep) {
  Scanner scanner("3 2\n1 2\n3 4\n5 6", "file");
  scanner.next_line();
  EXPECT_TRUE(scanner.has_room_for(3, 2, "points"));
  EXPECT_TRUE(scanner.has_room_for(0, 2, "points"));
  EXPECT_FALSE(scanner.has_room_for(4, 2, "points"));
  Scanner hostile("18446744073709551615 2\n1 2\n", "file");
  hostile.next_line();
  EXPECT_FALSE(hostile.has_room_for(~std::uint64_t{0}, ~std::uint64_t{0}, "points"));
}

TEST(Scanner, QuotesGarbageShortAndPrintable) {
  EXPECT_EQ(in_quotes("a\x01\xff"), "'a\\x01\\xff'");
  EXPECT_EQ(in_quotes(std::string(100, 'x')), std::string("'").append(24, 'x') + "...'");
  EXPECT_EQ(first_error(std::string_view("\0\0", 2)).message,
            "file:1: the x '\\x00\\x00' is not a number");
}

TEST(Scanner, TakesALineOfTenMillionCharactersInItsStride) {
  const std::string text = std::string("1").append(10'000'000, ' ') + "2\n3";
  Scanner scanner(text, "file");
  ASSERT_TRUE(scanner.next_line());
  EXPECT_EQ(scanner.count_fields(), 2u);
  EXPECT_EQ(scanner.number("a") + scanner.number("b"), 3);
  ASSERT_TRUE(scanner.next_line());
  EXPECT_EQ(scanner.number("c"), 3);
}

TEST(Scanner, RefusesMarkersBeyondAnInt) {
  Scanner scanner("2147483648", "file");
  scanner.next_line();
  EXPECT_EQ(scanner.marker(), 0);
  EXPECT_FALSE(scanner.ok());
}

}  // namespace
}  // namespace wellspaced
