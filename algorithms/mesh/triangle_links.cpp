#include "wellspaced/algorithms/mesh/triangle_links.hpp"

namespace wellspaced {
namespace {

bool has_directed_edge(const std::array<Index, 3>& t, Index from, Index to) {
  return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
         (t[2] == from && t[0] == to);
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

  for (Index t = 0; t < triangles.size(); ++t) {
    for (unsigned i = 0; i < 3; ++i) {
      const Index from = triangles[t][(i + 1) % 3], to = triangles[t][(i + 2) % 3];
      neighbors_[t][i] = kNoIndex;
      for (const Index other : around(from))
        if (has_directed_edge(triangles[other], to, from)) neighbors_[t][i] = other;
    }
  }
}

}  // namespace wellspaced
