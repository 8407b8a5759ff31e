#include "wellspaced/algorithms/spacing/quadtree_spacing.hpp"

#include <algorithm>

#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
LeafSpacing::Leaf LeafSpacing::leaf_of(const Quadtree& tree, Index leaf) {
  return {tree.side_at(tree.depth(leaf) + 1), tree.centre(leaf), tree.box(leaf)};
}

LeafSpacing::LeafSpacing(const Quadtree& tree, const QuadtreeTopology& topology, Index leaf)
    : own_(leaf_of(tree, leaf)) {
  topology.for_each_extended_neighbor(
      leaf, [&](Index other) { around_.push_back(leaf_of(tree, other)); });
}

double LeafSpacing::cone_value(Point2 x) const {
  double value = own_.half_side + distance(x, own_.centre);
  for (const Leaf& leaf : around_)
    value = std::min(value, leaf.half_side + distance(x, leaf.centre));
  return value;
}

double LeafSpacing::envelope_value(Point2 x) const {
  double value = own_.half_side;
  for (const Leaf& leaf : around_)
    if (leaf.half_side < value)
      value = std::min(value, leaf.half_side + distance_to_box(leaf.box, x));
  return value;
}

}  // namespace wellspaced
