#include "wellspaced/io/report/report_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/io/text/base64.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/point_order.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

void append_unsigned(std::string& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7) bytes.push_back(static_cast<char>(value | 128));
  bytes.push_back(static_cast<char>(value));
}

void append_signed(std::string& bytes, std::int64_t value) {
  const auto doubled = static_cast<std::uint64_t>(value) << 1;
  append_unsigned(bytes, value < 0 ? ~doubled : doubled);
}

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<char>(value >> (8 * k)));
}

Index origin_of(const ReportLevel& level, Index node) {
  return level.origin.empty() ? node : level.origin[node];
}

bool is_drawn(const ReportLevel& level, const HtmlReport& report) {
  return level.mesh->points.size() <= report.max_drawn_nodes;
}

template <class Visit>
void for_each_drawn_level(const HtmlReport& report, Visit visit) {
  for (const ReportMethod& method : report.methods)
    for (const ReportLevel& level : method.levels)
      if (is_drawn(level, report)) visit(level);
}

// The points of the drawn levels. number_of: by number in the input mesh; kNoIndex if not drawn.
struct DrawnPoints {
  std::vector<Point2> points;
  std::vector<Index> number_of;
};

DrawnPoints collect_points(const HtmlReport& report) {
  DrawnPoints drawn;
  for_each_drawn_level(report, [&](const ReportLevel& level) {
    for (Index node = 0; node < level.mesh->points.size(); ++node) {
      const Index origin = origin_of(level, node);
      if (origin >= drawn.number_of.size())
        drawn.number_of.resize(origin + std::size_t{1}, kNoIndex);
      if (drawn.number_of[origin] != kNoIndex) continue;
      drawn.number_of[origin] = static_cast<Index>(drawn.points.size());
      drawn.points.push_back(level.mesh->points[node]);
    }
  });
  return drawn;
}

void renumber_along_curve(DrawnPoints& drawn) {
  const std::vector<Index> order = hilbert_order(drawn.points);
  std::vector<Index> place(order.size());
  std::vector<Point2> points(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    points[i] = drawn.points[order[i]];
  }
  for (Index& number : drawn.number_of)
    if (number != kNoIndex) number = place[number];
  drawn.points = std::move(points);
}

struct Box {
  Point2 low, high;
};

