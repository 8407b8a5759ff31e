#include "wellspaced/algorithms/coarsening/quality/refinement_sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/coarsening/contraction.hpp"
#include "wellspaced/algorithms/coarsening/level_triangulation.hpp"
#include "wellspaced/algorithms/coarsening/quality/editable_level.hpp"
#include "wellspaced/algorithms/coarsening/quality/level_sizing.hpp"
#include "wellspaced/algorithms/coarsening/quality/node_exchange.hpp"
#include "wellspaced/algorithms/coarsening/quality/refinement.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

// How much of the way to a level's size its triangles are mended at: late enough that few nodes go
// to triangles that would have been refined anyway, often enough that the size is met.
constexpr std::array kPartsOfGrowth = {0.6, 0.85, 0.93, 0.97, 0.99, 1.0};

// A level may miss its size by this part of it.
constexpr double kSlack = 0.02;

// The spacing of a level is evened out: see even_out.
constexpr double kMostRefinement = 1.4, kMostCoarsening = 1.3;

// With so many times the nodes that the angles alone ask for, a level can have its angles.
constexpr double kFloorMargin = 1.5;

double squared_sine(double degrees) {
  const double sine = circle_point(degrees / 360).y;
  return sine * sine;
}

std::size_t rounded_up(double x) { return static_cast<std::size_t>(std::ceil(x)); }

std::size_t part_of(std::size_t nodes, double part) {
  return static_cast<std::size_t>(static_cast<double>(nodes) * part);
}

// The growth of spacing by and large that a ratio of nodes stands for.
double growth(std::size_t finer, std::size_t coarser) {
  return std::sqrt(static_cast<double>(finer) / static_cast<double>(coarser));
}

class RefinementRun {
 public:
  RefinementRun(Level finest, const Skeleton& skeleton, const CoarseningOptions& options)
      : options_(options),
        skeleton_(skeleton),
        finest_(std::move(finest)),
        least_sine_sq_(squared_sine(options.angle_deg)) {}

  Result<Hierarchy> run();

 private:
  bool tell(std::string_view phase);
  void find_nodes_for_angles(EditableLevel level);
  std::vector<std::size_t> sizes() const;
  void even_out(std::span<const double> coarser, std::size_t coarser_nodes, std::size_t nodes,
                std::vector<double>& spacing) const;
  void refine(EditableLevel& level, std::span<const double> spacing, std::size_t nodes);
  Result<Level> finished(const EditableLevel& level) const;
  Result<Hierarchy> stacked(std::vector<Level> coarse_to_fine);

  const CoarseningOptions& options_;
  const Skeleton& skeleton_;
  Level finest_;
  double least_sine_sq_;
  std::size_t nodes_for_angles_ = 0;
  std::size_t done_ = 0;
  bool cancelled_ = false;
};

bool RefinementRun::tell(std::string_view phase) {
  cancelled_ = cancelled_ || !report(options_.progress, phase, done_, finest_.mesh.points.size());
  return !cancelled_;
}

// A little more than what the special points' polygons need for their angles alone.
void RefinementRun::find_nodes_for_angles(EditableLevel level) {
  const std::size_t all = finest_.mesh.points.size();
  const std::vector<double> spacing(all, 1);
  Refinement refinement(skeleton_.graph, level, {spacing, least_sine_sq_, options_.seed});
  refinement.mend(all, [&] { return tell("spacing"); });
  nodes_for_angles_ = rounded_up(kFloorMargin * static_cast<double>(level.size()));
}

// The sizes of the levels, the coarsest first.
std::vector<std::size_t> RefinementRun::sizes() const {
  std::vector<std::size_t> sizes = options_.targets;
  if (sizes.empty()) {
    const auto stop = static_cast<double>(std::max(nodes_for_angles_, options_.until_nodes));
    double nodes = static_cast<double>(finest_.mesh.points.size()) / options_.ratio;
    for (; nodes >= stop; nodes /= options_.ratio) sizes.push_back(static_cast<std::size_t>(nodes));
  }
  std::ranges::sort(sizes, std::greater());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  const auto small = [&](std::size_t size) { return size <= options_.until_nodes; };
  const auto last = std::ranges::find_if(sizes, small);
  if (last != sizes.end()) sizes.erase(last + 1, sizes.end());
  sizes.resize(std::min(sizes.size(), options_.max_levels));
  std::ranges::reverse(sizes);
  return sizes;
}

