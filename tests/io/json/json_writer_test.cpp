#include "wellspaced/io/json/json_writer.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wellspaced {
namespace {

TEST(JsonWriter, SeparatesMembersAndElements) {
  JsonWriter json;
  json.begin_object().field("a", 1).field("b", "two").key("c").begin_array();
  json.value(true).null().value(0.5).begin_object().end_object().begin_array().end_array();
  json.end_array().field("d", std::uint64_t{18446744073709551615u}).end_object();
  EXPECT_EQ(json.text(), R"({"a":1,"b":"two","c":[true,null,0.5,{},[]],"d":18446744073709551615})");
}

TEST(JsonWriter, WritesNumbersShortestAndNonFiniteOnesAsNull) {
  JsonWriter json;
  json.begin_array().value(0.1).value(1e300).value(std::numeric_limits<double>::quiet_NaN());
  json.value(-std::numeric_limits<double>::infinity()).end_array();
  EXPECT_EQ(json.text(), "[0.1,1e+300,null,null]");
}

TEST(JsonWriter, EscapesQuotesBackslashesAndControls) {
  EXPECT_EQ(json_string("a\"b\\c\n\t\r\x01\x7f/"), "\"a\\\"b\\\\c\\n\\t\\r\\u0001\x7f/\"");
}

TEST(JsonWriter, KeepsUtf8AndReplacesBytesThatAreNone) {
  EXPECT_EQ(json_string("\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80"),
            "\"\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80\"");
  const std::string r = "\xEF\xBF\xBD";
  EXPECT_EQ(json_string("\xff"), '"' + r + '"');
  EXPECT_EQ(json_string("\xC3"), '"' + r + '"') << "cut off";
  EXPECT_EQ(json_string("\xC0\xAF"), '"' + r + r + '"') << "overlong";
  EXPECT_EQ(json_string("\xE0\x80\xAF"), '"' + r + r + r + '"') << "overlong";
  EXPECT_EQ(json_string("\xED\xA0\x80"), '"' + r + r + r + '"') << "surrogate";
  EXPECT_EQ(json_string("\xF4\x90\x80\x80"), '"' + r + r + r + r + '"') << "beyond U+10FFFF";
}

}  // namespace
}  // namespace wellspaced
