#include "wellspaced/kernel/space/vertex_inserter3.hpp"

#include <functional>
#include <numeric>

#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {

Status VertexInserter3::insert(Triangulation3& topology, std::span<const Point3> points, Index v,
                               Index t, Index max_tets) {
  search.run(topology, points, t, points[v], cavity);
  return fill(topology, v, max_tets);
}

// Which tets Triangulation3::remove gives another number, in its order.
static void note_moves(std::vector<Index> dead, Index size,
                       std::vector<VertexInserter3::Move>& moves) {
  sort(dead, std::greater<>());
  for (const Index hole : dead)
    if (hole != --size) moves.push_back({size, hole});
}

Status VertexInserter3::fill(Triangulation3& topology, Index v, Index max_tets) {
  auto& tets = cavity.tets;
  const std::size_t old_tets = tets.size(), new_tets = cavity.rim.size();
  if (topology.size() - old_tets + new_tets > max_tets)
    return Error{ErrorCode::kLimit, {"more than ", max_tets, " tets"}, {}};
  if (old_tets < new_tets) {
    tets.resize(new_tets);
    std::iota(tets.begin() + static_cast<std::ptrdiff_t>(old_tets), tets.end(),
              topology.append(new_tets - old_tets));
  }
  filler.fill(topology, cavity, v);
  moves.clear();
  if (new_tets < old_tets) {
    note_moves({tets.begin() + static_cast<std::ptrdiff_t>(new_tets), tets.end()}, topology.size(),
               moves);
    topology.remove(std::span(tets).subspan(new_tets));
    std::erase_if(tets, [&](Index tet) { return tet >= topology.size(); });
  }
  return Ok{};
}

}  // namespace wellspaced
