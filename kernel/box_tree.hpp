// A static tree of axis-parallel boxes: which of them meet a given box?
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A closed axis-parallel box.
struct Box2 {
  Point2 low, high;

  /// The smallest box around some points. Requires: at least one point.
  static Box2 around(std::span<const Point2> points) {
    Box2 box{points[0], points[0]};
    for (const Point2 p : points) box.cover({p, p});
    return box;
  }
  void cover(const Box2& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
  }
  bool meets(const Box2& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
};

/// The distance of x from the nearest point of a box.
inline double distance_to_box(const Box2& box, Point2 x) {
  return distance(x,
                  {std::clamp(x.x, box.low.x, box.high.x), std::clamp(x.y, box.low.y, box.high.y)});
}

/// Boxes sorted into a complete binary tree of blocks by alternate halving; every node of the tree
/// keeps the box around those below it.
/// Cost: O(n log n) to build; a query O(log n + answers) for boxes that overlap few others.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box2> boxes);

  /// Calls visit(i) for each box i that meets `query`, in no particular order.
  template <class Visit>
  void for_each_meeting(const Box2& query, Visit visit) const {
    if (!order_.empty()) descend(query, {1, 0, order_.size()}, visit);
  }

 private:
  static constexpr std::size_t kBlock = 4;
  struct Range {
    std::size_t node, first, last;  // node k has the children 2k and 2k + 1
    std::size_t middle() const { return first + (last - first) / 2; }
    bool is_block() const { return last - first <= kBlock; }
    Range lower() const { return {2 * node, first, middle()}; }
    Range upper() const { return {2 * node + 1, middle(), last}; }
  };

  void build(Range range);

  // Recursion is as deep as the tree, log2 n.
  template <class Visit>
  void descend(const Box2& query, Range range, Visit& visit) const {
    if (!around_[range.node].meets(query)) return;
    if (!range.is_block()) {
      descend(query, range.lower(), visit);
      descend(query, range.upper(), visit);
      return;
    }
    for (std::size_t i = range.first; i < range.last; ++i)
      if (boxes_[order_[i]].meets(query)) visit(order_[i]);
  }

  std::vector<Box2> boxes_;
  std::vector<std::size_t> order_;
  std::vector<Box2> around_;
};

inline BoxTree::BoxTree(std::vector<Box2> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::size_t leaves = 1;
  while (leaves * kBlock < boxes_.size()) leaves *= 2;
  around_.resize(2 * leaves);
  if (!boxes_.empty()) build({1, 0, boxes_.size()});
}

inline void BoxTree::build(Range range) {
  Box2 around = boxes_[order_[range.first]];
  for (std::size_t i = range.first; i < range.last; ++i) around.cover(boxes_[order_[i]]);
  around_[range.node] = around;
  if (range.is_block()) return;
  const bool wide = around.high.x - around.low.x > around.high.y - around.low.y;
  const auto key = [&](std::size_t i) {
    const Box2& box = boxes_[i];
    return wide ? box.low.x / 2 + box.high.x / 2 : box.low.y / 2 + box.high.y / 2;
  };
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(range.first);
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(range.middle() - range.first),
                   begin + static_cast<std::ptrdiff_t>(range.last - range.first),
                   [&](std::size_t a, std::size_t b) {
                     const double ka = key(a), kb = key(b);
                     return ka < kb || (ka == kb && a < b);
                   });
  build(range.lower());
  build(range.upper());
}

}  // namespace wellspaced