Box bounding_box(std::span<const Point2> points) {
  if (points.empty()) return {};
  Box box{points[0], points[0]};
  for (const Point2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

constexpr double kMostSteps = 4294967295.0;

// A box that is flat, or larger than a double can say, has no step; its points then coincide.
std::uint32_t steps_from(double low, double value, double step) {
  if (!(step > 0) || !std::isfinite(step)) return 0;
  return static_cast<std::uint32_t>(std::min(kMostSteps, std::floor((value - low) / step + 0.5)));
}

void write_points(JsonWriter& json, std::span<const Point2> points) {
  const Box box = bounding_box(points);
  const double step = std::max(box.high.x - box.low.x, box.high.y - box.low.y) / kMostSteps;
  std::string bytes;
  for (const Point2 p : points) {
    append_u32(bytes, steps_from(box.low.x, p.x, step));
    append_u32(bytes, steps_from(box.low.y, p.y, step));
  }
  json.begin_object().field("count", points.size()).field("step", step);
  json.key("origin").begin_array().value(box.low.x).value(box.low.y).end_array();
  json.field("xy", base64(bytes)).end_object();
}

// The numbers of a level's nodes, ascending, and for each node its rank among them.
struct Ranks {
  std::vector<Index> numbers, rank_of;
};

Ranks rank_nodes(const ReportLevel& level, const DrawnPoints& drawn) {
  const std::size_t count = level.mesh->points.size();
  Ranks ranks{std::vector<Index>(count), std::vector<Index>(count)};
  for (Index node = 0; node < count; ++node)
    ranks.numbers[node] = drawn.number_of[origin_of(level, node)];
  const std::vector<Index> number_of_node = ranks.numbers;
  sort(ranks.numbers);
  for (Index node = 0; node < count; ++node)
    ranks.rank_of[node] = static_cast<Index>(
        std::lower_bound(ranks.numbers.begin(), ranks.numbers.end(), number_of_node[node]) -
        ranks.numbers.begin());
  return ranks;
}

std::string encode_nodes(std::span<const Index> numbers) {
  std::string bytes;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    append_unsigned(bytes, i == 0 ? numbers[0] : numbers[i] - numbers[i - 1] - 1);
  return bytes;
}

std::string encode_triangles(const TriangleMesh& mesh, const Ranks& ranks) {
  std::vector<std::array<Index, 3>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    std::array<Index, 3> triangle{ranks.rank_of[a], ranks.rank_of[b], ranks.rank_of[c]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    sorted.push_back(triangle);
  }
  sort(sorted);
  std::string bytes;
  Index last = 0;
  for (const auto& [a, b, c] : sorted) {
    append_unsigned(bytes, a - last);
    append_unsigned(bytes, b - a);
    append_signed(bytes, std::int64_t{c} - b);
    last = a;
  }
  return bytes;
}

std::string encode_segments(const TriangleMesh& mesh, const Ranks& ranks) {
  std::string bytes;
  std::int64_t last = 0;
  for (const Segment& segment : mesh.segments) {
    const std::int64_t a = ranks.rank_of[segment.a], b = ranks.rank_of[segment.b];
    append_signed(bytes, a - last);
    append_signed(bytes, b - a);
    last = a;
  }
  return bytes;
}

void write_list(JsonWriter& json, std::string_view name, std::size_t count,
                std::string_view bytes) {
  json.key(name).begin_object().field("count", count).field("data", base64(bytes)).end_object();
}

std::string geometry_json(const ReportLevel& level, const DrawnPoints& drawn) {
  const Ranks ranks = rank_nodes(level, drawn);
  const TriangleMesh& mesh = *level.mesh;
  JsonWriter json;
  json.begin_object();
  write_list(json, "nodes", ranks.numbers.size(), encode_nodes(ranks.numbers));
  write_list(json, "triangles", mesh.triangles.size(), encode_triangles(mesh, ranks));
  write_list(json, "segments", mesh.segments.size(), encode_segments(mesh, ranks));
  json.end_object();
  return json.text();
}

// The number of the geometry in `geometries`, where it is added unless it is there.
std::size_t add_geometry(std::vector<std::string>& geometries, std::string geometry) {
  const auto found = std::find(geometries.begin(), geometries.end(), geometry);
  const auto number = static_cast<std::size_t>(found - geometries.begin());
  if (found == geometries.end()) geometries.push_back(std::move(geometry));
  return number;
}

void write_optional(JsonWriter& json, std::string_view name, const std::optional<double>& value) {
  json.key(name);
  if (value)
    json.value(*value);
  else
    json.null();
}

void write_mean_and_max(JsonWriter& json, const std::string& name,
                        const std::optional<MeanAndMax>& value) {
  if (!value) return;
  json.field(concat({name, "_mean"}), value->mean).field(concat({name, "_max"}), value->max);
}

void write_statistics(JsonWriter& json, const LevelStatistics& s) {
  json.begin_object().field("nodes", s.nodes).field("triangles", s.triangles);
  json.field("boundary_edges", s.boundary_edges);
  write_optional(json, "interior_min", s.angles.interior_min_deg);
  write_optional(json, "boundary_min", s.angles.boundary_min_deg);
  write_optional(json, "max", s.angles.max_deg);
  if (s.angles.max_deg) {
    json.field("interior_le_10", s.angles.interior_le_10);
    json.field("boundary_le_10", s.angles.boundary_le_10);
  }
  write_optional(json, "gradation", s.gradation);
  write_mean_and_max(json, "intersection", s.intersection);
  write_mean_and_max(json, "path_depth", s.path_depth);
  write_mean_and_max(json, "search", s.search);
  write_mean_and_max(json, "edge_search", s.edge_search);
  json.end_object();
}

void write_parameters(JsonWriter& json, const ReportParameters& parameters) {
  json.key("parameters").begin_array();
  for (const auto& [name, value] : parameters)
    json.begin_array().value(name).value(value).end_array();
  json.end_array();
}

void write_methods(JsonWriter& json, const HtmlReport& report, const DrawnPoints& drawn,
                   std::vector<std::string>& geometries) {
  json.key("methods").begin_array();
  for (const ReportMethod& method : report.methods) {
    json.begin_object().field("method", method.method);
    write_parameters(json, method.parameters);
    json.key("levels").begin_array();
    for (const ReportLevel& level : method.levels) {
      json.begin_object().key("geometry");
      if (is_drawn(level, report))
        json.value(add_geometry(geometries, geometry_json(level, drawn)));
      else
        json.null();
      json.key("statistics");
      write_statistics(json, level.statistics);
      json.end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
}

// Within a script element "</script" would end it, and "<!--" would change its meaning.
std::string without_markup(const std::string& json) {
  std::string result;
  for (const char c : json) c == '<' ? result += "\\u003c" : result += c;
  return result;
}

}  // namespace

std::string report_data(const HtmlReport& report) {
  DrawnPoints drawn = collect_points(report);
  renumber_along_curve(drawn);
  std::vector<std::string> geometries;
  JsonWriter json;
  json.begin_object();
  write_parameters(json, report.parameters);
  write_methods(json, report, drawn, geometries);
  json.key("points");
  write_points(json, drawn.points);
  json.key("geometries").begin_array();
  for (const std::string& geometry : geometries) json.raw(geometry);
  json.end_array().end_object();
  return without_markup(json.text());
}

}  // namespace wellspaced
