#include "wellspaced/algorithms/coarsening/schemes.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/coarsening/level_step.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

std::size_t nodes_of(const Level& level) { return level.mesh.points.size(); }

// Section 8.3: with the method of chapter 7 the first factor makes up for the division of the
// spacing by beta. NN spaces a mesh by any beta >= 2, and the theorems of chapter 6 start from it.
double first_factor(const CoarseningOptions& options) {
  return options.method == CoarseningMethod::kFunction ? options.factor * options.beta
                                                       : options.factor;
}

// A threshold may rise through a gap in the spacing without dropping a node: then it is raised on.
bool raises_a_threshold(const CoarseningOptions& options) {
  return options.method == CoarseningMethod::kThreshold ||
         options.method == CoarseningMethod::kQuasiUniform;
}

// C_i = C^i, and what the first factor has beyond C.
double factor_from_finest(const CoarseningOptions& options, std::size_t i) {
  double factor = first_factor(options);
  for (std::size_t k = 1; k < i; ++k) factor *= options.factor;
  return factor;
}

// The areas that options.keep_boundary leaves to the levels of a mesh.
AreaRange areas_to_keep(const TriangleMesh& mesh, const Boundary& boundary,
                        const CoarseningOptions& options) {
  if (!options.keep_boundary) return {};
  const std::vector<std::uint8_t> all(mesh.points.size(), 1);
  const ContractedBoundary whole(boundary, mesh.points,
                                 contract_boundary(boundary, mesh.points, all));
  return {whole.area() * (1 - *options.keep_boundary), whole.area() * (1 + *options.keep_boundary)};
}

// A run of steps: builds levels, and knows whether it was told to stop.
class SchemeRun {
 public:
  SchemeRun(Level finest, Skeleton skeleton, std::span<const double> limit,
            const CoarseningOptions& options)
      : options_(options),
        limit_(limit),
        areas_(areas_to_keep(finest.mesh, skeleton.boundary, options)),
        skeleton_(std::move(skeleton)) {
    hierarchy_.levels.push_back(std::move(finest));
  }

  Result<Hierarchy> fine_to_coarse();
  Result<Hierarchy> from_finest();
  Result<Hierarchy> coarse_to_fine();

 private:
  Result<CoarseningStep> step(const SourceMesh& source, const StepRequest& request);
  SourceMesh finest_source();
  bool may_go_on() const;
  bool stops(const Result<CoarseningStep>& step);
  bool collapses(const Level& level) const;
  void append(CoarseningStep step);
  std::size_t levels_to_the_end() const;
  void stack(std::vector<CoarseningStep> coarse_to_fine);

  const CoarseningOptions& options_;
  std::span<const double> limit_;
  AreaRange areas_;
  Skeleton skeleton_;
  Hierarchy hierarchy_;
  std::size_t steps_ = 0;
  std::size_t done_ = 0;  // see CoarseningOptions::progress
  bool stopped_ = false;
};

Result<CoarseningStep> SchemeRun::step(const SourceMesh& source, const StepRequest& request) {
  StepRequest within = request;
  within.areas = areas_;
  const std::size_t total = nodes_of(hierarchy_.levels[0]);
  auto built = coarsen_level(source, within, options_, [&](std::string_view phase) {
    stopped_ = stopped_ || !report(options_.progress, phase, done_, total);
    return !stopped_;
  });
  ++steps_;
  if (built) built->level.step = steps_;
  return built;
}

// The finest level as a source. Requires: it stays the only level while the source is used.
SourceMesh SchemeRun::finest_source() {
  return source_mesh(hierarchy_.levels[0], std::move(skeleton_), limit_, options_);
}

bool SchemeRun::may_go_on() const {
  return hierarchy_.levels.size() <= options_.max_levels &&
         nodes_of(hierarchy_.levels.back()) > options_.until_nodes;
}

// Whether a step ended the run, by an error or by being cancelled.
bool SchemeRun::stops(const Result<CoarseningStep>& step) {
  if (step.ok()) return false;
  if (step.error().code == ErrorCode::kCancelled) hierarchy_.complete = false;
  return true;
}

// Whether too few special points have let the domain shrink to nothing.
bool SchemeRun::collapses(const Level& level) const {
  return level.mesh.triangles.empty() && !hierarchy_.levels[0].mesh.triangles.empty();
}

void SchemeRun::append(CoarseningStep step) {
  hierarchy_.levels.back().work = step.work;
  hierarchy_.levels.push_back(std::move(step.level));
}

