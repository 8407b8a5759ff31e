#include "wellspaced/io/reproduce/point_figures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/low_discrepancy.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/algorithms/generate/well_spaced.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/io/pictures/svg.hpp"
#include "wellspaced/io/text/text_writer.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr PictureOptions kSquarePicture{.width = 420, .border_width = 1.2};
constexpr PictureOptions kWingPicture{
    .width = 420, .border_width = 1.2, .zoom = 5, .centre = Point2{0.6, 0}};

double smallest_distance(std::span<const Point2> points) {
  const std::vector<double> nearest = nearest_neighbor_spacing(points);
  return *std::ranges::min_element(nearest);
}

// Of the triangles away from the boundary; none for a set without triangles.
std::optional<double> interior_angle(const TriangleMesh& mesh) {
  return mesh.triangles.empty() ? std::nullopt : angle_statistics(mesh).interior_min_deg;
}

// Of the smallest angles of all triangles.
std::optional<double> average_angle(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return std::nullopt;
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    sum += arccotangent_deg(
        std::fmax(corner_cotangent(p, q, r),
                  std::fmax(corner_cotangent(q, r, p), corner_cotangent(r, p, q))));
  }
  return sum / static_cast<double>(mesh.triangles.size());
}

ExhibitTable point_table(const Exhibit& exhibit) {
  ExhibitTable table{.name = exhibit.name, .title = "What the sets are like"};
  table.row_heading = "set";
  table.columns = {{"", "points", 0, CellRule::kNever},
                   {"", "star discrepancy", 5, CellRule::kNever},
                   {"", "least distance · √N", 3, CellRule::kNever},
                   {"angles", "smallest inside", 2, CellRule::kNever},
                   {"angles", "avg small.", 2, CellRule::kNever}};
  return table;
}

ExhibitCell own_figure(const std::optional<double>& figure) { return {figure, {}, figure, figure}; }

void add_set(Exhibit& exhibit, const std::string& name, const TriangleMesh& mesh) {
  const auto count = static_cast<double>(mesh.points.size());
  if (exhibit.tables.empty()) exhibit.tables.push_back(point_table(exhibit));
  exhibit.tables[0].rows.push_back(
      {name,
       {own_figure(count), own_figure(star_discrepancy(mesh.points)),
        own_figure(smallest_distance(mesh.points) * std::sqrt(count)),
        own_figure(interior_angle(mesh)), own_figure(average_angle(mesh))}});
}

std::string picture_name(const Exhibit& exhibit) {
  return concat({exhibit.name, static_cast<char>('a' + exhibit.pictures.size())});
}

// The points alone, whatever triangles they have.
void draw_points(Exhibit& exhibit, const std::string& caption, const TriangleMesh& mesh) {
  TriangleMesh dots;
  dots.points = mesh.points;
  TextWriter out;
  write_mesh_svg(out, dots, kSquarePicture);
  exhibit.pictures.push_back({picture_name(exhibit), caption, out.text()});
}

void draw_disks(Exhibit& exhibit, const std::string& caption, const TriangleMesh& mesh,
                std::span<const double> radii, const PictureOptions& options = kSquarePicture) {
  TextWriter out;
  write_disks_svg(out, mesh, radii, options);
  exhibit.pictures.push_back({picture_name(exhibit), caption, out.text()});
}

void add_points(Exhibit& exhibit, const std::string& caption, const TriangleMesh& mesh) {
  add_set(exhibit, caption, mesh);
  draw_points(exhibit, caption, mesh);
}

TriangleMesh mesh_of_points(std::vector<Point2> points) {
  TriangleMesh mesh;
  mesh.points = std::move(points);
  return mesh;
}

using SequenceMaker = std::vector<Point2> (*)(std::size_t count, const Progress& progress);

