#include "wellspaced/io/reproduce/run_files.hpp"

#include <array>
#include <string_view>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/json/json_reader.hpp"
#include "wellspaced/io/json/json_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

using Figure = std::optional<double>;

constexpr std::array<std::string_view, 17> kFigureNames = {
    "nodes",           "triangles",    "boundary_edges",   "interior_min",
    "boundary_min",    "max",          "interior_le_10",   "boundary_le_10",
    "gradation",       "intersection", "intersection_max", "path_depth",
    "path_depth_max",  "search",       "search_max",       "edge_search",
    "edge_search_max",
};
using Figures = std::array<Figure, kFigureNames.size()>;

Figure mean_figure(const std::optional<MeanAndMax>& value) {
  return value ? Figure(value->mean) : Figure();
}
Figure max_figure(const std::optional<MeanAndMax>& value) {
  return value ? Figure(static_cast<double>(value->max)) : Figure();
}

Figures figures_of(const LevelStatistics& s) {
  const auto count = [](std::size_t n) { return static_cast<double>(n); };
  return {count(s.nodes),
          count(s.triangles),
          count(s.boundary_edges),
          s.angles.interior_min_deg,
          s.angles.boundary_min_deg,
          s.angles.max_deg,
          count(s.angles.interior_le_10),
          count(s.angles.boundary_le_10),
          s.gradation,
          mean_figure(s.intersection),
          max_figure(s.intersection),
          mean_figure(s.path_depth),
          max_figure(s.path_depth),
          mean_figure(s.search),
          max_figure(s.search),
          mean_figure(s.edge_search),
          max_figure(s.edge_search)};
}

// A count as it was written; damaged files may hold anything.
std::size_t count_of(const Figure& figure) {
  return figure && *figure >= 0 && *figure < 0x1p53 ? static_cast<std::size_t>(*figure) : 0;
}

std::optional<MeanAndMax> mean_and_max(const Figure& mean, const Figure& max) {
  if (!mean || !max) return std::nullopt;
  return MeanAndMax{*mean, count_of(max)};
}

LevelStatistics statistics_of(const Figures& f) {
  LevelStatistics s;
  s.nodes = count_of(f[0]);
  s.triangles = count_of(f[1]);
  s.boundary_edges = count_of(f[2]);
  s.angles = {f[3], f[4], f[5], count_of(f[6]), count_of(f[7])};
  s.gradation = f[8];
  s.intersection = mean_and_max(f[9], f[10]);
  s.path_depth = mean_and_max(f[11], f[12]);
  s.search = mean_and_max(f[13], f[14]);
  s.edge_search = mean_and_max(f[15], f[16]);
  return s;
}

void write_figures(JsonWriter& json, const LevelStatistics& statistics) {
  json.begin_array();
  for (const Figure& figure : figures_of(statistics)) {
    if (figure)
      json.value(*figure);
    else
      json.null();
  }
  json.end_array();
}

std::optional<LevelStatistics> read_figures(const JsonValue& level) {
  if (level.items.size() != kFigureNames.size()) return std::nullopt;
  Figures figures;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (level.items[i].kind == JsonValue::Kind::kNumber) figures[i] = level.items[i].number;
  return statistics_of(figures);
}

std::optional<RunStatistics> read_run(const JsonValue& run) {
  RunStatistics levels;
  for (const JsonValue& level : run.items) {
    const auto statistics = read_figures(level);
    if (!statistics) return std::nullopt;
    levels.push_back(*statistics);
  }
  return levels;
}

}  // namespace

std::string runs_json(const std::string& parameters, std::span<const RunStatistics> runs) {
  JsonWriter json;
  json.begin_object().field("parameters", parameters).key("figures").begin_array();
  for (const std::string_view name : kFigureNames) json.value(name);
  json.end_array().key("runs").begin_array();
  for (const RunStatistics& run : runs) {
    json.begin_array();
    for (const LevelStatistics& level : run) write_figures(json, level);
    json.end_array();
  }
  json.end_array().end_object();
  return concat({json.text(), '\n'});
}

std::optional<std::vector<RunStatistics>> read_runs(const std::string& path,
                                                    const std::string& parameters) {
  if (!file_exists(path)) return std::nullopt;
  const auto text = read_input(path);
  if (!text) return std::nullopt;
  const auto json = parse_json(*text, path);
  if (!json) return std::nullopt;
  const JsonValue *made_with = json->find("parameters"), *list = json->find("runs");
  if (made_with == nullptr || made_with->text != parameters || list == nullptr) return std::nullopt;
  std::vector<RunStatistics> runs;
  for (const JsonValue& item : list->items) {
    auto run = read_run(item);
    if (!run) return std::nullopt;
    runs.push_back(std::move(*run));
  }
  return runs;
}

}  // namespace wellspaced
