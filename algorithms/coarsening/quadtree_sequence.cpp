#include "wellspaced/algorithms/coarsening/quadtree_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"
#include "wellspaced/algorithms/coarsening/level_triangulation.hpp"
#include "wellspaced/algorithms/coarsening/measured_edge.hpp"
#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/algorithms/coarsening/quadtree_stages.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/radix_sort.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using TellPhase = std::function<bool(std::string_view)>;

// ---- Local searches

// Finds candidates near a place by walking from its leaf over the leaves that meet a box.
class LeafWalk {
 public:
  explicit LeafWalk(const QuadtreeStage& stage)
      : stage_(stage), boxes_(stage.tree.leaves()), met_(stage.tree.leaves(), 0) {
    for (Index leaf = 0; leaf < stage.tree.leaves(); ++leaf) boxes_[leaf] = stage.tree.box(leaf);
  }

  // Calls visit with all candidates in the leaves that meet `box`, and some more.
  // Requires: it meets the leaf of candidate v.
  template <class Visit>
  void for_each_candidate_in(const Box2& box, Index v, Visit visit) {
    ++walk_;
    leaves_.clear();
    meet(stage_.leaf_of[v]);
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const Index leaf = leaves_[i];
      for (Index w = stage_.first[leaf]; w < stage_.first[leaf + 1]; ++w) visit(w);
      if (contains(boxes_[leaf], box)) continue;
      stage_.topology.for_each_neighbor(leaf, [&](Index next) {
        if (met_[next] != walk_ && boxes_[next].meets(box)) meet(next);
      });
    }
  }

 private:
  static bool contains(const Box2& outer, const Box2& inner) {
    return outer.low.x <= inner.low.x && inner.high.x <= outer.high.x &&
           outer.low.y <= inner.low.y && inner.high.y <= outer.high.y;
  }
  void meet(Index leaf) {
    met_[leaf] = walk_;
    leaves_.push_back(leaf);
  }

  const QuadtreeStage& stage_;
  std::vector<Box2> boxes_;
  std::vector<std::uint64_t> met_;  // one a leaf: the last walk that met it
  std::uint64_t walk_ = 0;
  std::vector<Index> leaves_;
};

// p and q are in conflict when f(p) + f(q) > beta |p - q|. Since f is 1-Lipschitz, q is then within
// 2 f(p) / (beta - 1); a little is added for rounding.
ConflictRule tree_conflicts(const QuadtreeStage& stage, LeafWalk& walk, double beta) {
  return [&stage, &walk, beta](Index v, std::vector<Conflict>& conflicts) {
    const Point2 p = stage.points[v];
    const double f = stage.spacing[v];
    const double reach = 2 * f / (beta - 1) + 1e-6 * f;
    const Box2 box{{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}};
    walk.for_each_candidate_in(box, v, [&](Index w) {
      const Point2 q = stage.points[w];
      if (!box.meets({q, q})) return;
      if (f + stage.spacing[w] > beta * distance(p, q)) conflicts.push_back({w, true});
    });
  };
}

// ---- One level

struct LevelChoice {
  std::vector<Index> nodes;  // candidates of the stage, ascending
  std::vector<ContractedEdge> edges;
  std::size_t reinstated = 0, dropped_outside = 0;
};

// As protect_edges does it, but sought in the tree.
void protect_contracted_edges(const QuadtreeStage& stage, std::span<const ContractedEdge> edges,
                              double ratio, LeafWalk& walk, NodeSelection& selection) {
  for (const ContractedEdge& contracted : edges) {
    const MeasuredEdge edge{stage.points[contracted.a], stage.points[contracted.b]};
    // The diametral circle reaches half a length to both sides.
    const Box2 box = edge.box_with_margin(std::min(ratio, 0.5));
    walk.for_each_candidate_in(box, contracted.a, [&](Index v) {
      const Point2 p = stage.points[v];
      if (!stage.boundary.on_boundary[v] && edge.has_in_diametral_circle(p) &&
          edge.distance_of_line_from(p) < ratio * edge.length)
        selection.invalidate(v);
    });
  }
}

std::size_t drop_candidates_outside(const QuadtreeStage& stage,
                                    const ContractedBoundary& contracted,
                                    NodeSelection& selection) {
  std::size_t dropped = 0;
  if (!contracted.moves_anything()) return dropped;
  for (Index v = 0; v < stage.nodes(); ++v) {
    if (stage.boundary.on_boundary[v] || !selection.is_free(v)) continue;
    if (!contracted.leaves_outside(stage.points[v])) continue;
    selection.invalidate(v);
    ++dropped;
  }
  return dropped;
}

// forced: candidates that the level must have, special points and the nodes of the coarser level.
// Returns: nothing when told to stop.
std::optional<LevelChoice> choose_level(const QuadtreeStage& stage, std::span<const Index> forced,
                                        const CoarseningOptions& options, const TellPhase& tell) {
  if (!tell("boundary")) return std::nullopt;
  LeafWalk walk(stage);
  NodeSelection selection(stage.nodes(), stage.boundary.twins,
                          tree_conflicts(stage, walk, options.beta));
  selection.force(forced);
  if (!selection.select(stage.boundary.nodes, NodeSelection::kByNumber,
                        [&] { return tell("boundary"); }))
    return std::nullopt;
  const std::size_t chosen = selection.selected().size();
  const ContractedBoundary contracted =
      contract_and_repair(stage.boundary, stage.points, selection);
  LevelChoice choice;
  choice.edges = contracted.edges();
  choice.reinstated = selection.selected().size() - chosen;
  protect_contracted_edges(stage, choice.edges, protection_ratio(options), walk, selection);

  if (!tell("select")) return std::nullopt;
  choice.dropped_outside = drop_candidates_outside(stage, contracted, selection);
  std::vector<Index> interior;
  for (Index v = 0; v < stage.nodes(); ++v)
    if (!stage.boundary.on_boundary[v]) interior.push_back(v);
  if (!selection.select(interior, NodeSelection::kByNumber, [&] { return tell("select"); }))
    return std::nullopt;
  choice.nodes = selection.selected();
  return choice;
}

