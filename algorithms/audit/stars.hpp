// The half-edges around each node, listed by node.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// For each node the half-edges that leave it, one for each triangle around it, in no special
/// order.
class Stars {
 public:
  /// Requires: indices in range. Cost: linear.
  Stars(std::span<const std::array<Index, 3>> triangles, std::size_t nodes)
      : triangles_(triangles), first_(nodes + 1, 0), leaving_(3 * triangles.size()) {
    for (const auto& t : triangles)
      for (const Index v : t) ++first_[v];
    Index sum = 0;
    for (Index& first : first_) first = sum += first;
    Index h = 0;
    for (const auto& t : triangles)
      for (const Index v : t) leaving_[--first_[v]] = h++;
  }

  std::span<const Index> leaving(Index v) const {
    return {leaving_.data() + first_[v], leaving_.data() + first_[v + 1]};
  }

  /// Calls visit(neighbour, half-edge that joins them, in either direction); a neighbour across an
  /// inner edge is visited twice.
  template <class Visit>
  void for_each_neighbor(Index v, Visit visit) const {
    for (const Index h : leaving(v)) {
      visit(target(triangles_, h), h);
      visit(apex(triangles_, h), HalfEdges::previous(h));
    }
  }

 private:
  std::span<const std::array<Index, 3>> triangles_;
  std::vector<Index> first_;
  LargeVector<Index> leaving_;
};

}  // namespace wellspaced::audit
