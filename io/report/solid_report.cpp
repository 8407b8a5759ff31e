#include "wellspaced/io/report/solid_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/io/report/report_page.hpp"
#include "wellspaced/io/report/report_templates.hpp"
#include "wellspaced/io/text/base64.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/markup.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

using Steps = std::array<std::uint32_t, 3>;

// The coordinates as multiples of a step from the lowest corner of the box; halved on the way, for
// the extent may be beyond the doubles.
std::vector<Steps> steps_of(const std::vector<Point3>& points) {
  constexpr double kMost = 4294967295.0;
  const auto half = [](Point3 p) { return std::array{p.x / 2, p.y / 2, p.z / 2}; };
  if (points.empty()) return {};
  std::array<double, 3> low = half(points[0]), high = low;
  for (const Point3 p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], half(p)[k]);
      high[k] = std::max(high[k], half(p)[k]);
    }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::vector<Steps> steps;
  for (const Point3 p : points) {
    Steps& one = steps.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      if (extent > 0)
        one[k] = static_cast<std::uint32_t>(
            std::min(kMost, std::floor((half(p)[k] - low[k]) / extent * kMost + 0.5)));
  }
  return steps;
}

void write_solid_points(JsonWriter& json, const std::vector<Steps>& points) {
  Steps size{};
  std::string bytes;
  for (const Steps& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      size[k] = std::max(size[k], p[k]);
      append_bytes(bytes, p[k]);
    }
  json.key("points").begin_object().key("size").begin_array();
  for (const std::uint32_t length : size) json.value(length);
  json.end_array().field("xyz", base64(bytes)).end_object();
}

// Six times the volume, in steps.
double volume_in_steps(const std::vector<Steps>& points, const std::array<Index, 4>& tet) {
  std::array<std::array<double, 3>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      edge[i][k] = static_cast<double>(points[tet[i + 1]][k]) - points[tet[0]][k];
  const auto& [u, v, w] = edge;
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// The tets, positive.
void write_solid_tets(JsonWriter& json, const TetMesh& mesh, const std::vector<Steps>& points) {
  std::string bytes;
  std::size_t count = 0;
  for (std::array<Index, 4> tet : mesh.tets) {
    const double volume = volume_in_steps(points, tet);
    if (volume == 0) continue;
    if (volume < 0) std::swap(tet[2], tet[3]);
    for (const Index v : tet) append_bytes(bytes, v);
    ++count;
  }
  json.key("tets").begin_object().field("count", count).field("data", base64(bytes)).end_object();
}

std::string solid_data(const SolidReport& report) {
  JsonWriter json;
  json.begin_object().field("count", report.mesh->tets.size());
  if (report.mesh->tets.size() <= report.max_drawn_tets) {
    const std::vector<Steps> points = steps_of(report.mesh->points);
    write_solid_points(json, points);
    write_solid_tets(json, *report.mesh, points);
  }
  json.end_object();
  return json.text();
}

std::string parameter_list(const ReportParameters& parameters) {
  std::string list = "<dl>\n";
  for (const auto& [name, value] : parameters)
    append(list, {"<dt>", escape_markup(name), "</dt><dd>", escape_markup(value), "</dd>\n"});
  return concat({list, "</dl>"});
}

}  // namespace

std::string solid_report_html(const SolidReport& report) {
  return fill_page(kSolidHtml, [&](std::string_view word) {
    if (word == "TITLE") return escape_markup(report.title);
    if (word == "STYLE") return std::string(kReportCss);
    if (word == "SCRIPT") return std::string(kSolidScript);
    if (word == "PARAMETERS") return parameter_list(report.parameters);
    return solid_data(report);
  });
}

}  // namespace wellspaced