// Figure 5.7: every level out of the one before.
Result<Hierarchy> SchemeRun::fine_to_coarse() {
  const std::size_t stalls = raises_a_threshold(options_) ? levels_to_the_end() : 0;
  while (may_go_on()) {
    const std::size_t i = hierarchy_.levels.size();
    const Level& finer = hierarchy_.levels.back();
    if (i > 1) skeleton_ = skeleton_of(finer.mesh);
    const SourceMesh source = source_mesh(finer, std::move(skeleton_), limit_, options_);
    double factor = i == 1 ? first_factor(options_) : options_.factor;
    auto built = step(source, {i, factor, {}});
    // max(t, C min t), raised once more, is max(t, C^2 min t).
    for (std::size_t k = 1; built && nodes_of(built->level) == nodes_of(finer) && k < stalls; ++k)
      built = step(source, {i, factor *= options_.factor, {}});
    if (stops(built)) {
      if (hierarchy_.complete) return built.error();
      break;
    }
    if (nodes_of(built->level) == nodes_of(finer) || collapses(built->level)) break;
    done_ = nodes_of(hierarchy_.levels[0]) - nodes_of(built->level);
    append(std::move(*built));
  }
  return std::move(hierarchy_);
}

// Figure 5.8: every level out of the finest mesh, by itself.
Result<Hierarchy> SchemeRun::from_finest() {
  Hierarchy coarser;  // apart, so that the source stays where it is
  const SourceMesh source = finest_source();
  const std::size_t stalls = raises_a_threshold(options_) ? levels_to_the_end() : 0;
  for (std::size_t i = 1; coarser.levels.size() < options_.max_levels; ++i) {
    const bool is_first = coarser.levels.empty();
    const Level& before = is_first ? hierarchy_.levels[0] : coarser.levels.back();
    if (nodes_of(before) <= options_.until_nodes) break;
    auto built = step(source, {i, factor_from_finest(options_, i), {}});
    if (stops(built)) {
      if (hierarchy_.complete) return built.error();
      break;
    }
    if (collapses(built->level)) break;
    if (nodes_of(built->level) >= nodes_of(before)) {
      if (i < stalls) continue;
      break;
    }
    built->level.parent = numbers_among(built->level.origin, before.origin);
    done_ = nodes_of(source.level) - nodes_of(built->level);
    (is_first ? hierarchy_.levels[0] : coarser.levels.back()).work = built->work;
    coarser.levels.push_back(std::move(built->level));
  }
  std::move(coarser.levels.begin(), coarser.levels.end(), std::back_inserter(hierarchy_.levels));
  return std::move(hierarchy_);
}

// The first i at which all nodes are in conflict, so that special points alone are left, unless
// paths through the domain are longer than the diagonal of its box; at most 2048.
std::size_t SchemeRun::levels_to_the_end() const {
  const Level& finest = hierarchy_.levels[0];
  if (nodes_of(finest) == 0) return 0;
  const Box2 box = Box2::around(finest.mesh.points);
  const double reach = options_.beta * distance(box.low, box.high);
  double least = HUGE_VAL;
  for (const double g : finest.spacing)
    if (g > 0) least = std::min(least, g);
  std::size_t i = 1;
  for (double f = first_factor(options_) * least; f < reach && i < 2048; f *= options_.factor) ++i;
  return i;
}

// Figure 5.9: every level out of the finest mesh, the coarsest first, each with the nodes of the
// one before forced in.
Result<Hierarchy> SchemeRun::coarse_to_fine() {
  std::vector<CoarseningStep> built;
  const SourceMesh source = finest_source();
  for (std::size_t i = std::min(levels_to_the_end(), options_.max_levels); i > 0; --i) {
    const std::span<const Index> forced =
        built.empty() ? std::span<const Index>() : built.back().level.origin;
    auto next = step(source, {i, factor_from_finest(options_, i), forced});
    if (stops(next)) {
      if (hierarchy_.complete) return next.error();
      break;
    }
    const std::size_t nodes = nodes_of(next->level);
    if (nodes == nodes_of(source.level)) break;  // nor does any finer level drop a node
    // Of levels with equal nodes the finest stays, and of those within `until` likewise.
    const bool replaces =
        !built.empty() && (nodes == nodes_of(built.back().level) || nodes <= options_.until_nodes ||
                           collapses(built.back().level));
    if (replaces) built.pop_back();
    built.push_back(std::move(*next));
    done_ = nodes;
  }
  if (!built.empty() && collapses(built.back().level)) built.pop_back();
  stack(std::move(built));
  return std::move(hierarchy_);
}

void SchemeRun::stack(std::vector<CoarseningStep> coarse_to_fine) {
  while (!coarse_to_fine.empty()) {
    CoarseningStep step = std::move(coarse_to_fine.back());
    coarse_to_fine.pop_back();
    step.level.parent = numbers_among(step.level.origin, hierarchy_.levels.back().origin);
    append(std::move(step));
  }
}

}  // namespace

Result<Hierarchy> build_levels(Level finest, Skeleton skeleton, std::span<const double> limit,
                               const CoarseningOptions& options) {
  SchemeRun run(std::move(finest), std::move(skeleton), limit, options);
  switch (options.scheme) {
    case CoarseningScheme::kFineToCoarse:
      return run.fine_to_coarse();
    case CoarseningScheme::kFromFinest:
      return run.from_finest();
    case CoarseningScheme::kCoarseToFine:
      return run.coarse_to_fine();
  }
  return Error{ErrorCode::kInternal, "no such scheme", {}};
}

}  // namespace wellspaced
