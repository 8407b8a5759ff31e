#include "wellspaced/io/pictures/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "wellspaced/io/report/table_text.hpp"
#include "wellspaced/io/text/markup.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

constexpr double kChartWidth = 480, kPlotLeft = 82, kPlotRight = 446, kPlotTop = 12,
                 kPlotBottom = 262, kLegendTop = 318, kLegendLine = 19;
constexpr std::size_t kLegendColumns = 2;

// The Okabe-Ito palette, which people with any colour vision can tell apart.
constexpr std::array<std::string_view, 8> kChartColors = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b58900", "#56b4e9", "#000000", "#777777"};

// Marks of radius 3.6 about the origin, in their order.
constexpr std::array<std::string_view, 4> kMarkPaths = {
    "m-3.6 0a3.6 3.6 0 1 0 7.2 0a3.6 3.6 0 1 0-7.2 0z", "m-3.2-3.2h6.4v6.4h-6.4z",
    "m0-4.2l3.8 6.9h-7.6z", "m0-4.4l4.4 4.4l-4.4 4.4l-4.4-4.4z"};

// An axis on the paper: from value low at pixel `from` to value high at pixel `to`.
struct ChartScale {
  bool logarithmic = false;
  double low = 0, high = 1, from = 0, to = 1;
  std::vector<double> ticks = {};

  double coordinate(double value) const { return logarithmic ? binary_logarithm(value) : value; }
  double at(double value) const {
    const double start = coordinate(low), end = coordinate(high);
    return from + (to - from) * (coordinate(value) - start) / (end - start);
  }
};

bool can_stand(double value, const ChartAxis& axis) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0);
}

bool can_stand(Point2 p, const Chart& chart) {
  return can_stand(p.x, chart.x) && can_stand(p.y, chart.y);
}

std::vector<double> values_of(const Chart& chart, double Point2::*axis) {
  std::vector<double> values;
  for (const ChartSeries& series : chart.series)
    for (const Point2& p : series.points)
      if (can_stand(p, chart)) values.push_back(p.*axis);
  return values;
}

// 1, 2 or 5 times a power of ten: the least that cuts the range into at most eight parts.
double tick_step(double range) {
  constexpr double kMostParts = 8;
  double step = 1;
  while (step * kMostParts > range && step > 1e-300) step /= 10;
  while (step * kMostParts < range && step < 1e300) {
    if (2 * step * kMostParts >= range) return 2 * step;
    if (5 * step * kMostParts >= range) return 5 * step;
    step *= 10;
  }
  return step;
}

ChartScale linear_scale(double low, double high) {
  ChartScale scale{.low = std::fmin(0, low), .high = high};
  if (!(scale.high > scale.low)) scale.high = scale.low + 1;
  const double step = tick_step(scale.high - scale.low);
  scale.low = step * std::floor(scale.low / step);
  scale.high = step * std::ceil(scale.high / step);
  const auto parts = static_cast<int>((scale.high - scale.low) / step + 0.5);
  for (int i = 0; i <= parts; ++i) scale.ticks.push_back(scale.low + i * step);
  return scale;
}

ChartScale decades_scale(double low, double high) {
  ChartScale scale{.logarithmic = true, .low = 1, .high = 1};
  while (scale.low > low && scale.low > 1e-300) scale.low /= 10;
  while (scale.low * 10 <= low) scale.low *= 10;
  scale.high = scale.low * 10;
  while (scale.high < high && scale.high < 1e300) scale.high *= 10;
  for (double tick = scale.low; tick <= scale.high * 1.5; tick *= 10) scale.ticks.push_back(tick);
  return scale;
}

ChartScale scale_of(const Chart& chart, const ChartAxis& axis, double Point2::*coordinate,
                    double from, double to) {
  const std::vector<double> values = values_of(chart, coordinate);
  const double low = values.empty() ? 1 : *std::ranges::min_element(values);
  const double high = values.empty() ? 1 : *std::ranges::max_element(values);
  ChartScale scale = axis.logarithmic ? decades_scale(low, high) : linear_scale(low, high);
  scale.from = from;
  scale.to = to;
  return scale;
}

std::string pixels(double value) { return decimal(value, 1); }

std::string with_commas(std::string digits) {
  for (std::size_t at = digits.size(); at > 3 && digits[at - 4] != '-'; at -= 3)
    digits.insert(at - 3, 1, ',');
  return digits;
}

// Ticks are sums of rounded steps: as few digits as tell them apart.
std::string tick_name(double value) {
  constexpr int kMostDigits = 6;
  double scaled = value;
  for (int digits = 0; digits <= kMostDigits; ++digits, scaled *= 10)
    if (std::fabs(scaled - std::floor(scaled + 0.5)) < 1e-6 && std::fabs(scaled) < 1e15)
      return digits == 0 ? with_commas(decimal(value, 0)) : decimal(value, digits);
  return shortest(value);
}

