#include "wellspaced/kernel/space/vertex_inserter3.hpp"

#include <numeric>
#include <string>

namespace wellspaced {

Status VertexInserter3::insert(Triangulation3& topology, std::span<const Point3> points, Index v,
                               Index t, Index max_tets) {
  search.run(topology, points, t, points[v], cavity);
  auto& tets = cavity.tets;
  const std::size_t old_tets = tets.size(), new_tets = cavity.rim.size();
  if (topology.size() - old_tets + new_tets > max_tets)
    return Error{ErrorCode::kLimit, "more than " + std::to_string(max_tets) + " tets", {}};
  if (old_tets < new_tets) {
    tets.resize(new_tets);
    std::iota(tets.begin() + static_cast<std::ptrdiff_t>(old_tets), tets.end(),
              topology.append(new_tets - old_tets));
  }
  filler.fill(topology, cavity, v);
  if (new_tets < old_tets) {
    topology.remove(std::span(tets).subspan(new_tets));
    std::erase_if(tets, [&](Index tet) { return tet >= topology.size(); });
  }
  return Ok{};
}

}  // namespace wellspaced
