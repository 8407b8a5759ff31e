#include "wellspaced/io/reproduce/mesh_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/generate/mis_degradation.hpp"
#include "wellspaced/io/pictures/chart.hpp"
#include "wellspaced/io/pictures/svg.hpp"
#include "wellspaced/io/reproduce/published.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

// ---- Table 8.1

// name: in published_suite; mesh: as the laboratory names the one that the thesis measured; empty:
// lost. aspect: of a grid, else 0.
struct SuiteRow {
  std::string_view name, title, mesh;
  double aspect = 0;
};
constexpr SuiteRow kSuiteRows[] = {
    {"crack", "CRACK", "crack_triangulated"},
    {"airfoil1", "AIRFOIL 1", "airfoil1"},
    {"airfoil2", "AIRFOIL 2", ""},
    {"airfoil3", "AIRFOIL 3", "airfoil3_triangulated"},
    {"", "GRID(1)", "grid1", 1},
    {"", "GRID(10)", "grid10", 10},
    {"", "GRID(20)", "grid20", 20},
};
constexpr std::size_t kSuiteColumns = 8;
using SuiteFigures = std::array<std::optional<double>, kSuiteColumns>;

// Angles whose cotangent is at least `cotangent`.
std::size_t count_small_angles(const TriangleMesh& mesh, double cotangent) {
  std::size_t count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    count += corner_cotangent(p, q, r) >= cotangent;
    count += corner_cotangent(q, r, p) >= cotangent;
    count += corner_cotangent(r, p, q) >= cotangent;
  }
  return count;
}

double smallest_angle(const AngleStatistics& angles) {
  return std::fmin(angles.interior_min_deg.value_or(180), angles.boundary_min_deg.value_or(180));
}

SuiteFigures suite_figures(const TriangleMesh& mesh) {
  constexpr double kCotangentOf20Degrees = 2.747477419454622;
  const AngleStatistics angles = angle_statistics(mesh);
  const auto triangles = static_cast<double>(mesh.triangles.size());
  const std::optional<double> scales = gradation(mesh);
  SuiteFigures figures;
  figures[0] = static_cast<double>(mesh.points.size());
  figures[1] = triangles;
  figures[2] = scales;
  if (scales && *scales > 0) figures[3] = triangles / *scales;
  figures[4] = smallest_angle(angles);
  figures[5] = angles.max_deg;
  figures[6] = static_cast<double>(angles.interior_le_10 + angles.boundary_le_10);
  figures[7] = static_cast<double>(count_small_angles(mesh, kCotangentOf20Degrees));
  return figures;
}

// The last row of Table 8.1 is in formulas of the aspect a.
SuiteFigures printed_grid(double aspect) {
  constexpr double kTriangles = 1996002;
  SuiteFigures figures = {1e6, kTriangles, binary_logarithm(aspect)};
  if (aspect > 1) figures[3] = kTriangles / binary_logarithm(aspect);
  figures[4] = arccotangent_deg(aspect);
  figures[5] = 90;
  return figures;
}

SuiteFigures printed_figures(const SuiteRow& row) {
  if (row.aspect > 0) return printed_grid(row.aspect);
  SuiteFigures figures;
  for (const PublishedMesh& mesh : published_suite())
    if (mesh.mesh == row.name) std::ranges::copy(mesh.figures, figures.begin());
  return figures;
}

std::vector<ExhibitColumn> suite_columns() {
  return {{"size", "nodes", 0},
          {"size", "triangles", 0},
          {"gradation", "g = log E/e"},
          {"gradation", "triangles / g", 0},
          {"angles", "smallest", 2, CellRule::kTwoDegrees},
          {"angles", "largest", 2, CellRule::kTwoDegrees},
          {"angles", "number ≤ 10°", 0},
          {"angles", "number ≤ 20°", 0}};
}

ExhibitTable suite_table(const std::string& name) {
  ExhibitTable table{.name = name, .title = "Properties of the test suite meshes"};
  table.row_heading = "mesh";
  table.columns = suite_columns();
  return table;
}

ExhibitRow suite_row(const SuiteRow& row, const SuiteFigures& ours) {
  const SuiteFigures published = printed_figures(row);
  ExhibitRow result{std::string(row.title), {}};
  for (std::size_t i = 0; i < kSuiteColumns; ++i)
    result.cells.push_back({ours[i], published[i], ours[i], ours[i]});
  return result;
}

// Figures 8.1, 8.2 and 8.4: a zoom and the whole.
void add_mesh_pictures(Exhibit& exhibit, const SuiteRow& row, const TriangleMesh& mesh) {
  constexpr double kZoom = 12;
  const std::string name = concat({exhibit.name, "-", row.name});
  const std::string title(row.title);
  TextWriter zoom, whole;
  write_mesh_svg(zoom, mesh, {.width = 560, .line_width = 0.5, .zoom = kZoom});
  write_mesh_svg(whole, mesh, {.width = 560, .line_width = 0.4});
  exhibit.pictures.push_back(
      {concat({name, "-zoom"}), concat({title, ", the densest place"}), zoom.text()});
  exhibit.pictures.push_back({name, title, whole.text()});
}

// ---- Section 6.1

constexpr double kMostPatternNodes = 1.7e6;
constexpr unsigned kDeepestPattern = 8;

