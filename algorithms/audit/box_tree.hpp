// A balanced tree of boxes, to find which of many items may meet a given one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// A closed axis-parallel box.
template <int D>
struct Box {
  std::array<double, D> low, high;

  void grow(const Box& other) {
    for (int i = 0; i < D; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
};

inline Box<2> box_of(Point2 p) { return {{p.x, p.y}, {p.x, p.y}}; }
inline Box<3> box_of(Point3 p) { return {{p.x, p.y, p.z}, {p.x, p.y, p.z}}; }

/// The smallest box around some points.
template <class Point, class... More>
auto box_of(Point p, More... more) {
  auto box = box_of(p);
  (box.grow(box_of(more)), ...);
  return box;
}

/// Whether two boxes have a point in common.
template <int D>
bool touch(const Box<D>& a, const Box<D>& b) {
  for (int i = 0; i < D; ++i)
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  return true;
}

/// Whether the interiors of two boxes have a point in common.
template <int D>
bool overlap(const Box<D>& a, const Box<D>& b) {
  for (int i = 0; i < D; ++i)
    if (a.high[i] <= b.low[i] || b.high[i] <= a.low[i]) return false;
  return true;
}

/// A binary tree over the boxes of items 0 .. n - 1, halved at the median along the widest axis.
/// No arithmetic but halving is done on coordinates, so what it leaves out is truly apart.
/// Cost: O(n log n) to build, 2 * sizeof(Box) + 4 bytes an item.
template <int D>
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box<D>> boxes)
      : order_(boxes.size()), nodes_(boxes.empty() ? 0 : 2 * leaves(boxes.size()) - 1) {
    for (std::size_t i = 0; i < boxes.size(); ++i) order_[i] = static_cast<Index>(i);
    if (!boxes.empty()) build(boxes, 0, 0, boxes.size());
  }

  /// Calls visit(item) for the items in all leaves whose box, and that of every node above,
  /// accept(box) lets pass; visit returns false to end the search.
  template <class Accept, class Visit>
  void search(Accept accept, Visit visit) const {
    struct Range {
      std::size_t node, first, last;
    };
    std::array<Range, 80> stack;
    std::size_t size = 0;
    if (!order_.empty()) stack[size++] = {0, 0, order_.size()};
    while (size > 0) {
      const auto [node, first, last] = stack[--size];
      if (!accept(nodes_[node])) continue;
      if (last - first <= kLeaf) {
        for (std::size_t i = first; i < last; ++i)
          if (!visit(order_[i])) return;
        continue;
      }
      const std::size_t middle = first + (last - first) / 2;
      stack[size++] = {2 * node + 2, middle, last};
      stack[size++] = {2 * node + 1, first, middle};
    }
  }

 private:
  static constexpr std::size_t kLeaf = 4;

  // The leaves, at the same depth or one less; the children of node i are 2i + 1 and 2i + 2.
  static std::size_t leaves(std::size_t items) {
    std::size_t count = 1;
    while (items > count * kLeaf) count *= 2;
    return count;
  }

  void build(std::span<const Box<D>> boxes, std::size_t node, std::size_t first, std::size_t last) {
    Box<D> around = boxes[order_[first]];
    for (std::size_t i = first + 1; i < last; ++i) around.grow(boxes[order_[i]]);
    nodes_[node] = around;
    if (last - first <= kLeaf) return;
    const std::size_t middle = first + (last - first) / 2;
    const int axis = widest_axis(around);
    const auto key = [&](Index i) {
      return std::pair(boxes[i].low[axis] / 2 + boxes[i].high[axis] / 2, i);
    };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](Index i, Index j) { return key(i) < key(j); });
    build(boxes, 2 * node + 1, first, middle);
    build(boxes, 2 * node + 2, middle, last);
  }

  static int widest_axis(const Box<D>& box) {
    int widest = 0;
    const auto width = [&](int axis) { return box.high[axis] / 2 - box.low[axis] / 2; };
    for (int i = 1; i < D; ++i)
      if (width(i) > width(widest)) widest = i;
    return widest;
  }

  std::vector<Index> order_;
  std::vector<Box<D>> nodes_;
};

}  // namespace wellspaced::audit
