#include "wellspaced/algorithms/coarsening/quadtree_stages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "wellspaced/algorithms/coarsening/contracted_boundary.hpp"
#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/algorithms/coarsening/special_points.hpp"
#include "wellspaced/algorithms/spacing/quadtree_spacing.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/radix_sort.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// k: a leaf has 4^k parts.
constexpr int kPartDepth = 3;

// Leaves of T_0 are at most this times beta f_0 wide. So T_1 asks for nodes about 3.4 f_0 apart,
// where M_0 has them 2 f_0 apart; of a uniform mesh that keeps a quarter.
constexpr double kFirstSize = 2.36;

// ---- The square

double mean_of_positive(std::span<const double> values) {
  double sum = 0, count = 0;
  for (const double value : values)
    if (value > 0) sum += value, ++count;
  return count > 0 ? sum / count : 0;
}

// A square with the points in its south-west corner, so large that the tree's last function keeps
// special points alone, and halved often enough it has boxes of the side `unit`.
Square tree_square(std::span<const Point2> points, double unit, double beta) {
  const Square around = Square::around(points);
  const double least_side = 3 * beta * around.half_side;
  if (!(unit > 0) || !std::isfinite(unit) || !std::isfinite(least_side)) return around;
  double half_side = unit;
  while (half_side < least_side / 2) half_side *= 2;
  while (half_side / 2 >= least_side / 2) half_side /= 2;
  const Box2 box = Box2::around(points);
  const Square square{{box.low.x + half_side, box.low.y + half_side}, half_side};
  const bool is_finite =
      std::isfinite(square.centre.x + half_side) && std::isfinite(square.centre.y + half_side);
  return is_finite ? square : around;
}

// ---- Candidates

void reserve_candidates(QuadtreeStage& stage, std::size_t count) {
  stage.origin.reserve(count);
  stage.cells.reserve(count);
  stage.points.reserve(count);
}

// Makes all points candidates, along the Z curve. Returns their numbers as such.
std::vector<Index> order_candidates(std::span<const Point2> points, const Square& square,
                                    QuadtreeStage& stage) {
  std::vector<KeyedItem> order(points.size());
  for (Index v = 0; v < points.size(); ++v) order[v] = {square.cell_of(points[v]), v};
  radix_sort(order);
  reserve_candidates(stage, points.size());
  std::vector<Index> number(points.size());
  for (const auto& [cell, v] : order) {
    number[v] = stage.nodes();
    stage.origin.push_back(v);
    stage.cells.push_back(cell);
    stage.points.push_back(points[v]);
  }
  return number;
}

void find_leaves(QuadtreeStage& stage) {
  const Quadtree& tree = stage.tree;
  stage.first.assign(tree.leaves() + std::size_t{1}, 0);
  stage.leaf_of.resize(stage.nodes());
  Index v = 0;
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
    stage.first[leaf] = v;
    for (; v < stage.nodes() && stage.cells[v] < tree.start(leaf + 1); ++v) stage.leaf_of[v] = leaf;
  }
  stage.first.back() = v;
}

void find_spacing(QuadtreeStage& stage) {
  stage.spacing.resize(stage.nodes());
  for (Index leaf = 0; leaf < stage.tree.leaves(); ++leaf) {
    if (stage.first[leaf] == stage.first[leaf + 1]) continue;
    const LeafSpacing spacing(stage.tree, stage.topology, leaf);
    for (Index v = stage.first[leaf]; v < stage.first[leaf + 1]; ++v)
      stage.spacing[v] = spacing.envelope_value(stage.points[v]);
  }
}

// The curves through those of their nodes that have a new number. Where a curve has fewer than two
// left, it is gone.
std::vector<BoundaryCurve> renumbered_curves(const Boundary& boundary,
                                             std::span<const Index> number) {
  std::vector<BoundaryCurve> curves;
  for (const BoundaryCurve& old : boundary.curves) {
    BoundaryCurve curve{old.kind, old.closed, {}, {}};
    for (std::size_t i = 0; i < old.nodes.size(); ++i) {
      if (number[old.nodes[i]] == kNoIndex) continue;
      curve.nodes.push_back(number[old.nodes[i]]);
      if (i < old.markers.size()) curve.markers.push_back(old.markers[i]);
    }
    if (curve.nodes.size() >= 2) curves.push_back(std::move(curve));
  }
  return curves;
}

Boundary renumbered(const Boundary& old, std::span<const Index> number, Index nodes) {
  Boundary boundary;
  boundary.curves = renumbered_curves(old, number);
  boundary.on_boundary.assign(nodes, 0);
  if (!old.twins.next.empty()) boundary.twins.next.resize(nodes);
  for (const Index v : old.nodes)
    if (number[v] != kNoIndex) boundary.on_boundary[number[v]] = 1;
  for (Index v = 0; v < nodes; ++v)
    if (boundary.on_boundary[v]) boundary.nodes.push_back(v);
  for (Index v = 0; v < old.twins.next.size(); ++v)
    if (number[v] != kNoIndex) boundary.twins.next[number[v]] = number[old.twins.next[v]];
  return boundary;
}

void renumber_fixed(std::span<const Index> fixed, std::span<const Index> number,
                    QuadtreeStage& stage) {
  for (const Index v : fixed) stage.fixed.push_back(number[v]);
  sort(stage.fixed);
}

// ---- Thinning