double pattern_power(double base, unsigned exponent) {
  double result = 1;
  for (unsigned i = 0; i < exponent; ++i) result *= base;
  return result;
}

double pattern_nodes(unsigned levels) {
  return (pattern_power(2, levels) + 1) * (pattern_power(3, levels) + 1);
}

unsigned pattern_levels(double scale) {
  unsigned levels = 1;
  while (levels < kDeepestPattern && pattern_nodes(levels + 1) <= kMostPatternNodes * scale * scale)
    ++levels;
  return levels;
}

// The smallest angles of the levels that greedy independent sets leave of the pattern.
Result<std::vector<double>> pattern_angles(unsigned levels, const Progress& progress) {
  auto mesh = generate_mis_degradation(levels);
  if (!mesh) return mesh.error();
  CoarseningOptions options;
  options.method = CoarseningMethod::kMis;
  options.order = SelectionOrder::kPriority;
  options.protect = 0;
  options.max_levels = levels;
  options.progress = progress;
  const auto hierarchy = coarsen(std::move(*mesh), options);
  if (!hierarchy) return hierarchy.error();
  if (!hierarchy->complete) return cancelled();
  std::vector<double> angles;
  for (const Level& level : hierarchy->levels)
    angles.push_back(smallest_angle(angle_statistics(level.mesh)));
  return angles;
}

ExhibitRow degradation_row(unsigned level, std::span<const double> measured,
                           const PublishedDegradation& published) {
  const double formula = arccotangent_deg(pattern_power(3, level) / pattern_power(2, level));
  std::optional<double> angle;
  if (level < measured.size()) angle = measured[level];
  const double pattern = pattern_power(6, level), needed = pattern_nodes(level);
  return {std::to_string(level),
          {{angle, published[0], angle, angle},
           {formula, published[0], formula, formula},
           {pattern, published[1], pattern, pattern},
           {needed, {}, needed, needed}}};
}

ExhibitPicture degradation_picture(const ExhibitTable& table) {
  ChartSeries ours{"measured"}, published{"thesis", {}, 0, true};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto level = static_cast<double>(row + 1);
    const std::vector<ExhibitCell>& cells = table.rows[row].cells;
    if (cells[0].ours) ours.points.push_back({level, *cells[0].ours});
    if (cells[1].published) published.points.push_back({level, *cells[1].published});
  }
  TextWriter out;
  write_chart_svg(out, {{"level"}, {"smallest angle, degrees"}, {ours, published}});
  return {table.name, "Smallest angle by level", out.text()};
}

}  // namespace

Result<Exhibit> suite_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  ExhibitTable originals = suite_table(exhibit.name);
  ExhibitTable others = suite_table(concat({exhibit.name, "-others"}));
  others.comparable = false;
  others.title += ": lost, or not the thesis' own";
  std::string sources;
  for (const SuiteRow& row : kSuiteRows) {
    if (row.mesh.empty()) {
      others.rows.push_back(suite_row(row, {}));
      continue;
    }
    const auto source = laboratory.mesh(std::string(row.mesh));
    if (!source) return source.error();
    const auto mesh = (*source)->make(laboratory.options().seed);
    if (!mesh) return mesh.error();
    if (row.aspect == 0) add_mesh_pictures(exhibit, row, *mesh);
    ExhibitTable& table = (*source)->is_original ? originals : others;
    table.rows.push_back(suite_row(row, suite_figures(*mesh)));
    append(sources, {(*source)->title, ": ", (*source)->origin, "; "});
  }
  exhibit.notes.push_back(
      concat({sources, "AIRFOIL 2: its coordinates are lost, only its graph survives."}));
  if (!laboratory.options().data.empty())
    exhibit.notes.push_back(
        "Under ≤ 20° the thesis seems to leave out the angles of at most 10°: it prints 7 and 24 "
        "where "
        "we count 8 and 25.");
  if (!originals.rows.empty()) exhibit.tables.push_back(std::move(originals));
  exhibit.tables.push_back(std::move(others));
  return exhibit;
}

Result<Exhibit> degradation_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  const unsigned levels = pattern_levels(laboratory.options().scale);
  const auto angles = pattern_angles(levels, laboratory.options().progress);
  if (!angles) return angles.error();
  ExhibitTable table{.name = exhibit.name, .title = "Greedy independent sets on the pattern"};
  table.columns = {{"smallest angle", "measured", 2, CellRule::kTwoDegrees},
                   {"smallest angle", "atan (2/3)^k", 2, CellRule::kTwoDegrees},
                   {"nodes", "6^k", 0},
                   {"nodes", "really needed", 0, CellRule::kNever}};
  unsigned level = 0;
  for (const PublishedDegradation& published : published_degradation())
    table.rows.push_back(degradation_row(++level, *angles, published));
  if (levels < table.rows.size()) {
    for (std::size_t row = levels; row < table.rows.size(); ++row)
      table.rows[row].cells[0].published = std::nullopt;
    table.note = concat({"measured on the pattern of ", levels, " levels"});
  }
  exhibit.notes.push_back(
      "The thesis counts 6^k nodes for level k; whole cells of the pattern take "
      "(2^k + 1)(3^k + 1). It truncates the angles.");
  exhibit.pictures.push_back(degradation_picture(table));
  exhibit.tables.push_back(std::move(table));
  return exhibit;
}

}  // namespace wellspaced
