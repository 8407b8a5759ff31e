#include "wellspaced/io/text/numbers.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

double value_of(std::string_view text) {
  const ParsedNumber number = parse_number(text);
  EXPECT_EQ(number.status, NumberStatus::kOk) << text;
  return number.value;
}

// A finite double with every bit pattern equally likely, subnormals often.
double random_double(Random& random) {
  for (;;) {
    std::uint64_t pattern = random.bits();
    if (random.below(8) == 0) pattern &= 0x800FFFFFFFFFFFFFu;
    const double x = std::bit_cast<double>(pattern);
    if (std::isfinite(x)) return x;
  }
}

std::string printed(const char* format, double x) {
  char space[1400];
  std::snprintf(space, sizeof space, format, x);
  return space;
}

TEST(ParseNumber, ReadsTheUsualForms) {
  EXPECT_EQ(value_of("1"), 1);
  EXPECT_EQ(value_of("+1.5"), 1.5);
  EXPECT_EQ(value_of("-.5"), -0.5);
  EXPECT_EQ(value_of("1."), 1);
  EXPECT_EQ(value_of("1e+2"), 100);
  EXPECT_EQ(value_of("1E-2"), 0.01);
  EXPECT_EQ(value_of("1.5D+01"), 15);
  EXPECT_EQ(value_of("0x1.8p-3"), 0.1875);
  EXPECT_EQ(value_of("-0X1P4"), -16);
  EXPECT_EQ(value_of("0x.8"), 0.5);
}

TEST(ParseNumber, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"",    "+",   "-",   ".",  "e5", "1e", "1e+",    "1,5", "1.2.3", "0x",    "0xg",
        "--1", "+-1", "-+1", "1f", "1 ", " 1", "0x1.8p", "1d",  "abc",   "1e5e5", "1_000"})
    EXPECT_EQ(parse_number(text).status, NumberStatus::kMalformed) << text;
}

// Found by fuzzing.
TEST(ParseNumber, RefusesASignOrAWordBehindTheHexPrefix) {
  for (const char* text :
       {"0x-1708p-174", "0x+1", "0xinf", "0xnan", "-0x-1", "0x-inf", "0x8p+-1705", "0x8p--5"})
    EXPECT_EQ(parse_number(text).status, NumberStatus::kMalformed) << text;
}

TEST(ParseNumber, ReadsNanAndInfinityAsSuch) {
  EXPECT_TRUE(std::isnan(value_of("nan")));
  EXPECT_TRUE(std::isnan(value_of("-NaN")));
  EXPECT_EQ(value_of("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(value_of("Infinity"), std::numeric_limits<double>::infinity());
}

TEST(ParseNumber, UnderflowGivesASignedZeroOrTheNearestSubnormal) {
  EXPECT_EQ(bits(value_of("1e-400")), bits(0.0));
  EXPECT_EQ(bits(value_of("-1e-400")), bits(-0.0));
  EXPECT_EQ(bits(value_of("-0x1p-2000")), bits(-0.0));
  EXPECT_EQ(value_of("4.9e-324"), 5e-324);
  EXPECT_EQ(value_of("2.5e-324"), 5e-324);
  EXPECT_EQ(bits(value_of("2.4e-324")), bits(0.0));
  EXPECT_EQ(value_of("0x1p-1074"), 5e-324);
  EXPECT_EQ(bits(value_of("0x1p-1075")), bits(0.0)) << "a tie goes to the even neighbour";
  EXPECT_EQ(value_of("0x1.8p-1074"), 1e-323);
  EXPECT_EQ(bits(value_of(std::string("0.").append(1000, '0') + "1")), bits(0.0));
  EXPECT_EQ(bits(value_of("1e-99999999999999999999")), bits(0.0));
  EXPECT_EQ(bits(value_of("0e99999999999999999999")), bits(0.0));
  EXPECT_EQ(bits(value_of("0x0p99999999999999999999")), bits(0.0));
}

TEST(ParseNumber, OverflowIsAnError) {
  for (const std::string text : {"1e400", "-1e309", "1.8e308", "0x1p1024", "1e99999999999999999999",
                                 "0x1p+99999999999999999999", "0x1.fffffffffffff8p1023"})
    EXPECT_EQ(parse_number(text).status, NumberStatus::kTooLarge) << text;
  EXPECT_EQ(parse_number(std::string("1").append(400, '0')).status, NumberStatus::kTooLarge);
  EXPECT_EQ(value_of("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(value_of("1.7976931348623158e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(value_of(std::string("1").append(400, '0') + "e-400"), 1);
  EXPECT_EQ(value_of(std::string("0.").append(400, '0') + "1e401"), 1);
}

TEST(ParseNumber, RoundsHalfwayCasesToEvenAndSeesTheLastDigit) {
  EXPECT_EQ(value_of("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(value_of("9007199254740995"), 9007199254740996.0);
  EXPECT_EQ(value_of(std::string("9007199254740993.").append(800, '0') + "1"), 9007199254740994.0);
  EXPECT_EQ(value_of(std::string("9007199254740992.9").append(2000, '9')), 9007199254740992.0);
  EXPECT_EQ(value_of("0x1.00000000000008p0"), 1.0);
  EXPECT_EQ(value_of("0x1.000000000000080000000000000001p0"), 1.0 + 0x1p-52);
  EXPECT_EQ(value_of("0x1.00000000000018p0"), 1.0 + 0x1p-51);
  EXPECT_EQ(value_of("2.2250738585072011e-308"), 0x0.fffffffffffffp-1022)
      << "the number that hung PHP and Java";
}

TEST(ParseNumber, ReadsTenMillionDigitsExactly) {
  EXPECT_EQ(value_of(std::string("1").append(10'000'000, '0') + "e-10000000"), 1);
  EXPECT_EQ(value_of(std::string("0.").append(10'000'000, '3')), 1.0 / 3);
}

TEST(ParseNumber, AgreesWithStrtodOnRandomDecimalsAndHexFloats) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double x = random_double(random);
    for (const char* format : {"%.17g", "%.5e", "%.25e", "%a", "%.3a", "%.20a"}) {
      const std::string text = printed(format, x);
      const double expected = std::strtod(text.c_str(), nullptr);
      if (std::isinf(expected)) {
        EXPECT_EQ(parse_number(text).status, NumberStatus::kTooLarge) << text;
      } else {
        EXPECT_EQ(bits(value_of(text)), bits(expected)) << text;
      }
    }
  }
}

TEST(ParseNumber, AgreesWithStrtodExactlyBetweenNeighbours) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::abs(random_double(random)) / 4;
    const long double middle =
        (static_cast<long double>(x) + std::nextafter(x, std::numeric_limits<double>::max())) / 2;
    char text[1400];
    std::snprintf(text, sizeof text, "%.1200Le", middle);
    EXPECT_EQ(bits(value_of(text)), bits(std::strtod(text, nullptr))) << text;
  }
}

TEST(Shortest, ReadsBackBitForBit) {
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const double x = random_double(random);
    EXPECT_EQ(bits(value_of(shortest(x))), bits(x)) << shortest(x);
  }
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(1e22), "1e+22");
}

TEST(ParseInteger, ReadsPlainIntegersAndWholeReals) {
  EXPECT_EQ(parse_integer("42"), 42);
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_EQ(parse_integer("-3.0"), -3);
  EXPECT_EQ(parse_integer("1e3"), 1000);
  EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  for (const char* text :
       {"", "1.5", "abc", "nan", "inf", "1e300", "1x", "-", "9223372036854775808"})
    EXPECT_FALSE(parse_integer(text).has_value()) << text;
}

}  // namespace
}  // namespace wellspaced
