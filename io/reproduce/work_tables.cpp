#include "wellspaced/io/reproduce/work_tables.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/io/pictures/chart.hpp"
#include "wellspaced/io/reproduce/published.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

using WorkFigure = std::optional<MeanAndMax> LevelStatistics::*;

struct WorkTable {
  std::string_view name, title;
  WorkFigure figure;
  std::span<const PublishedWork> (*published)();
};

constexpr WorkTable kWorkTables[] = {
    {"section-8.4.1", "8.4.1: depth of the shortest-distance spanning tree",
     &LevelStatistics::path_depth, published_path_depth},
    {"section-8.4.2", "8.4.2: nodes inspected in a search from a node", &LevelStatistics::search,
     published_node_search},
    {"section-8.4.3", "8.4.3: nodes inspected by a boundary node to protect its edges",
     &LevelStatistics::edge_search, published_edge_search},
};

struct WorkMesh {
  std::string_view name, title;
};
constexpr WorkMesh kWorkMeshes[] = {{"crack", "CRACK"},
                                    {"airfoil1", "AIRFOIL 1"},
                                    {"airfoil2", "AIRFOIL 2"},
                                    {"airfoil3", "AIRFOIL 3"}};
constexpr int kWorkFactors[] = {4, 8};

// A pair of columns: the runs on a mesh with a factor; none where the mesh is lost.
struct WorkColumns {
  std::string group;
  std::span<const RunStatistics> runs;
  bool comparable = false;
};

Experiment work_experiment(std::string_view mesh, int factor) {
  Experiment experiment{.name = concat({"work-", mesh, "-C", factor}), .mesh = std::string(mesh)};
  experiment.options.factor = factor;
  experiment.options.count_work = true;
  experiment.thesis_runs = 10;
  return experiment;
}

Result<std::vector<WorkColumns>> work_columns(Laboratory& laboratory) {
  std::vector<WorkColumns> columns;
  for (const WorkMesh& mesh : kWorkMeshes)
    for (const int factor : kWorkFactors) {
      columns.push_back({concat({mesh.title, ", C = ", factor}), {}});
      if (mesh.name == "airfoil2") continue;
      const auto runs = laboratory.runs(work_experiment(mesh.name, factor));
      if (!runs) return runs.error();
      columns.back().runs = *runs;
      columns.back().comparable = laboratory.mesh(std::string(mesh.name)).value()->is_original;
    }
  return columns;
}

// The thesis prints the largest of the runs: of their maxima, and of their averages.
ExhibitCell largest_cell(std::span<const RunStatistics> runs, std::size_t level,
                         const LevelFigure& figure) {
  const auto summary = summarise_level(runs, level, figure);
  if (!summary) return {};
  return {summary->high, {}, summary->low, summary->high};
}

std::optional<double> printed(double figure) {
  return figure == kNotPrinted ? std::nullopt : std::optional(figure);
}

ExhibitRow work_row(const WorkTable& source, std::span<const WorkColumns> columns,
                    std::size_t level) {
  const auto published = source.published();
  ExhibitRow row{std::to_string(level), {}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto largest = [&](const LevelStatistics& s) -> std::optional<double> {
      if (!(s.*source.figure)) return std::nullopt;
      return static_cast<double>((s.*source.figure)->max);
    };
    const auto average = [&](const LevelStatistics& s) -> std::optional<double> {
      if (!(s.*source.figure)) return std::nullopt;
      return (s.*source.figure)->mean;
    };
    row.cells.push_back(largest_cell(columns[i].runs, level, largest));
    row.cells.push_back(largest_cell(columns[i].runs, level, average));
    if (level >= published.size()) continue;
    for (std::size_t k = 0; k < 2; ++k)
      row.cells[2 * i + k].published = printed(published[level][2 * i + k]);
  }
  return row;
}

bool has_ours(const ExhibitRow& row) {
  return std::ranges::any_of(row.cells,
                             [](const ExhibitCell& cell) { return cell.ours.has_value(); });
}

ExhibitTable work_table(const WorkTable& source, std::span<const WorkColumns> columns) {
  ExhibitTable table{.name = std::string(source.name), .title = std::string(source.title)};
  for (const WorkColumns& pair : columns)
    for (const char* figure : {"max", "avg"}) {
      const auto rule = pair.comparable ? CellRule::kWithinRuns : CellRule::kNever;
      table.columns.push_back({pair.group, figure, 0, rule});
    }
  for (std::size_t level = 0;; ++level) {
    ExhibitRow row = work_row(source, columns, level);
    if (level >= source.published().size() && !has_ours(row)) break;
    table.rows.push_back(std::move(row));
  }
  return table;
}

// A line of a chart: the averages of ours, or of the thesis, in a column.
ChartSeries average_line(const ExhibitTable& table, std::size_t column, CellFigure whose,
                         unsigned style) {
  const bool published = whose == &ExhibitCell::published;
  ChartSeries line{
      concat({table.columns[column].group, published ? ", thesis" : ""}), {}, style, published};
  for (std::size_t level = 0; level < table.rows.size(); ++level)
    if (const auto value = table.rows[level].cells[column].*whose)
      line.points.push_back({static_cast<double>(level), *value});
  return line;
}

// The averages for the larger factor, level by level.
ExhibitPicture average_picture(const ExhibitTable& table) {
  Chart chart{.x = {"level"}, .y = {"average"}};
  constexpr std::size_t kColumnsOfMesh = 4, kAverage = 3;
  for (unsigned mesh = 0; mesh < std::size(kWorkMeshes); ++mesh)
    for (const CellFigure whose : {&ExhibitCell::ours, &ExhibitCell::published})
      chart.series.push_back(average_line(table, mesh * kColumnsOfMesh + kAverage, whose, mesh));
  std::erase_if(chart.series, [](const ChartSeries& line) { return line.points.empty(); });
  TextWriter out;
  write_chart_svg(out, chart);
  return {table.name, concat({table.title, ", averages"}), out.text()};
}

}  // namespace

Result<Exhibit> work_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  const auto columns = work_columns(laboratory);
  if (!columns) return columns.error();
  for (const WorkTable& source : kWorkTables) {
    exhibit.tables.push_back(work_table(source, *columns));
    exhibit.pictures.push_back(average_picture(exhibit.tables.back()));
  }
  exhibit.notes.push_back(concat(
      {"Largest figures of ", laboratory.runs_text(work_experiment("crack", 4)),
       ", as in the thesis, which cuts averages to whole numbers. The coordinates of AIRFOIL 2 "
       "are lost."}));
  return exhibit;
}

}  // namespace wellspaced
