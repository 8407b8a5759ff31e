#include "wellspaced/algorithms/mesh/directed_edges.hpp"

#include <algorithm>

namespace wellspaced {
namespace {

std::uint64_t key_of(Index from, Index to) { return std::uint64_t{from} << 32 | to; }

}  // namespace

DirectedEdges::DirectedEdges(std::span<const std::array<Index, 3>> triangles) {
  edges_.reserve(3 * triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    edges_.push_back({key_of(a, b), t});
    edges_.push_back({key_of(b, c), t});
    edges_.push_back({key_of(c, a), t});
  }
  radix_sort(edges_);
}

DirectedEdges::Edge DirectedEdges::edge_of(const KeyedItem& item) {
  return {static_cast<Index>(item.key >> 32), static_cast<Index>(item.key)};
}

Index DirectedEdges::triangle_of(Index from, Index to) const {
  const std::uint64_t key = key_of(from, to);
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), key,
                       [](const KeyedItem& e, std::uint64_t k) { return e.key < k; });
  return found != edges_.end() && found->key == key ? found->item : kNoIndex;
}

bool DirectedEdges::has_edge(Index a, Index b) const {
  return triangle_of(a, b) != kNoIndex || triangle_of(b, a) != kNoIndex;
}

std::optional<DirectedEdges::Conflict> DirectedEdges::find_conflict() const {
  const auto found =
      std::adjacent_find(edges_.begin(), edges_.end(),
                         [](const KeyedItem& a, const KeyedItem& b) { return a.key == b.key; });
  if (found == edges_.end()) return {};
  return Conflict{edge_of(*found), found->item, (found + 1)->item};
}

// The edges that leave one node stand together and ascend. So do the edges that are looked for
// among them, as their opposites come one after the other: a place for each node only moves on.
std::vector<DirectedEdges::Edge> DirectedEdges::boundary() const {
  std::vector<Edge> result;
  if (edges_.empty()) return result;
  std::vector<Index> place(std::size_t{edge_of(edges_.back())[0]} + 1);
  for (std::size_t i = edges_.size(); i-- > 0;)
    place[edge_of(edges_[i])[0]] = static_cast<Index>(i);
  for (const KeyedItem& item : edges_) {
    const Edge edge = edge_of(item);
    const std::uint64_t opposite = key_of(edge[1], edge[0]);
    Index& i = place[edge[1]];
    while (i < edges_.size() && edges_[i].key < opposite) ++i;
    if (i == edges_.size() || edges_[i].key != opposite) result.push_back(edge);
  }
  return result;
}

}  // namespace wellspaced
