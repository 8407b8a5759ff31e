// What a search by increasing distance has before it.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A node of a tree of items, counted from 1, with the items below it; or, with node 0, one item.
struct Pending {
  double distance_sq;
  Index node, first, last;
};

/// Gives back what was put into it, the nearest first, the lower item of two that are equally far.
/// Most searches take no memory but this object. Cost: O(log n) each.
class DistanceQueue {
 public:
  DistanceQueue();

  bool empty() const { return heap_.empty(); }
  void push(const Pending& pending);
  /// Requires: !empty().
  Pending pop();

 private:
  std::array<std::byte, 8192> buffer_;  // more than most searches need
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::vector<Pending> heap_;
};

}  // namespace wellspaced
