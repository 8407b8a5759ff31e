#include "wellspaced/io/formats/surface.hpp"

#include <algorithm>
#include <utility>

namespace wellspaced {

void add_face(Geometry& geometry, std::vector<Index> corners, int marker) {
  if (corners.size() == 2) geometry.solid.segments.push_back({corners[0], corners[1], marker});
  if (corners.size() < 3) return;
  Pls::Facet facet;
  facet.polygons.push_back(std::move(corners));
  facet.marker = marker;
  add_facet(geometry, std::move(facet));
}

void for_each_face(const Geometry& geometry,
                   const std::function<void(std::span<const Index>, int)>& visit) {
  for (const TetMesh::Facet& facet : geometry.solid.facets) visit(facet.points, facet.marker);
  for (const Pls::Facet& facet : geometry.polygons) visit(facet.polygons[0], facet.marker);
}

Status write_surface(OutputSet& outputs, const std::string& path, const Geometry& geometry,
                     const std::string& what,
                     const std::function<void(TextWriter&, const Geometry&)>& write) {
  const auto refuse = [&](const char* why) {
    return Error{ErrorCode::kUsage, {path, ": ", what, " has no place for ", why}};
  };
  if (!geometry.solid.tets.empty()) return refuse("tetrahedra; write .mesh, .msh or .vtu");
  const bool simple =
      std::all_of(geometry.polygons.begin(), geometry.polygons.end(),
                  [](const Pls::Facet& f) { return f.polygons.size() == 1 && f.holes.empty(); });
  if (!simple) return refuse("facets with holes or several polygons; write .poly");
  const Geometry lifted = lift_to_space(geometry);
  return outputs.add(path, [&](TextWriter& out) { write(out, lifted); });
}

}  // namespace wellspaced
