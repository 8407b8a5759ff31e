#include "wellspaced/io/reproduce/sequence_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "wellspaced/io/pictures/chart.hpp"
#include "wellspaced/io/pictures/svg.hpp"
#include "wellspaced/io/reproduce/level_tables.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// A sequence as the charts plot it: for each level its size and its smallest angle.
struct PlottedSequence {
  std::string name;  // of its line
  unsigned style = 0;
  bool published = false;
  std::vector<Point2> levels = {};  // (nodes, smallest angle); NaN where there is none
};

std::string chart_text(const Chart& chart) {
  TextWriter out;
  write_chart_svg(out, chart);
  return out.text();
}

ChartSeries series_of(const PlottedSequence& sequence) {
  return {.name = sequence.name, .style = sequence.style, .dashed = sequence.published};
}

enum class Plot { kSizes, kLogSizes, kAngles };

std::string size_chart(std::span<const PlottedSequence> sequences, Plot plot) {
  Chart chart{.x = {"level"}, .y = {"nodes", plot == Plot::kLogSizes}};
  for (const PlottedSequence& sequence : sequences) {
    ChartSeries series = series_of(sequence);
    for (std::size_t level = 0; level < sequence.levels.size(); ++level)
      series.points.push_back({static_cast<double>(level), sequence.levels[level].x});
    chart.series.push_back(std::move(series));
  }
  return chart_text(chart);
}

std::string angle_chart(std::span<const PlottedSequence> sequences) {
  Chart chart{.x = {"nodes", true}, .y = {"smallest angle, degrees"}};
  for (const PlottedSequence& sequence : sequences) {
    ChartSeries series = series_of(sequence);
    series.points = sequence.levels;
    chart.series.push_back(std::move(series));
  }
  return chart_text(chart);
}

// ---- Figures 8.6 to 8.9: what Tables 8.3 to 8.8 hold

struct PlottedMesh {
  std::string_view name, title;
};
constexpr PlottedMesh kPlottedGrids[] = {
    {"grid1", "GRID(1)"}, {"grid10", "GRID(10)"}, {"grid20", "GRID(20)"}};
constexpr PlottedMesh kPlottedMeshes[] = {{"crack", "CRACK"},
                                          {"airfoil1", "AIRFOIL 1"},
                                          {"airfoil2", "AIRFOIL 2"},
                                          {"airfoil3", "AIRFOIL 3"}};

double or_nan(const std::optional<double>& value) { return value.value_or(std::nan("")); }

// Of a table by level_table: nodes in column 0, smallest angles in columns 1 and 3.
PlottedSequence plotted(const ExhibitTable& table, CellFigure whose, const std::string& name,
                        unsigned style) {
  PlottedSequence sequence{concat({name, whose == &ExhibitCell::ours ? "" : ", thesis"}), style,
                           whose == &ExhibitCell::published};
  for (const ExhibitRow& row : table.rows)
    sequence.levels.push_back(
        {or_nan(row.cells[0].*whose),
         std::fmin(or_nan(row.cells[1].*whose), or_nan(row.cells[3].*whose))});
  return sequence;
}

bool has_points(const PlottedSequence& sequence) {
  return std::ranges::any_of(sequence.levels, [](Point2 p) { return std::isfinite(p.x); });
}

constexpr std::array kPlottedMethods = {CoarseningMethod::kFunction, CoarseningMethod::kMis};
constexpr std::array kMethodLines = {"function-based", "MIS-based"};

// Ours and the thesis', by both methods, as far as there are any.
std::vector<PlottedSequence> plotted_lines(std::span<const ExhibitTable> halves) {
  std::vector<PlottedSequence> lines;
  for (unsigned i = 0; i < kMethodLines.size() && i < halves.size(); ++i)
    for (const CellFigure whose : {&ExhibitCell::ours, &ExhibitCell::published})
      if (auto line = plotted(halves[i], whose, kMethodLines[i], i); has_points(line))
        lines.push_back(std::move(line));
  return lines;
}

// The halves of a mesh's table, to be plotted in a figure.
Result<std::vector<ExhibitTable>> plotted_tables(Laboratory& laboratory, const std::string& figure,
                                                 const PlottedMesh& mesh) {
  std::vector<ExhibitTable> halves;
  for (std::size_t i = 0; i < kPlottedMethods.size(); ++i) {
    auto table = level_table(laboratory, concat({figure, "-", mesh.name}), std::string(mesh.name),
                             kPlottedMethods[i]);
    if (!table) return table.error();
    table->repeats = true;
    table->title = concat({mesh.title, ", ", kMethodLines[i]});
    halves.push_back(std::move(*table));
  }
  return halves;
}

