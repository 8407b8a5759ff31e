#include "wellspaced/io/json/json_reader.hpp"

#include <gtest/gtest.h>

#include "wellspaced/io/json/json_writer.hpp"

namespace wellspaced {
namespace {

TEST(JsonReader, ReadsEveryKindOfValue) {
  const auto json =
      parse_json(" {\"a\" : [1, -2.5e3, true, false, null], \"b\": {\"c\": \"x\"}} \n", "text")
          .value();
  const JsonValue* a = json.find("a");
  ASSERT_NE(a, nullptr);
  ASSERT_EQ(a->items.size(), 5u);
  EXPECT_EQ(a->items[0].number, 1);
  EXPECT_EQ(a->items[1].number, -2500);
  EXPECT_EQ(a->items[2].kind, JsonValue::Kind::kTrue);
  EXPECT_EQ(a->items[3].kind, JsonValue::Kind::kFalse);
  EXPECT_EQ(a->items[4].kind, JsonValue::Kind::kNull);
  EXPECT_EQ(json.find("b")->find("c")->text, "x");
  EXPECT_EQ(json.find("d"), nullptr);
  EXPECT_EQ(a->find("x"), nullptr);
}

TEST(JsonReader, ReadsEscapes) {
  EXPECT_EQ(
      parse_json("\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u0041\\u00e9\\u20AC\\ud83d\\ude00\"", "t")->text,
      "\"\\/\b\f\n\r\tA\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(JsonReader, ReadsWhatTheWriterWrites) {
  JsonWriter writer;
  writer.begin_object().field("text", "a\n\"b\"\x01").field("number", 0.1);
  writer.key("list").begin_array().value(1).value(true).null().end_array().end_object();
  const auto json = parse_json(writer.text(), "text").value();
  EXPECT_EQ(json.find("text")->text, "a\n\"b\"\x01");
  EXPECT_EQ(json.find("number")->number, 0.1);
  EXPECT_EQ(json.find("list")->items.size(), 3u);
}

TEST(JsonReader, RefusesWhatIsNoJson) {
  for (const char* text : {"",
                           " ",
                           "{",
                           "}",
                           "[1,]",
                           "[1 2]",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{a:1}",
                           "{\"a\":1,}",
                           "01",
                           "1.",
                           ".5",
                           "+1",
                           "1e",
                           "1e999",
                           "nan",
                           "tru",
                           "\"",
                           "\"\\x\"",
                           "\"\\u12\"",
                           "\"\\ud800\"",
                           "\"\\ud800\\u0041\"",
                           "\"\n\"",
                           "1 2",
                           "[1]]",
                           "'a'",
                           "\"\\",
                           "-"})
    EXPECT_FALSE(parse_json(text, "text").ok()) << text;
}

TEST(JsonReader, RefusesWhatIsTooDeep) {
  EXPECT_TRUE(parse_json(std::string(60, '[') + std::string(60, ']'), "text").ok());
  EXPECT_FALSE(parse_json(std::string(100000, '['), "text").ok());
  EXPECT_FALSE(parse_json(std::string(1000, '[') + std::string(1000, ']'), "text").ok());
}

TEST(JsonReader, NamesTheLine) {
  const auto json = parse_json("{\n\"a\": 1\n\"b\": 2}", "name");
  ASSERT_FALSE(json.ok());
  EXPECT_EQ(json.error().message, "name:3: this is no JSON");
}

}  // namespace
}  // namespace wellspaced