// The first deepest cell of the part of a leaf that a cell lies in.
MortonCode part_of_leaf(const Quadtree& tree, Index leaf, MortonCode cell) {
  const int depth = std::min(tree.depth(leaf) + kPartDepth, kMortonDepth);
  return morton::first_in(morton::ancestor(cell, depth), depth);
}

// Special points, and of each curve the first node on every visit to a part.
std::vector<Index> kept_boundary(const QuadtreeStage& stage, const Quadtree& tree) {
  std::vector<Index> kept = stage.fixed;
  for (const BoundaryCurve& curve : stage.boundary.curves) {
    MortonCode last = ~MortonCode{0};
    for (const Index v : curve.nodes) {
      const MortonCode part = part_of_leaf(tree, tree.locate(stage.cells[v]), stage.cells[v]);
      if (std::exchange(last, part) != part) kept.push_back(v);
    }
  }
  return kept;
}

void no_conflicts(Index, std::vector<Conflict>&) {}

// The candidates that stay, marked: first the boundary, then of the interior nodes in each part the
// first that the new boundary leaves inside.
std::vector<std::uint8_t> surviving_candidates(const QuadtreeStage& stage, QuadtreeStage& next) {
  NodeSelection selection(stage.nodes(), stage.boundary.twins, no_conflicts);
  selection.force(kept_boundary(stage, next.tree));
  const std::size_t kept = selection.selected().size();
  const ContractedBoundary contracted =
      contract_and_repair(stage.boundary, stage.points, selection);
  next.reinstated = selection.selected().size() - kept;

  std::vector<std::uint8_t> stays(stage.nodes());
  MortonCode last = ~MortonCode{0};  // the part that has its node
  Index leaf = 0;
  for (Index v = 0; v < stage.nodes(); ++v) {
    stays[v] = selection.is_selected(v);
    if (stays[v] || stage.boundary.on_boundary[v]) continue;
    while (stage.cells[v] >= next.tree.start(leaf + 1)) ++leaf;
    const MortonCode part = part_of_leaf(next.tree, leaf, stage.cells[v]);
    if (part == last) continue;
    if (contracted.moves_anything() && contracted.leaves_outside(stage.points[v])) {
      ++next.dropped_outside;
      continue;
    }
    stays[v] = 1;
    last = part;
  }
  return stays;
}

void inherit_candidates(const QuadtreeStage& from, std::span<const std::uint8_t> stays,
                        QuadtreeStage& to) {
  std::vector<Index> number(from.nodes(), kNoIndex);
  const auto count = static_cast<std::size_t>(std::count(stays.begin(), stays.end(), 1));
  reserve_candidates(to, count);
  to.finer.reserve(count);
  for (Index v = 0; v < from.nodes(); ++v) {
    if (!stays[v]) continue;
    number[v] = to.nodes();
    to.origin.push_back(from.origin[v]);
    to.finer.push_back(v);
    to.cells.push_back(from.cells[v]);
    to.points.push_back(from.points[v]);
  }
  to.boundary = renumbered(from.boundary, number, to.nodes());
  renumber_fixed(from.fixed, number, to);
}

}  // namespace

QuadtreeStage first_stage(const Level& finest, const Boundary& boundary, double beta) {
  const std::vector<Point2>& points = finest.mesh.points;
  // In a uniform mesh leaves are 1 / sqrt 2 as wide as they may be, so that a node whose f_0 is
  // somewhat smaller or larger than the others' makes no difference.
  const double unit = std::sqrt(0.5) * kFirstSize * beta * mean_of_positive(finest.spacing);
  const Square square = tree_square(points, unit, beta);

  QuadtreeStage stage;
  const std::vector<Index> number = order_candidates(points, square, stage);
  std::vector<double> sizes(points.size(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < stage.nodes(); ++v) {
    const double spacing = finest.spacing[stage.origin[v]];
    if (spacing > 0) sizes[v] = kFirstSize * beta * spacing;
  }
  stage.tree = quadtree_of_sizes(square, stage.points, sizes, QuadtreeBalance::kEdge);
  stage.topology = QuadtreeTopology(stage.tree);
  stage.boundary = renumbered(boundary, number, stage.nodes());
  renumber_fixed(finest.mesh.fixed, number, stage);
  return stage;
}

QuadtreeStage next_stage(const QuadtreeStage& stage, int doublings, const Quadtree& least) {
  QuadtreeStage next;
  next.tree = coarsened(stage.tree, stage.topology, QuadtreeBalance::kEdge);
  for (int i = 1; i < doublings; ++i)
    next.tree = coarsened(next.tree, QuadtreeTopology(next.tree), QuadtreeBalance::kEdge);
  if (least.leaves() > 1) next.tree = overlay(next.tree, least);
  next.topology = QuadtreeTopology(next.tree);
  inherit_candidates(stage, surviving_candidates(stage, next), next);
  find_leaves(next);
  find_spacing(next);
  return next;
}

Quadtree tree_of_special_points(const QuadtreeStage& stage, const Level& finest, double beta) {
  std::vector<Point2> special;
  for (const Index v : finest.mesh.fixed) special.push_back(finest.mesh.points[v]);
  const std::vector<double> sizes = scaled(special_point_distances(finest.mesh), beta);
  return quadtree_of_sizes(stage.tree.square(), special, sizes, QuadtreeBalance::kEdge);
}

}  // namespace wellspaced