ExhibitPicture plot_picture(const std::string& name, const std::string& title, Plot plot,
                            std::span<const PlottedSequence> lines) {
  if (plot == Plot::kAngles)
    return {concat({name, "-angles"}), concat({title, ": smallest angle by size of the level"}),
            angle_chart(lines)};
  return {concat({name, "-sizes"}), concat({title, ": nodes by level"}), size_chart(lines, plot)};
}

Result<Exhibit> plotted_exhibit(Laboratory& laboratory, Exhibit exhibit,
                                std::span<const PlottedMesh> meshes,
                                std::initializer_list<Plot> plots) {
  for (const PlottedMesh& mesh : meshes) {
    auto halves = plotted_tables(laboratory, exhibit.name, mesh);
    if (!halves) return halves.error();
    const std::vector<PlottedSequence> lines = plotted_lines(*halves);
    for (const Plot plot : plots)
      exhibit.pictures.push_back(plot_picture(concat({exhibit.name, "-", mesh.name}),
                                              std::string(mesh.title), plot, lines));
    std::ranges::move(*halves, std::back_inserter(exhibit.tables));
  }
  return exhibit;
}

// ---- Figure 8.5

constexpr std::size_t kSweepRuns = 5;
constexpr double kSweptFactors[] = {2, 3, 4, 5, 6, 8, 10};
constexpr double kSweptBetas[] = {5, 10, 15, 20, 25, 30, 50};

// A setting of C or beta and its line in the charts.
struct SweepSetting {
  std::string name, file;
  CoarseningOptions options = {};
};

std::vector<SweepSetting> factor_settings() {
  std::vector<SweepSetting> settings;
  for (const double factor : kSweptFactors) {
    settings.push_back({concat({"C = ", factor}), concat({"sweep-C", factor})});
    settings.back().options.factor = factor;
  }
  return settings;
}

std::vector<SweepSetting> beta_settings() {
  std::vector<SweepSetting> settings;
  for (const double beta : kSweptBetas) {
    settings.push_back({concat({"β = ", beta}), concat({"sweep-beta", beta})});
    settings.back().options.factor = 5;
    settings.back().options.beta = beta;
  }
  return settings;
}

SweepSetting mis_setting() {
  SweepSetting setting{"MIS", "sweep-mis"};
  setting.options.method = CoarseningMethod::kMis;
  return setting;
}

std::optional<double> smallest_of_level(const LevelStatistics& s) {
  const double angle =
      std::fmin(or_nan(s.angles.interior_min_deg), or_nan(s.angles.boundary_min_deg));
  return std::isnan(angle) ? std::nullopt : std::optional(angle);
}

std::optional<double> size_of_level(const LevelStatistics& s) {
  return static_cast<double>(s.nodes);
}

void add_cells(ExhibitTable& table, std::span<const RunStatistics> runs, std::size_t column) {
  for (std::size_t level = 0; summarise_level(runs, level, size_of_level); ++level) {
    if (level == table.rows.size()) table.rows.push_back({std::to_string(level), {}});
    ExhibitRow& row = table.rows[level];
    row.cells.resize(column);
    row.cells.push_back(mean_cell(summarise_level(runs, level, size_of_level)));
    row.cells.push_back(mean_cell(summarise_level(runs, level, smallest_of_level)));
  }
}

PlottedSequence plotted_column(const ExhibitTable& table, std::size_t column,
                               const std::string& name, unsigned style) {
  PlottedSequence sequence{name, style};
  for (const ExhibitRow& row : table.rows)
    if (column < row.cells.size() && row.cells[column].ours)
      sequence.levels.push_back({*row.cells[column].ours, or_nan(row.cells[column + 1].ours)});
  return sequence;
}

// Adds the table and the three charts of one swept parameter.
Status add_sweep(Laboratory& laboratory, Exhibit& exhibit, const std::string& parameter,
                 std::vector<SweepSetting> settings) {
  settings.push_back(mis_setting());
  ExhibitTable table{.name = concat({exhibit.name, "-", parameter}),
                     .title = "Means over the runs"};
  std::vector<PlottedSequence> sequences;
  for (const SweepSetting& setting : settings) {
    const Experiment experiment{setting.file, "airfoil1", setting.options, kSweepRuns};
    const auto runs = laboratory.runs(experiment);
    if (!runs) return runs.error();
    add_cells(table, *runs, table.columns.size());
    sequences.push_back(plotted_column(table, table.columns.size(), setting.name,
                                       static_cast<unsigned>(sequences.size())));
    table.columns.push_back({setting.name, "nodes", 0, CellRule::kNever});
    table.columns.push_back({setting.name, "angle", 1, CellRule::kNever});
  }
  for (ExhibitRow& row : table.rows) row.cells.resize(table.columns.size());
  const std::string name = concat({exhibit.name, "-", parameter});
  exhibit.pictures.push_back(
      {concat({name, "-sizes"}), "nodes by level", size_chart(sequences, Plot::kSizes)});
  exhibit.pictures.push_back({concat({name, "-log-sizes"}), "nodes by level, logarithmic",
                              size_chart(sequences, Plot::kLogSizes)});
  exhibit.pictures.push_back({concat({name, "-angles"}),
                              "average smallest angle by size of the level",
                              angle_chart(sequences)});
  exhibit.tables.push_back(std::move(table));
  return Ok{};
}

