#include "wellspaced/io/reproduce/chapter_page.hpp"

#include <gtest/gtest.h>

namespace wellspaced {
namespace {

// An exhibit of one table, whose first row differs.
Exhibit some_exhibit() {
  Exhibit exhibit{.name = "table-9", .title = "Table 9: A & B", .notes = {"A note."}};
  ExhibitTable table{.name = "table-9-function", .title = "One"};
  table.columns = {{"", "nodes", 0, CellRule::kWithinRuns, true},
                   {"angles", "smallest", 2, CellRule::kTwoDegrees}};
  table.rows = {{"1", {{103, 100, 102, 104}, {20, 24, 20, 20}}},
                {"2", {{51, 50, 40, 60}, {20, 21, 20, 20}}},
                {"3", {{20, 40, 10, 60}, {20, {}, 20, 20}}}};
  exhibit.tables = {table};
  exhibit.pictures = {{"picture", "Caption", "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>\n"}};
  return exhibit;
}

std::string page_of(const std::vector<Exhibit>& exhibits) {
  return chapter_html({{{"runs", "30"}}, exhibits});
}

TEST(ChapterPage, HoldsTablesPicturesAndDifferences) {
  const std::string html = page_of({some_exhibit()});
  for (const char* part :
       {"<section id=\"table-9\">", "<h2>Table 9: A &amp; B</h2>", "A note.", "<figcaption>Caption",
        "<td class=\" beyond\">103</td>", "<dt>runs</dt><dd>30</dd>",
        "level 1, nodes: 103 (100); level 1, angles, smallest: 20.00 (24.00); level 3, angles, "
        "smallest: 20.00 (-)",
        "5 figures are compared; 3 differ"})
    EXPECT_NE(html.find(part), html.npos) << part << '\n' << html;
}

TEST(ChapterPage, LoadsNothingAndRunsNothing) {
  const std::string html = page_of({some_exhibit()});
  for (const char* part : {"<script", "<link", "src=", "url("})
    EXPECT_EQ(html.find(part), html.npos) << part;
}

TEST(ChapterPage, TablesThatRepeatAreInTheFilesAlone) {
  Exhibit exhibit = some_exhibit();
  exhibit.tables[0].repeats = true;
  const std::string html = page_of({exhibit});
  EXPECT_EQ(html.find("<caption>One</caption>"), html.npos);
  EXPECT_NE(html.find("No figure is compared"), html.npos);
}

TEST(ChapterPage, SizesAreJudgedDownToFiftyNodes) {
  const std::vector<Exhibit> exhibits = {some_exhibit()};
  const Agreement agreement = agreement_of(exhibits);
  EXPECT_EQ(agreement.compared, 5u);
  EXPECT_EQ(agreement.differing, 3u);
  EXPECT_EQ(agreement.size_rows, 2u);
  EXPECT_NEAR(agreement.largest_size_percent, 3, 1e-12);
}

}  // namespace
}  // namespace wellspaced
