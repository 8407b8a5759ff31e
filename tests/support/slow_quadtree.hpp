// Quadtrees by definition: sets of boxes with whole-number corners, searched in full.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <set>
#include <tuple>
#include <vector>

#include "wellspaced/kernel/plane/quadtree.hpp"

namespace wellspaced::test {

// In cells of the deepest grid.
struct SlowBox {
  std::int64_t x = 0, y = 0, side = 0;

  auto order() const { return std::tuple(side, x, y); }
  bool operator<(const SlowBox& other) const { return order() < other.order(); }
  bool operator==(const SlowBox& other) const { return order() == other.order(); }

  SlowBox parent() const {
    return {x / (2 * side) * 2 * side, y / (2 * side) * 2 * side, 2 * side};
  }
  std::vector<SlowBox> quarters() const {
    const std::int64_t h = side / 2;
    return {{x, y, h}, {x + h, y, h}, {x, y + h, h}, {x + h, y + h, h}};
  }
};

// How long the common part of two closed boxes is along one axis; negative where they are apart.
inline std::int64_t overlap(std::int64_t a, std::int64_t a_side, std::int64_t b,
                            std::int64_t b_side) {
  return std::min(a + a_side, b + b_side) - std::max(a, b);
}

inline bool are_extended_neighbors(const SlowBox& a, const SlowBox& b) {
  return !(a == b) && overlap(a.x, a.side, b.x, b.side) >= 0 &&
         overlap(a.y, a.side, b.y, b.side) >= 0;
}

inline bool are_neighbors(const SlowBox& a, const SlowBox& b) {
  return are_extended_neighbors(a, b) &&
         (overlap(a.x, a.side, b.x, b.side) > 0 || overlap(a.y, a.side, b.y, b.side) > 0);
}

inline bool touch(const SlowBox& a, const SlowBox& b, QuadtreeBalance balance) {
  return balance == QuadtreeBalance::kEdge ? are_neighbors(a, b) : are_extended_neighbors(a, b);
}

inline SlowBox slow_box(const Quadtree& tree, Index leaf) {
  return {morton::column(tree.start(leaf)), morton::row(tree.start(leaf)),
          std::int64_t{1} << (kMortonDepth - tree.depth(leaf))};
}

inline std::vector<SlowBox> slow_boxes(const Quadtree& tree) {
  std::vector<SlowBox> boxes;
  for (Index leaf = 0; leaf < tree.leaves(); ++leaf) boxes.push_back(slow_box(tree, leaf));
  return boxes;
}

inline bool is_balanced(const Quadtree& tree, QuadtreeBalance balance) {
  const auto boxes = slow_boxes(tree);
  for (const SlowBox& a : boxes)
    for (const SlowBox& b : boxes)
      if (touch(a, b, balance) && a.side > 2 * b.side) return false;
  return true;
}

// Splits boxes while the predicate asks for it, then those with a too-small neighbour, one by one.
inline std::set<SlowBox> slow_quadtree(const std::function<bool(const SlowBox&)>& must_split,
                                       QuadtreeBalance balance) {
  std::set<SlowBox> leaves;
  std::vector<SlowBox> todo{{0, 0, std::int64_t{1} << kMortonDepth}};
  while (!todo.empty()) {
    const SlowBox box = todo.back();
    todo.pop_back();
    if (box.side > 1 && must_split(box))
      for (const SlowBox& quarter : box.quarters()) todo.push_back(quarter);
    else
      leaves.insert(box);
  }
  const auto too_large = [&] {
    return std::find_if(leaves.begin(), leaves.end(), [&](const SlowBox& a) {
      return std::any_of(leaves.begin(), leaves.end(), [&](const SlowBox& b) {
        return a.side > 2 * b.side && touch(a, b, balance);
      });
    });
  };
  for (auto box = too_large(); box != leaves.end(); box = too_large()) {
    const auto quarters = box->quarters();
    leaves.erase(box);
    leaves.insert(quarters.begin(), quarters.end());
  }
  return leaves;
}

// QUADTREE_COARSEN step by step, as Figure 5.14 has it but for its erratum.
inline std::set<SlowBox> slow_coarsened(const Quadtree& tree, QuadtreeBalance balance) {
  const auto boxes = slow_boxes(tree);
  std::set<SlowBox> result(boxes.begin(), boxes.end()), done;
  const std::vector<SlowBox> by_size(result.begin(), result.end());
  for (const SlowBox& box : by_size) {
    if (done.contains(box)) continue;
    const auto siblings = box.parent().quarters();
    const auto may_go = [&](const SlowBox& sibling) {
      return result.contains(sibling) && !done.contains(sibling) &&
             std::none_of(result.begin(), result.end(), [&](const SlowBox& other) {
               return other.side < sibling.side && touch(sibling, other, balance);
             });
    };
    if (by_size.size() == 1 || !std::all_of(siblings.begin(), siblings.end(), may_go)) {
      done.insert(box);
      continue;
    }
    for (const SlowBox& sibling : siblings) result.erase(sibling), done.insert(sibling);
    result.insert(box.parent());
    done.insert(box.parent());
  }
  return result;
}

}  // namespace wellspaced::test
