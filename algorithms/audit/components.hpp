// How many pieces a mesh falls into.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The number of sets of elements that hang together by their sides. twin: for side kSides * e + i
/// of element e the side that it lies on, or kNoIndex. Cost: linear.
template <Index kSides>
std::uint64_t count_components(std::span<const Index> twin) {
  const auto elements = static_cast<Index>(twin.size() / kSides);
  std::vector<std::uint8_t> seen(elements + std::size_t{1}, 0);
  seen[elements] = 1;  // stands for what lies beyond the boundary
  std::vector<Index> queue(elements + std::size_t{1});
  std::uint64_t components = 0;
  std::size_t queued = 0, done = 0;
  for (Index first = 0; first < elements; ++first) {
    if (seen[first] != 0) continue;
    ++components;
    seen[first] = 1;
    queue[queued++] = first;
    for (; done < queued; ++done) {
      for (Index i = 0; i < kSides; ++i) {
        // Queued in any case, and overwritten if it was seen: a branch would be mispredicted.
        const Index next = std::min(twin[kSides * queue[done] + i] / kSides, elements);
        queue[queued] = next;
        queued += seen[next] == 0;
        seen[next] = 1;
      }
    }
  }
  return components;
}

}  // namespace wellspaced::audit