// Raises the spacing of a level where it would refine the coarser one more than 1.4 times what it
// does by and large: there a triangle would meet too many of the finer level. But it does not rise
// above 1.3 times what the input's shortest edges grow to by and large.
void RefinementRun::even_out(std::span<const double> coarser, std::size_t coarser_nodes,
                             std::size_t nodes, std::vector<double>& spacing) const {
  const double most = kMostRefinement * growth(nodes, coarser_nodes);
  const double from_input = 2 * kMostCoarsening * growth(spacing.size(), nodes);
  for (std::size_t v = 0; v < spacing.size(); ++v)
    spacing[v] = std::max(spacing[v], std::min(coarser[v] / most, from_input * finest_.spacing[v]));
}

void RefinementRun::refine(EditableLevel& level, std::span<const double> spacing,
                           std::size_t nodes) {
  std::vector<std::uint8_t> stays(finest_.mesh.points.size(), 0);
  for (const Index v : level.nodes()) stays[v] = 1;
  const std::size_t start = std::min(level.size(), nodes);
  const std::size_t most = part_of(nodes, 1 + kSlack), least = nodes - part_of(nodes, kSlack);
  const auto keep_going = [&] { return tell("select"); };

  Refinement refinement(skeleton_.graph, level, {spacing, least_sine_sq_, options_.seed});
  for (const double part : kPartsOfGrowth) {
    refinement.grow(start + part_of(nodes - start, part), keep_going);
    refinement.mend(most, keep_going);
  }
  exchange_nodes(skeleton_.graph, level, {least_sine_sq_, least, most, stays}, keep_going);
}

// The level as it is now, without its parent.
Result<Level> RefinementRun::finished(const EditableLevel& editable) const {
  const TriangleMesh& mesh = finest_.mesh;
  Level level;
  level.origin = editable.nodes();
  std::vector<std::uint8_t> survives(mesh.points.size(), 0);
  std::vector<Index> number(mesh.points.size(), kNoIndex);
  for (const Index v : level.origin) {
    survives[v] = 1;
    number[v] = static_cast<Index>(level.mesh.points.size());
    level.mesh.points.push_back(mesh.points[v]);
    if (!mesh.point_markers.empty()) level.mesh.point_markers.push_back(mesh.point_markers[v]);
  }
  for (const Index v : mesh.fixed) level.mesh.fixed.push_back(number[v]);
  const std::vector<ContractedEdge> edges =
      contract_boundary(skeleton_.boundary, mesh.points, survives);
  auto triangulation =
      triangulate_domain(level.mesh.points, constrained_edges(skeleton_.boundary, edges, number));
  if (!triangulation) return triangulation.error();
  level.mesh.triangles = std::move(triangulation->triangles);
  level.mesh.segments = std::move(triangulation->segments);
  const Graph graph = mesh_graph(level.mesh);
  level.spacing = coarsened_spacing(graph, mesh_spacing(graph), options_.beta);
  return level;
}

Result<Hierarchy> RefinementRun::stacked(std::vector<Level> coarse_to_fine) {
  Hierarchy hierarchy;
  hierarchy.complete = !cancelled_;
  hierarchy.nodes_for_angles = nodes_for_angles_;
  hierarchy.levels.push_back(std::move(finest_));
  while (!coarse_to_fine.empty()) {
    Level level = std::move(coarse_to_fine.back());
    coarse_to_fine.pop_back();
    level.parent = numbers_among(level.origin, hierarchy.levels.back().origin);
    hierarchy.levels.push_back(std::move(level));
  }
  return hierarchy;
}

Result<Hierarchy> RefinementRun::run() {
  std::vector<Level> levels;
  auto level = EditableLevel::build(finest_.mesh, skeleton_, finest_.mesh.fixed);
  if (!level) return level.error();
  if (!level->has_triangles()) return stacked({});
  find_nodes_for_angles(*level);
  const std::vector<std::size_t> sizes = this->sizes();
  if (sizes.empty() || !tell("spacing")) return stacked({});
  const LevelSizing sizing(finest_, skeleton_.graph, options_.beta, sizes.front());
  std::size_t step = 0;
  std::vector<double> spacing;
  for (const std::size_t nodes : sizes) {
    if (!tell("spacing")) break;
    const std::vector<double> coarser =
        std::exchange(spacing, sizing.spacing_for(sizing.factor_for(nodes)));
    if (step > 0) even_out(coarser, level->size(), nodes, spacing);
    if (!tell("select")) break;
    refine(*level, spacing, nodes);
    if (!tell("triangulate")) break;
    done_ = level->size();
    ++step;
    if (!levels.empty() && levels.back().origin.size() == level->size()) continue;
    auto made = finished(*level);
    if (!made) return made.error();
    levels.push_back(std::move(*made));
    levels.back().step = step;
  }
  return stacked(std::move(levels));
}

}  // namespace

Result<Hierarchy> coarsen_by_refinement(Level finest, const Skeleton& skeleton,
                                        const CoarseningOptions& options) {
  return RefinementRun(std::move(finest), skeleton, options).run();
}

}  // namespace wellspaced
