// The seeds of holes in the files that commands write.
#pragma once

#include <string>

#include "wellspaced/io/cli/session.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"

namespace wellspaced::cli {

/// Removes the seeds that lie in or on a triangle, and says so: a file with them would call a hole
/// what is none. rule: by which the mesh was made of the domain in the file `name`.
/// Requires: counter-clockwise triangles.
/// Cost: O(n log h) for n triangles and h seeds.
void leave_out_filled_holes(const std::string& name, HoleRule rule, Session& session,
                            Geometry& geometry);

}  // namespace wellspaced::cli