// ---- The drawings

constexpr std::size_t kDrawnLevels = 4;

Result<Hierarchy> drawn_hierarchy(Laboratory& laboratory, const PlottedMesh& mesh,
                                  CoarseningMethod method) {
  auto hierarchy = laboratory.first_hierarchy(suite_experiment(std::string(mesh.name), method));
  if (hierarchy && !hierarchy->complete) return cancelled();
  return hierarchy;
}

std::string panel_caption(const char* method, const TriangleMesh& mesh) {
  return concat({std::string(method), ": ", mesh.points.size(), " nodes, ", mesh.triangles.size(),
                 " triangles"});
}

void add_drawings(Exhibit& exhibit, const PlottedMesh& mesh, const Hierarchy& function,
                  const Hierarchy& mis) {
  const std::size_t levels = std::max(function.levels.size(), mis.levels.size());
  for (std::size_t k = 1; k < std::min(levels, kDrawnLevels + 1); ++k) {
    std::vector<Panel> panels;
    if (k < function.levels.size())
      panels.push_back(
          {&function.levels[k].mesh, panel_caption("function-based", function.levels[k].mesh)});
    if (k < mis.levels.size())
      panels.push_back({&mis.levels[k].mesh, panel_caption("MIS-based", mis.levels[k].mesh)});
    TextWriter out;
    write_panels_svg(out, panels, 2, {.width = 560, .line_width = 0.5, .border_width = 1.2});
    exhibit.pictures.push_back({concat({"drawings-", mesh.name, "-level-", k}),
                                concat({mesh.title, ", level ", k}), out.text()});
  }
}

}  // namespace

void add_sequence_charts(Exhibit& exhibit) {
  const std::vector<PlottedSequence> lines = plotted_lines(exhibit.tables);
  for (const Plot plot : {Plot::kLogSizes, Plot::kAngles}) {
    exhibit.pictures.push_back(plot_picture(exhibit.name, exhibit.title, plot, lines));
    exhibit.pictures.back().repeats = true;
  }
}

Result<Exhibit> parameter_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  const auto mesh = laboratory.mesh("airfoil1");
  if (!mesh) return mesh.error();
  exhibit.notes.push_back(concat({"AIRFOIL 1: ", (*mesh)->origin, "; of each setting ",
                                  laboratory.runs_text({.thesis_runs = kSweepRuns}),
                                  "; the thesis prints no figures, only the plots."}));
  for (auto& [parameter, settings] :
       {std::pair{"C", factor_settings()}, std::pair{"beta", beta_settings()}})
    if (Status status = add_sweep(laboratory, exhibit, parameter, settings); !status)
      return status.error();
  return exhibit;
}

Result<Exhibit> grid_figure_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  return plotted_exhibit(laboratory, std::move(exhibit), kPlottedGrids,
                         {Plot::kLogSizes, Plot::kAngles});
}

Result<Exhibit> size_figure_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  return plotted_exhibit(laboratory, std::move(exhibit), kPlottedMeshes, {Plot::kSizes});
}

Result<Exhibit> log_size_figure_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  return plotted_exhibit(laboratory, std::move(exhibit), kPlottedMeshes, {Plot::kLogSizes});
}

Result<Exhibit> angle_figure_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  return plotted_exhibit(laboratory, std::move(exhibit), kPlottedMeshes, {Plot::kAngles});
}

Result<Exhibit> drawings_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  for (const PlottedMesh& mesh : kPlottedMeshes) {
    if (mesh.name == "airfoil2") continue;
    const auto function = drawn_hierarchy(laboratory, mesh, CoarseningMethod::kFunction);
    if (!function) return function.error();
    const auto mis = drawn_hierarchy(laboratory, mesh, CoarseningMethod::kMis);
    if (!mis) return mis.error();
    add_drawings(exhibit, mesh, *function, *mis);
  }
  exhibit.notes.push_back(concat({"Drawn of the run of seed ", laboratory.options().seed,
                                  ". The coordinates of AIRFOIL 2 are lost."}));
  return exhibit;
}

}  // namespace wellspaced
