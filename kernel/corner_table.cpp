#include "wellspaced/kernel/corner_table.hpp"

#include <algorithm>

#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {
namespace {

using TableCorner = CornerTable::Corner;

bool has_next(std::span<const TableCorner> corners, Index node) {
  return any_of(corners, [=](TableCorner c) { return c.next == node; });
}

bool has_previous(std::span<const TableCorner> corners, Index node) {
  return any_of(corners, [=](TableCorner c) { return c.previous == node; });
}

}  // namespace

bool CornerTable::has_edge(Index v, Index to) const { return has_next(at(v), to); }

Index CornerTable::next_boundary_node(Index u, Index v) const {
  const std::span<const TableCorner> fan = at(v);
  Index turned = u;
  for (std::size_t step = 0; step < fan.size(); ++step) {
    const auto corner =
        std::find_if(fan.begin(), fan.end(), [=](TableCorner c) { return c.previous == turned; });
    if (corner == fan.end()) return kNoIndex;
    turned = corner->next;
    if (!has_previous(fan, turned)) return turned;
  }
  return kNoIndex;
}

CornerTable corner_table(std::span<const std::array<Index, 3>> triangles, Index nodes) {
  CornerTable table;
  // first[v + 1] is the free place of v until all of its corners are in.
  std::vector<Index>& first = table.first;
  first.assign(std::size_t{nodes} + 2, 0);
  for (const auto& t : triangles)
    for (const Index v : t) ++first[v + 2];
  for (Index v = 0; v < nodes; ++v) first[v + 2] += first[v + 1];

  table.corners.resize(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    table.corners[first[a + 1]++] = {b, c};
    table.corners[first[b + 1]++] = {c, a};
    table.corners[first[c + 1]++] = {a, b};
  }
  first.pop_back();
  return table;
}

std::vector<std::array<Index, 2>> boundary_edges(const CornerTable& table) {
  std::vector<std::array<Index, 2>> edges;
  for (Index v = 0; v < table.nodes(); ++v) {
    const std::span<const TableCorner> corners = table.at(v);
    for (const TableCorner corner : corners)
      if (!has_previous(corners, corner.next)) edges.push_back({v, corner.next});
  }
  return edges;
}

}  // namespace wellspaced
