// What the readers and writers of surfaces share.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "wellspaced/io/files/output_set.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Adds a face of a surface: of one corner it is nothing, of two a segment, of more a facet.
void add_face(Geometry& geometry, std::vector<Index> corners, int marker);

/// Calls `visit` with the corners and the marker of each facet.
/// Requires: no facet has holes or several polygons.
void for_each_face(const Geometry& geometry,
                   const std::function<void(std::span<const Index>, int)>& visit);

/// Writes `geometry` with `write`, which gets it lifted to space, if it is nothing but a surface.
/// Errors: kUsage for tetrahedra, and for facets with holes or several polygons; as
/// OutputSet::add(). `what` names the format in messages.
Status write_surface(OutputSet& outputs, const std::string& path, const Geometry& geometry,
                     const std::string& what,
                     const std::function<void(TextWriter&, const Geometry&)>& write);

}  // namespace wellspaced
