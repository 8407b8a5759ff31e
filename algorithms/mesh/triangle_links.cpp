#include "wellspaced/algorithms/mesh/triangle_links.hpp"

namespace wellspaced {
namespace {

// The corner that faces the directed edge, 3 if the triangle has no such edge.
unsigned corner_opposite(const std::array<Index, 3>& t, Index from, Index to) {
  for (unsigned i = 0; i < 3; ++i)
    if (t[(i + 1) % 3] == from && t[(i + 2) % 3] == to) return i;
  return 3;
}

}  // namespace

TriangleLinks::TriangleLinks(std::span<const std::array<Index, 3>> triangles, Index nodes)
    : neighbors_(triangles.size()), first_(std::size_t{nodes} + 2, 0) {
  for (const auto& triangle : triangles)
    for (const Index v : triangle) ++first_[v + 2];
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  around_.resize(3 * triangles.size());
  for (Index t = 0; t < triangles.size(); ++t)
    for (const Index v : triangles[t]) around_[first_[v + 1]++] = t;
  first_.pop_back();

  for (auto& neighbors : neighbors_) neighbors.fill(kNoIndex);
  for (Index t = 0; t < triangles.size(); ++t) {
    for (unsigned i = 0; i < 3; ++i) {
      if (neighbors_[t][i] != kNoIndex) continue;
      const Index from = triangles[t][(i + 1) % 3], to = triangles[t][(i + 2) % 3];
      for (const Index other : around(from)) {
        const unsigned j = corner_opposite(triangles[other], to, from);
        if (j == 3) continue;
        neighbors_[t][i] = other;
        neighbors_[other][j] = t;
      }
    }
  }
}

}  // namespace wellspaced
