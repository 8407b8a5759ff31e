#include "wellspaced/kernel/space/star_filler3.hpp"

#include <algorithm>
#include <bit>

// A new tet is a facet of the rim joined to the apex. Two new tets are neighbours where their rim
// facets share an edge, along which one runs from k to l and the other from l to k. The vertices of
// the rim get small numbers, slots; a table over ordered pairs of slots finds the other facet.

namespace wellspaced {
namespace {

// A square table over the slots, for few of them: it stays in the nearest cache. What an earlier
// cavity left in it is never read.
struct SquareTable {
  static constexpr std::size_t kMaxSlots = 64;
  std::uint32_t* links;
  unsigned log_side;

  std::uint32_t& at(Index from, Index to) const {
    return links[std::size_t{from} << log_side | to];
  }
};

// A hash table with linear probing, for any number of slots.
struct HashTable {
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  std::uint64_t* keys;
  std::uint32_t* links;
  std::size_t mask;

  std::uint32_t& at(Index from, Index to) const {
    const std::uint64_t key = std::uint64_t{from} << 32 | to;
    std::size_t i = (key * 0x9E3779B97F4A7C15u) >> 32 & mask;
    while (keys[i] != key && keys[i] != kFree) i = (i + 1) & mask;
    keys[i] = key;
    return links[i];
  }
};

}  // namespace

// Whether a vertex was met before cannot be predicted, so nothing branches on it.
void StarFiller3::number_rim_vertices(std::span<const RimFacet> rim) {
  if (next_number_ > kNoIndex / 2) {
    std::fill(number_of_vertex_.begin(), number_of_vertex_.end(), 0);
    next_number_ = 1;
  }
  rim_slots_.resize(rim.size());
  const Index first = next_number_;
  Index next = first;
  for (std::size_t r = 0; r < rim.size(); ++r) {
    const auto& corners = Triangulation3::kFacetCorners[rim[r].corner];
    for (unsigned e = 0; e < 3; ++e) {
      Index& number = number_of_vertex_[static_cast<Index>(rim[r].vertex[corners[e]] + 1)];
      const Index is_new = number < first;
      number += (next - number) * is_new;
      next += is_new;
      rim_slots_[r][e] = number - first;
    }
  }
  next_number_ = next;
}

// Puts a tet on every rim facet, links it to the outside and to its three neighbours in the star.
template <class Table>
void StarFiller3::join(Triangulation3& topology, const Triangulation3::Cavity& cavity,
                       Table table) {
  auto& tets = topology.tets_;
  const auto& rim = cavity.rim;
  for (std::size_t r = 0; r < rim.size(); ++r) {
    const auto& c = Triangulation3::kFacetCorners[rim[r].corner];
    const auto& s = rim_slots_[r];
    const Index t = cavity.tets[r];
    tets[t].vertex = rim[r].vertex;
    tets[t].link[rim[r].corner] = rim[r].outside;
    tets[rim[r].outside >> 2].link[rim[r].outside & 3] = Triangulation3::pack(t, rim[r].corner);
    table.at(s[1], s[2]) = Triangulation3::pack(t, c[0]);
    table.at(s[2], s[0]) = Triangulation3::pack(t, c[1]);
    table.at(s[0], s[1]) = Triangulation3::pack(t, c[2]);
  }
  for (std::size_t r = 0; r < rim.size(); ++r) {
    const auto& c = Triangulation3::kFacetCorners[rim[r].corner];
    const auto& s = rim_slots_[r];
    auto& link = tets[cavity.tets[r]].link;
    link[c[0]] = table.at(s[2], s[1]);
    link[c[1]] = table.at(s[0], s[2]);
    link[c[2]] = table.at(s[1], s[0]);
  }
}

void StarFiller3::fill(Triangulation3& topology, Triangulation3::Cavity& cavity, Index apex) {
  const std::size_t new_tets = cavity.rim.size();
  number_rim_vertices(cavity.rim);
  for (RimFacet& facet : cavity.rim) facet.vertex[facet.corner] = apex;
  const std::size_t slots = new_tets / 2 + 2;  // Euler's formula for the rim
  if (slots <= SquareTable::kMaxSlots) {
    edge_links_.resize(
        std::max(edge_links_.size(), SquareTable::kMaxSlots * SquareTable::kMaxSlots));
    join(topology, cavity, SquareTable{edge_links_.data(), slots <= 32 ? 5u : 6u});
  } else {
    const std::size_t capacity = std::bit_ceil(6 * new_tets);
    edge_keys_.assign(capacity, HashTable::kFree);
    edge_links_.resize(std::max(edge_links_.size(), capacity));
    join(topology, cavity, HashTable{edge_keys_.data(), edge_links_.data(), capacity - 1});
  }
}

}  // namespace wellspaced