// A level numbers its nodes as M_0 does.
struct LevelNumbering {
  std::vector<Index> candidate;  // for each node of the level
  std::vector<Index> node;       // for each candidate, or kNoIndex
};

LevelNumbering number_level(const QuadtreeStage& stage, std::span<const Index> chosen) {
  std::vector<KeyedItem> order;
  order.reserve(chosen.size());
  for (const Index v : chosen) order.push_back({stage.origin[v], v});
  radix_sort(order);
  LevelNumbering numbering{{}, std::vector<Index>(stage.nodes(), kNoIndex)};
  for (const KeyedItem& item : order) {
    numbering.node[item.item] = static_cast<Index>(numbering.candidate.size());
    numbering.candidate.push_back(item.item);
  }
  return numbering;
}

Result<Level> make_level(const Level& finest, const QuadtreeStage& stage,
                         const LevelChoice& choice) {
  const auto [candidate, node] = number_level(stage, choice.nodes);
  Level level;
  level.reinstated = stage.reinstated + choice.reinstated;
  level.dropped_outside = stage.dropped_outside + choice.dropped_outside;
  for (const Index v : candidate) {
    level.origin.push_back(stage.origin[v]);
    level.spacing.push_back(stage.spacing[v]);
    level.mesh.points.push_back(stage.points[v]);
    if (!finest.mesh.point_markers.empty())
      level.mesh.point_markers.push_back(finest.mesh.point_markers[stage.origin[v]]);
  }
  for (const Index v : stage.fixed) level.mesh.fixed.push_back(node[v]);
  sort(level.mesh.fixed);

  std::vector<Index> along_curve;
  for (const Index v : choice.nodes) along_curve.push_back(node[v]);
  auto triangulation = triangulate_domain(
      level.mesh.points, constrained_edges(stage.boundary, choice.edges, node), along_curve);
  if (!triangulation) return triangulation.error();
  level.mesh.triangles = std::move(triangulation->triangles);
  level.mesh.segments = std::move(triangulation->segments);
  return level;
}

// ---- The sequence

// From M_0's stage on, until the tree gets no coarser: mostly one leaf, that no candidate can be
// dropped from.
std::vector<QuadtreeStage> make_stages(const Level& finest, const Boundary& boundary,
                                       const CoarseningOptions& options, const TellPhase& tell) {
  int doublings = 1;
  while (doublings < kMortonDepth && std::ldexp(1.0, doublings) < options.factor) ++doublings;
  std::vector<QuadtreeStage> stages;
  if (!tell("spacing")) return stages;
  stages.push_back(first_stage(finest, boundary, options.beta));
  Quadtree least(stages[0].tree.square());
  if (options.limit_by_special_points)
    least = tree_of_special_points(stages[0], finest, options.beta);
  while (stages.size() <= options.max_levels && stages.back().tree.leaves() > 1) {
    if (!tell("spacing")) return {};
    QuadtreeStage next = next_stage(stages.back(), doublings, least);
    if (next.tree.leaves() >= stages.back().tree.leaves()) break;
    stages.push_back(std::move(next));
    if (stages.size() == 2) stages[0] = {};  // the largest; no level is selected from it
  }
  return stages;
}

// levels: coarse to fine. Leaves out those that drop no node, and those after the first that has
// few enough.
void append_levels(std::vector<Level> levels, std::size_t until_nodes, Hierarchy& hierarchy) {
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    const Level& finer = hierarchy.levels.back();
    if (finer.mesh.points.size() <= until_nodes) return;
    if (level->mesh.points.size() == finer.mesh.points.size()) continue;
    level->parent = numbers_among(level->origin, finer.origin);
    hierarchy.levels.push_back(std::move(*level));
  }
}

}  // namespace

Result<Hierarchy> coarsen_by_quadtree(Level finest, Boundary boundary,
                                      const CoarseningOptions& options) {
  const std::size_t nodes = finest.mesh.points.size();
  std::vector<Index> coarser;  // nodes of the level before, as candidates of the stage
  const TellPhase tell = [&](std::string_view phase) {
    return report(options.progress, phase, coarser.size(), nodes);
  };
  std::vector<QuadtreeStage> stages = make_stages(finest, boundary, options, tell);
  Hierarchy hierarchy;
  hierarchy.complete = !stages.empty();
  std::vector<Level> levels;
  for (std::size_t i = stages.size(); i-- > 1;) {
    std::vector<Index> forced = stages[i].fixed;
    forced.insert(forced.end(), coarser.begin(), coarser.end());
    const auto choice = choose_level(stages[i], forced, options, tell);
    hierarchy.complete = choice && tell("triangulate");
    if (!hierarchy.complete) break;
    auto level = make_level(finest, stages[i], *choice);
    if (!level) return level.error();
    levels.push_back(std::move(*level));
    levels.back().step = levels.size();
    coarser.clear();
    for (const Index v : choice->nodes) coarser.push_back(stages[i].finer[v]);
    stages.pop_back();
  }
  hierarchy.levels.push_back(std::move(finest));
  append_levels(std::move(levels), options.until_nodes, hierarchy);
  return hierarchy;
}

}  // namespace wellspaced
