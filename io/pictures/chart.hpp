// Line charts as SVG.
#pragma once

#include <string>
#include <vector>

#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A line through its points, each with a mark. style: which colour and mark; they repeat after 8.
/// dashed: for what is only compared with, its marks hollow.
struct ChartSeries {
  std::string name;
  std::vector<Point2> points = {};
  unsigned style = 0;
  bool dashed = false;
};

struct ChartAxis {
  std::string name;
  bool logarithmic = false;
};

struct Chart {
  ChartAxis x, y;
  std::vector<ChartSeries> series = {};
};

/// Draws the chart, a legend below it, 480 pixels wide. A linear axis begins at 0 unless there are
/// negative values. Points that are not finite, or not positive on a logarithmic axis, are left
/// out. The same chart gives the same bytes. Cost: linear.
[[gnu::cold]] void write_chart_svg(TextWriter& out, const Chart& chart);

}  // namespace wellspaced