void write_label(TextWriter& out, double x, double y, std::string_view anchor,
                 std::string_view text) {
  out << "<text x=\"" << pixels(x) << "\" y=\"" << pixels(y) << "\" text-anchor=\"" << anchor
      << "\">" << escape_markup(text) << "</text>\n";
}

void write_line(TextWriter& out, Point2 a, Point2 b) {
  out << "<path d=\"M" << pixels(a.x) << ' ' << pixels(a.y) << 'L' << pixels(b.x) << ' '
      << pixels(b.y) << "\" stroke=\"#d9d7d0\"/>\n";
}

void write_axes(TextWriter& out, const Chart& chart, const ChartScale& x, const ChartScale& y) {
  for (const double tick : y.ticks) {
    write_line(out, {kPlotLeft, y.at(tick)}, {kPlotRight, y.at(tick)});
    write_label(out, kPlotLeft - 6, y.at(tick) + 4, "end", tick_name(tick));
  }
  for (const double tick : x.ticks) {
    write_line(out, {x.at(tick), kPlotBottom}, {x.at(tick), kPlotBottom + 4});
    write_label(out, x.at(tick), kPlotBottom + 18, "middle", tick_name(tick));
  }
  write_label(out, (kPlotLeft + kPlotRight) / 2, kPlotBottom + 36, "middle", chart.x.name);
  out << "<text transform=\"translate(13 " << pixels((kPlotTop + kPlotBottom) / 2)
      << ") rotate(-90)\" text-anchor=\"middle\">" << escape_markup(chart.y.name) << "</text>\n";
}

void write_mark(TextWriter& out, Point2 at, const ChartSeries& series) {
  const std::string_view color = kChartColors[series.style % kChartColors.size()];
  out << "<path d=\"M" << pixels(at.x) << ' ' << pixels(at.y)
      << kMarkPaths[series.style % kMarkPaths.size()] << "\" fill=\""
      << (series.dashed ? "#fff" : color) << "\" stroke=\"" << color << "\"/>\n";
}

void write_stroke(TextWriter& out, std::span<const Point2> places, const ChartSeries& series) {
  if (places.size() < 2) return;
  out << "<path fill=\"none\" stroke-width=\"1.8\" stroke=\""
      << kChartColors[series.style % kChartColors.size()]
      << (series.dashed ? "\" stroke-dasharray=\"5 4\" d=\"" : "\" d=\"");
  for (std::size_t i = 0; i < places.size(); ++i)
    out << (i == 0 ? 'M' : 'L') << pixels(places[i].x) << ' ' << pixels(places[i].y);
  out << "\"/>\n";
}

void write_series(TextWriter& out, const ChartSeries& series, std::span<const Point2> places) {
  write_stroke(out, places, series);
  for (const Point2& place : places) write_mark(out, place, series);
}

void write_legend(TextWriter& out, const Chart& chart) {
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const double x = kPlotLeft + static_cast<double>(i % kLegendColumns) * 200;
    const double y = kLegendTop + static_cast<double>(i / kLegendColumns) * kLegendLine;
    const std::array<Point2, 2> sample = {Point2{x, y - 4}, Point2{x + 28, y - 4}};
    write_stroke(out, sample, chart.series[i]);
    write_mark(out, {x + 14, y - 4}, chart.series[i]);
    write_label(out, x + 36, y, "start", chart.series[i].name);
  }
}

}  // namespace

void write_chart_svg(TextWriter& out, const Chart& chart) {
  const ChartScale x = scale_of(chart, chart.x, &Point2::x, kPlotLeft, kPlotRight);
  const ChartScale y = scale_of(chart, chart.y, &Point2::y, kPlotBottom, kPlotTop);
  const std::size_t lines = (chart.series.size() + kLegendColumns - 1) / kLegendColumns;
  const std::string height = pixels(kLegendTop + static_cast<double>(lines) * kLegendLine - 6);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << pixels(kChartWidth)
      << "\" height=\"" << height << "\" viewBox=\"0 0 " << pixels(kChartWidth) << ' ' << height
      << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      << "<g font-family=\"sans-serif\" font-size=\"12\" fill=\"#1b1f24\">\n";
  write_axes(out, chart, x, y);
  for (const ChartSeries& series : chart.series) {
    std::vector<Point2> places;
    for (const Point2& p : series.points)
      if (can_stand(p, chart)) places.push_back({x.at(p.x), y.at(p.y)});
    write_series(out, series, places);
  }
  write_legend(out, chart);
  out << "</g>\n</svg>\n";
}

}  // namespace wellspaced
