// The largest 1-Lipschitz function with given values at points, and the distance from the points.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"

namespace wellspaced::audit {

/// Points p with values f_p >= 0, under a balanced tree of boxes that know the least and the
/// largest value below them. They define the function f(x) = min over p of f_p + |x - p|: of all
/// functions that are 1-Lipschitz and at most f_p at every p, the largest. Distances are computed
/// in floating point, to a few units in the last place.
/// Requires: coordinates and values below 2^100.
/// Cost: O(n log n) to build; a query is O(log n) for points that are spread out.
template <std::size_t D>
class SpacingTree {
 public:
  struct Found {
    Index node = kNoIndex;
    double value = std::numeric_limits<double>::infinity();
  };

  SpacingTree(std::span<const Vec<D>> places, std::span<const double> values)
      : nodes_(places.empty() ? 0 : 2 * leaves(places.size()) - 1) {
    sites_.reserve(places.size());
    for (Index i = 0; i < places.size(); ++i) sites_.push_back({places[i], values[i], i});
    if (!sites_.empty()) build(0, 0, sites_.size());
  }

  using SiteBox = Box<static_cast<int>(D)>;

  /// The point for which value(place, f) is least, and that value, if it is below `start`.
  /// bound(box, least): what no point in the box with a value of `least` or more falls below.
  template <class Bound, class Value>
  Found minimise(Bound bound, Value value, double start) const {
    return least([&](const Node& node) { return bound(node.box, node.least); },
                 [&](const Site& site) { return value(site.place, site.value); }, start);
  }

  /// The point nearest to x, other than `except`, and its distance.
  Found nearest(const Vec<D>& x, Index except = kNoIndex) const {
    return least([&](const Node& node) { return distance_to(node.box, x); },
                 [&](const Site& site) {
                   return site.number == except ? kNone : distance_of(site.place, x);
                 });
  }

  /// The least value of f in the ball of radius r around c, and the point that it comes from.
  Found least_within(const Vec<D>& c, double r) const {
    const auto beyond = [r](double distance) { return std::max(0.0, distance - r); };
    return least([&](const Node& node) { return node.least + beyond(distance_to(node.box, c)); },
                 [&](const Site& site) { return site.value + beyond(distance_of(site.place, c)); });
  }

  /// f(x), and the point that it comes from.
  Found at(const Vec<D>& x) const { return least_within(x, 0); }

  /// The point q for which (value + f_q) / |x - q| is largest, other than `except`, and that ratio,
  /// if it exceeds `bound`.
  Found most_crowded(const Vec<D>& x, double value, Index except, double bound) const {
    Found found =
        least([&](const Node& node) { return -(value + node.largest) / distance_to(node.box, x); },
              [&](const Site& site) {
                if (site.number == except) return kNone;
                return -(value + site.value) / distance_of(site.place, x);
              },
              -bound);
    found.value = -found.value;
    return found;
  }

  /// How far x is from a box.
  static double distance_to(const SiteBox& box, const Vec<D>& x) {
    Vec<D> v;
    for (std::size_t i = 0; i < D; ++i)
      v[i] = std::max({box.low[i] - x[i], x[i] - box.high[i], 0.0});
    return norm(v);
  }

 private:
  static constexpr std::size_t kLeaf = 6;
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  struct Site {
    Vec<D> place;
    double value;
    Index number;
  };
  struct Node {
    SiteBox box;
    double least = kNone, largest = 0;
  };

  static std::size_t leaves(std::size_t sites) {
    std::size_t count = 1;
    while (sites > count * kLeaf) count *= 2;
    return count;
  }

  // Recursion is as deep as the tree, log2 n.
  void build(std::size_t number, std::size_t first, std::size_t last) {
    Node& node = nodes_[number];
    node.box = {sites_[first].place, sites_[first].place};
    for (std::size_t i = first; i < last; ++i) {
      node.box.grow({sites_[i].place, sites_[i].place});
      node.least = std::min(node.least, sites_[i].value);
      node.largest = std::max(node.largest, sites_[i].value);
    }
    if (last - first <= kLeaf) return;
    std::size_t axis = 0;
    for (std::size_t i = 1; i < D; ++i)
      if (node.box.high[i] - node.box.low[i] > node.box.high[axis] - node.box.low[axis]) axis = i;
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(sites_.begin() + static_cast<std::ptrdiff_t>(first),
                     sites_.begin() + static_cast<std::ptrdiff_t>(middle),
                     sites_.begin() + static_cast<std::ptrdiff_t>(last),
                     [axis](const Site& a, const Site& b) {
                       return a.place[axis] != b.place[axis] ? a.place[axis] < b.place[axis]
                                                             : a.number < b.number;
                     });
    build(2 * number + 1, first, middle);
    build(2 * number + 2, middle, last);
  }

  // The site of least value, if that is below `start`; bound(node): what no site below is less
  // than.
  template <class Bound, class Value>
  Found least(Bound bound, Value value, double start = kNone) const {
    struct Range {
      std::size_t node, first, last;
      double bound;
    };
    Found best{kNoIndex, start};
    std::array<Range, 72> stack;
    std::size_t size = 0;
    const auto push = [&](std::size_t node, std::size_t first, std::size_t last) {
      stack[size++] = {node, first, last, bound(nodes_[node])};
    };
    if (!sites_.empty()) push(0, 0, sites_.size());
    while (size > 0) {
      const Range range = stack[--size];
      if (!(range.bound < best.value)) continue;
      if (range.last - range.first <= kLeaf) {
        for (std::size_t i = range.first; i < range.last; ++i)
          if (const double v = value(sites_[i]); v < best.value) best = {sites_[i].number, v};
        continue;
      }
      const std::size_t middle = range.first + (range.last - range.first) / 2;
      push(2 * range.node + 1, range.first, middle);
      push(2 * range.node + 2, middle, range.last);
      if (stack[size - 1].bound > stack[size - 2].bound)
        std::swap(stack[size - 1], stack[size - 2]);
    }
    return best;
  }

  std::vector<Site> sites_;
  std::vector<Node> nodes_;
};

}  // namespace wellspaced::audit
