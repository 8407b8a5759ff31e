#include "wellspaced/io/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/io/report/report_data.hpp"

namespace wellspaced {
namespace {

TriangleMesh unit_square() { return generate_grid({.nx = 2, .ny = 2}).value(); }

HtmlReport report_of(const TriangleMesh& mesh) {
  return {.title = "square",
          .parameters = {},
          .methods = {{"function", {}, {{&mesh, {}, mesh_statistics(mesh)}}}}};
}

ReportMethod method_of(const std::string& name, const Hierarchy& hierarchy) {
  ReportMethod method{name, {{"beta", "25"}}, {}};
  const auto rows = hierarchy_statistics(hierarchy);
  for (std::size_t k = 0; k < rows.size(); ++k)
    method.levels.push_back({&hierarchy.levels[k].mesh, hierarchy.levels[k].origin, rows[k]});
  return method;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(ReportData, CodesTheUnitSquareByHand) {
  const TriangleMesh mesh = unit_square();
  const std::string data = report_data(report_of(mesh));
  // Points along the curve (0,0) (0,1) (1,1) (1,0) or its mirror image, 32 bits a coordinate.
  EXPECT_NE(data.find("\"points\":{\"count\":4,\"step\":2.3283064370807974e-10,\"origin\":[0,0],"
                      "\"xy\":\"AAAAAAAAAAAAAAAA/////////////////////wAAAAA=\"}"),
            data.npos)
      << data;
  // All four nodes; triangles (0, 2, 1) and (0, 3, 2) in the curve's numbers.
  EXPECT_NE(data.find("\"nodes\":{\"count\":4,\"data\":\"AAAAAA==\"}"), data.npos) << data;
  EXPECT_NE(data.find("\"triangles\":{\"count\":2,\"data\":\"AAIBAAMB\"}"), data.npos) << data;
}

TEST(ReportData, WritesEqualGeometriesOnce) {
  const TriangleMesh mesh = unit_square();
  HtmlReport report = report_of(mesh);
  report.methods.push_back(report.methods[0]);
  const std::string data = report_data(report);
  EXPECT_EQ(count_of(data, "\"geometry\":0"), 2u);
  EXPECT_EQ(count_of(data, "\"triangles\":{"), 1u);
}

TEST(ReportData, LeavesOutPicturesOfLargeLevels) {
  const TriangleMesh mesh = unit_square();
  HtmlReport report = report_of(mesh);
  report.max_drawn_nodes = 3;
  const std::string data = report_data(report);
  EXPECT_NE(data.find("\"geometry\":null"), data.npos);
  EXPECT_NE(data.find("\"points\":{\"count\":0"), data.npos);
  EXPECT_NE(data.find("\"nodes\":4"), data.npos) << "the statistics stay";
}

TEST(ReportData, KeepsOriginsOfCoarserLevelsTogether) {
  const Hierarchy hierarchy = coarsen(generate_grid({.nx = 20, .ny = 20}).value(), {}).value();
  HtmlReport report{.title = "", .parameters = {}, .methods = {method_of("function", hierarchy)}};
  EXPECT_NE(report_data(report).find("\"points\":{\"count\":400,"), std::string::npos);
  report.methods[0].levels.erase(report.methods[0].levels.begin());
  const std::string coarse = std::to_string(hierarchy.levels[1].mesh.points.size());
  EXPECT_NE(report_data(report).find("\"points\":{\"count\":" + coarse + ","), std::string::npos);
}

TEST(ReportData, LeavesOutWhatWasNotMeasured) {
  const TriangleMesh mesh = unit_square();
  const std::string data = report_data(report_of(mesh));
  EXPECT_NE(data.find("\"interior_min\":null,\"boundary_min\":45,\"max\":90"), data.npos) << data;
  EXPECT_EQ(data.find("intersection"), data.npos);
  HtmlReport report = report_of(mesh);
  report.methods[0].levels[0].statistics = {};
  EXPECT_EQ(report_data(report).find("le_10"), data.npos) << "no angles, no counts of them";
}

TEST(ReportHtml, IsOnePageThatLoadsNothing) {
  const TriangleMesh mesh = unit_square();
  const std::string html = report_html(report_of(mesh));
  EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(count_of(html, "</html>"), 1u);
  EXPECT_FALSE(std::regex_search(html, std::regex("(src|href)=[\"'](?!#)"))) << "loads a file";
  EXPECT_FALSE(std::regex_search(html, std::regex("@import|url\\(|fetch\\(|XMLHttpRequest")));
  EXPECT_FALSE(std::regex_search(html, std::regex("@(TITLE|STYLE|DATA|SCRIPT)@")));
}

TEST(ReportHtml, TextsOfTheUserCannotBreakThePage) {
  const TriangleMesh mesh = unit_square();
  HtmlReport report = report_of(mesh);
  report.title = "</title><script>alert(1)</script>@DATA@";
  report.parameters = {{"file", "</script><!--"}};
  const std::string html = report_html(report);
  EXPECT_EQ(count_of(html, "<script>alert"), 0u);
  EXPECT_EQ(count_of(html, "</script>"), count_of(report_html(report_of(mesh)), "</script>"));
  EXPECT_EQ(count_of(html, "<!--"), 0u);
}

TEST(ReportHtml, OfSixteenThousandNodesByBothMethodsStaysUnder3Megabytes) {
  const TriangleMesh mesh = generate_graded_mesh(GradedDomain::kAirfoil, {.nodes = 16'000}).value();
  CoarseningOptions options;
  const Hierarchy by_function = coarsen(mesh, options).value();
  options.method = CoarseningMethod::kMis;
  const Hierarchy by_mis = coarsen(mesh, options).value();
  const HtmlReport report{
      .title = "wing",
      .parameters = {},
      .methods = {method_of("function", by_function), method_of("mis", by_mis)}};
  const std::string html = report_html(report);
  EXPECT_LT(html.size(), 3'000'000u);
  EXPECT_EQ(html, report_html(report)) << "the same report gives the same bytes";
}

}  // namespace
}  // namespace wellspaced
