#include "wellspaced/kernel/plane/quadtree_topology.hpp"

#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {

QuadtreeTopology::QuadtreeTopology(const Quadtree& tree)
    : parent_(tree.leaves(), kNoIndex), quarter_(tree.leaves(), 0) {
  splits_.reserve(tree.leaves() / 3);
  depth_.reserve(tree.leaves() / 3);
  number_boxes(tree);
  find_surroundings();
}

// Along the Z curve: at the start of a leaf all split boxes that start there, outermost first.
void QuadtreeTopology::number_boxes(const Quadtree& tree) {
  std::array<Index, kMortonDepth> open{};  // the split box that the curve is in, by depth
  const auto attach = [&](Box box, MortonCode start, int depth) {
    const auto quarter = morton::ancestor(start, depth) & 3;
    splits_[open[depth - 1]].quarter[quarter] = box;
    return static_cast<std::uint8_t>(quarter);
  };
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
    const MortonCode start = tree.start(leaf);
    const int leaf_depth = tree.depth(leaf);
    for (int depth = morton::coarsest_depth(start); depth < leaf_depth; ++depth) {
      const auto number = static_cast<Index>(splits_.size());
      splits_.emplace_back();
      depth_.push_back(static_cast<std::uint8_t>(depth));
      if (depth > 0) attach(kSplit + number, start, depth);
      open[depth] = number;
    }
    if (leaf_depth == 0) continue;
    parent_[leaf] = open[leaf_depth - 1];
    quarter_[leaf] = attach(leaf, start, leaf_depth);
  }
}

// What lies around a quarter lies within what lies around its box.
QuadtreeTopology::Box QuadtreeTopology::around_quarter(const SplitBox& parent, int quarter,
                                                       int direction) const {
  const int column = (quarter & 1) + direction % 3 - 1, row = (quarter >> 1) + direction / 3 - 1;
  const auto part = [](int place) { return place < 0 ? 0 : place > 1 ? 2 : 1; };
  const Box box = parent.around[3 * part(row) + part(column)];
  return is_split(box) ? split(box).quarter[2 * (row & 1) + (column & 1)] : box;
}

QuadtreeTopology::Box QuadtreeTopology::around(Index leaf, int direction) const {
  return parent_[leaf] == kNoIndex
             ? kNothing
             : around_quarter(splits_[parent_[leaf]], quarter_[leaf], direction);
}

// From the root down: preorder puts a box before its quarters.
void QuadtreeTopology::find_surroundings() {
  if (splits_.empty()) return;
  splits_[0].around.fill(kNothing);
  splits_[0].around[4] = kSplit;
  for (const SplitBox& box : splits_)
    for (int quarter = 0; quarter < 4; ++quarter)
      if (is_split(box.quarter[quarter]))
        for (int direction = 0; direction < 9; ++direction)
          splits_[box.quarter[quarter] - kSplit].around[direction] =
              around_quarter(box, quarter, direction);
}

// Smaller boxes beside a box are quarters, split and not collapsing, of what lies around it.
bool QuadtreeTopology::may_collapse(const SplitBox& box, QuadtreeBalance balance,
                                    const std::vector<std::uint8_t>& collapsing) const {
  if (any_of(box.quarter, is_split)) return false;
  const auto stays_split = [&](Box b) { return is_split(b) && !collapsing[b - kSplit]; };
  const auto has_small_leaves_towards = [&](int direction) {
    const Box beside = box.around[direction];
    if (!is_split(beside)) return false;
    for (int quarter = 0; quarter < 4; ++quarter)
      if (faces(quarter, direction) && stays_split(split(beside).quarter[quarter])) return true;
    return false;
  };
  if (any_of(kEdgeDirections, has_small_leaves_towards)) return false;
  return balance == QuadtreeBalance::kEdge || none_of(kCornerDirections, has_small_leaves_towards);
}

// For every split box whether it becomes a leaf.
std::vector<std::uint8_t> QuadtreeTopology::collapsing(QuadtreeBalance balance) const {
  std::array<std::vector<Index>, kMortonDepth> by_depth;
  for (Index i = 0; i < splits_.size(); ++i) by_depth[depth_[i]].push_back(i);
  std::vector<std::uint8_t> result(splits_.size(), 0);
  for (auto boxes = by_depth.rbegin(); boxes != by_depth.rend(); ++boxes)
    for (const Index i : *boxes) result[i] = may_collapse(splits_[i], balance, result);
  return result;
}

Quadtree coarsened(const Quadtree& tree, const QuadtreeTopology& topology,
                   QuadtreeBalance balance) {
  const std::vector<std::uint8_t> collapsing = topology.collapsing(balance);
  std::vector<MortonCode> starts;
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf) {
    const bool vanishes = topology.quarter_[leaf] != 0 && collapsing[topology.parent_[leaf]];
    if (!vanishes) starts.push_back(tree.start(leaf));
  }
  return Quadtree(tree.square(), std::move(starts));
}

}  // namespace wellspaced
