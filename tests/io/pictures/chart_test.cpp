#include "wellspaced/io/pictures/chart.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

namespace wellspaced {
namespace {

std::string chart_svg(const Chart& chart) {
  TextWriter out;
  write_chart_svg(out, chart);
  return out.text();
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

Chart one_line(std::vector<Point2> points) {
  return {
      .x = {"level"}, .y = {"nodes"}, .series = {{.name = "ours", .points = std::move(points)}}};
}

std::string label(const std::string& text) { return ">" + text + "</text>"; }

TEST(Chart, NamesItsAxesTicksAndLines) {
  const std::string svg = chart_svg(one_line({{0, 12'000}, {1, 700}, {2, 30}}));
  for (const char* text : {"level", "nodes", "ours", "0", "2,000", "12,000", "2"})
    EXPECT_NE(svg.find(label(text)), svg.npos) << text << '\n' << svg;
}

TEST(Chart, DrawsAMarkAtEachPointAndInTheLegend) {
  const std::string svg = chart_svg(one_line({{0, 1}, {1, 2}, {3, 4}}));
  EXPECT_EQ(count_of(svg, "a3.6 3.6 0 1 0 7.2 0"), 4u) << svg;
}

TEST(Chart, PutsPointsWhereTheTicksSay) {
  const std::string svg = chart_svg(one_line({{0, 0}, {10, 5}, {20, 10}}));
  // The middle of the line is the middle of its ends.
  std::smatch line;
  const std::regex path("d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\"");
  ASSERT_TRUE(std::regex_search(svg, line, path)) << svg;
  EXPECT_NEAR(2 * std::stod(line[3]), std::stod(line[1]) + std::stod(line[5]), 0.2);
  EXPECT_NEAR(2 * std::stod(line[4]), std::stod(line[2]) + std::stod(line[6]), 0.2);
  EXPECT_LT(std::stod(line[6]), std::stod(line[2]));  // up
}

TEST(Chart, ALogarithmicAxisHasATickADecade) {
  Chart chart = one_line({{0, 1e6}, {1, 20}});
  chart.y.logarithmic = true;
  const std::string svg = chart_svg(chart);
  for (const char* text : {"10", "100", "1,000", "10,000", "100,000", "1,000,000"})
    EXPECT_NE(svg.find(label(text)), svg.npos) << text;
  EXPECT_EQ(svg.find(label("10,000,000")), svg.npos);
}

TEST(Chart, LeavesOutWhatCannotStand) {
  Chart chart = one_line({{0, 5}, {1, std::numeric_limits<double>::quiet_NaN()}, {2, 0}, {3, 7}});
  chart.y.logarithmic = true;
  const std::string svg = chart_svg(chart);
  EXPECT_EQ(count_of(svg, "a3.6 3.6 0 1 0 7.2 0"), 3u);
  EXPECT_EQ(svg.find("nan"), svg.npos);
}

TEST(Chart, IsDrawnWithoutPointsAndOfOne) {
  for (const auto& points : {std::vector<Point2>{},
                             {{3, 3}},
                             {{0, 0}, {0, 0}},
                             {{-4, -2}, {5, 1e-9}},
                             {{1e300, 1e300}, {2e300, 5e-300}}}) {
    Chart chart = one_line(points);
    EXPECT_NE(chart_svg(chart).find("</svg>"), std::string::npos);
    EXPECT_EQ(chart_svg(chart).find("nan"), std::string::npos);
    chart.x.logarithmic = chart.y.logarithmic = true;
    EXPECT_EQ(chart_svg(chart).find("nan"), std::string::npos);
  }
}

TEST(Chart, TicksHaveFewDigits) {
  const std::string svg = chart_svg(one_line({{0, 0}, {0.7, 0.3}}));
  EXPECT_NE(svg.find(label("0.1")), svg.npos) << svg;
  EXPECT_EQ(svg.find("0.30000"), svg.npos);
}

}  // namespace
}  // namespace wellspaced
