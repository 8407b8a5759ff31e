#include "wellspaced/io/report/solid_report.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/json.hpp"
#include "wellspaced/io/json/json_reader.hpp"
#include "wellspaced/io/text/base64.hpp"

namespace wellspaced {
namespace {

TetMesh two_tets() {
  TetMesh mesh;
  mesh.points = {{1, 1, 1}, {3, 1, 1}, {1, 2, 1}, {1, 1, 1.5}, {2, 2, 2}};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 4, 3}};
  return mesh;
}

std::string page_of(const TetMesh& mesh, std::size_t most = 100) {
  return solid_report_html({"a <mesh> & more", {{"tets & such", "2 < 3"}}, &mesh, most});
}

// The data block of the page.
std::string data_of(const std::string& page) {
  const std::string open = "id=\"data\">";
  const std::size_t from = page.find(open) + open.size();
  return page.substr(from, page.find("</script>", from) - from);
}

std::vector<std::uint32_t> numbers_of(std::string_view text) {
  const auto bytes = decode_base64(text);
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; bytes && i + 4 <= bytes->size(); i += 4) {
    std::uint32_t number = 0;
    for (std::size_t k = 4; k-- > 0;)
      number = number << 8 | static_cast<unsigned char>((*bytes)[i + k]);
    numbers.push_back(number);
  }
  return numbers;
}

TEST(SolidReport, HoldsTheMesh) {
  const auto tree = parse_json(data_of(page_of(two_tets())), "data");
  ASSERT_TRUE(tree.ok());
  const test::JsonView json(&*tree);
  EXPECT_EQ(json["count"].number(), 2);
  EXPECT_EQ(json["tets"]["count"].number(), 2);
  const auto tets = numbers_of(json["tets"]["data"].text());
  ASSERT_EQ(tets.size(), 8u);
  EXPECT_EQ((std::vector(tets.begin(), tets.begin() + 4)),
            (std::vector<std::uint32_t>{0, 1, 2, 3}));
  const auto steps = numbers_of(json["points"]["xyz"].text());
  ASSERT_EQ(steps.size(), 15u);
  EXPECT_EQ(steps[3], 4294967295u) << "the longest extent, from 1 to 3";
  EXPECT_EQ(steps[7], 2147483648u);
  EXPECT_NE(data_of(page_of(two_tets())).find("\"size\":[4294967295,2147483648,"),
            std::string::npos);
}

TEST(SolidReport, TurnsInvertedTetsAndLeavesFlatOnesOut) {
  TetMesh mesh = two_tets();
  mesh.tets = {{1, 0, 2, 3}, {0, 1, 1, 2}};
  const auto tree = parse_json(data_of(page_of(mesh)), "data");
  ASSERT_TRUE(tree.ok());
  const test::JsonView json(&*tree);
  EXPECT_EQ(json["tets"]["count"].number(), 1);
  EXPECT_EQ(numbers_of(json["tets"]["data"].text()), (std::vector<std::uint32_t>{1, 0, 3, 2}));
}

TEST(SolidReport, IsOnePageThatLoadsNothing) {
  const std::string page = page_of(two_tets());
  EXPECT_EQ(page, page_of(two_tets()));
  for (const char* word : {"@TITLE@", "@STYLE@", "@PARAMETERS@", "@DATA@", "@SCRIPT@"})
    EXPECT_EQ(page.find(word), page.npos) << word;
  EXPECT_NE(page.find("<title>a &lt;mesh&gt; &amp; more</title>"), page.npos);
  EXPECT_NE(page.find("<dt>tets &amp; such</dt><dd>2 &lt; 3</dd>"), page.npos);
  for (const char* word : {"src=", "@import", "url(", "<link"})
    EXPECT_EQ(page.find(word), page.npos) << word;
}

TEST(SolidReport, DrawsNoMeshThatIsTooLarge) {
  const std::string data = data_of(page_of(two_tets(), 1));
  EXPECT_EQ(data, "{\"count\":2}");
}

TEST(SolidReport, TakesEmptyAndHugeMeshes) {
  EXPECT_NE(page_of({}).find("</html>"), std::string::npos);
  TetMesh huge = two_tets();
  for (Point3& p : huge.points) p = {p.x * 0x1p1022 - 0x1p1023, p.y * 0x1p1022, p.z * 0x1p1022};
  EXPECT_EQ(data_of(page_of(huge)), data_of(page_of(two_tets())));
}

}  // namespace
}  // namespace wellspaced