Exhibit low_discrepancy_exhibit(Exhibit exhibit, SequenceMaker make, const std::string& words) {
  for (const std::size_t count : {400, 1000})
    add_points(exhibit, concat({words, count, " points"}), mesh_of_points(make(count, {})));
  exhibit.notes.push_back(
      "The star discrepancy is exact: the largest difference between share and "
      "area over all boxes that start at the origin.");
  return exhibit;
}

}  // namespace

Result<Exhibit> contrast_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  const auto spaced = generate_well_spaced({.nodes = 1000}, laboratory.options().progress);
  if (!spaced) return spaced.error();
  add_points(exhibit, "well-spaced points", *spaced);
  const std::size_t count = spaced->points.size();
  add_points(exhibit, "uniformly distributed points",
             mesh_of_points(random_points(count, laboratory.options().seed)));
  return exhibit;
}

Result<Exhibit> maximal_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  const std::pair<WellSpacedStyle, const char*> sets[] = {
      {WellSpacedStyle::kLoose, "no ball can be added"},
      {WellSpacedStyle::kTight, "no ball can be added, and the balls kiss"}};
  for (const auto& [style, caption] : sets) {
    const auto mesh =
        generate_well_spaced({.nodes = 160, .style = style}, laboratory.options().progress);
    if (!mesh) return mesh.error();
    add_set(exhibit, caption, *mesh);
    const std::vector<double> radii(mesh->points.size(), smallest_distance(mesh->points) / 2);
    draw_disks(exhibit, caption, *mesh, radii);
  }
  return exhibit;
}

Result<Exhibit> graded_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  constexpr double kOctaves = 5;
  const auto mesh =
      generate_well_spaced({.nodes = 1200, .octaves = kOctaves}, laboratory.options().progress);
  if (!mesh) return mesh.error();
  add_points(exhibit, "spacing grows 32 times from the centre to the corners", *mesh);
  return exhibit;
}

Result<Exhibit> hammersley_exhibit(Laboratory&, Exhibit exhibit) {
  return low_discrepancy_exhibit(std::move(exhibit), hammersley_points, "");
}

Result<Exhibit> halton_exhibit(Laboratory&, Exhibit exhibit) {
  return low_discrepancy_exhibit(std::move(exhibit), halton_points, "first ");
}

Result<Exhibit> function_exhibit(Laboratory& laboratory, Exhibit exhibit) {
  constexpr double kBeta = 4, kFactor = 2;
  auto mesh =
      generate_graded_mesh(GradedDomain::kAirfoil, {.nodes = 1500}, laboratory.options().progress);
  if (!mesh) return mesh.error();
  CoarseningOptions options;
  options.beta = kBeta;
  options.factor = kFactor;
  options.max_levels = 1;
  options.seed = laboratory.options().seed;
  options.progress = laboratory.options().progress;
  const auto hierarchy = coarsen(*mesh, options);
  if (!hierarchy) return hierarchy.error();
  if (hierarchy->levels.size() < 2) return cancelled();
  const Graph graph = mesh_graph(*mesh);
  const std::vector<double> f0 = mesh_spacing(graph);
  const std::vector<double> f1 = coarsened_spacing(graph, f0, kBeta * kFactor);
  const TriangleMesh& coarse = hierarchy->levels[1].mesh;
  const TriangleMesh nodes = mesh_of_points(coarse.points);
  draw_disks(exhibit, "(a) the initial mesh", *mesh, {}, kWingPicture);
  draw_disks(exhibit, "(b) its spacing function", mesh_of_points(mesh->points), f0, kWingPicture);
  draw_disks(exhibit, "(c) the function coarsened", mesh_of_points(mesh->points),
             scaled(f1, 1 / kBeta), kWingPicture);
  draw_disks(exhibit, "(d) nodes with disjoint balls", nodes,
             scaled(hierarchy->levels[1].spacing, 1 / kBeta), kWingPicture);
  draw_disks(exhibit, "(e) their mesh", coarse, {}, kWingPicture);
  exhibit.notes.push_back("Balls have the radius f, the coarsened ones f/β, with β = 4 and C = 2.");
  return exhibit;
}

}  // namespace wellspaced
