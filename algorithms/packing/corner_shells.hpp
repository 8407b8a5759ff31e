// Corners of a domain that are too sharp: found, reported, and cut off by shells.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"

namespace wellspaced {

/// Two segments that leave a vertex with nothing of the graph, but some of the domain, between.
/// left is the next one counter-clockwise from right.
struct Corner {
  Index apex = 0, right = 0, left = 0;  ///< vertices
  double cosine = 1;
};

/// The corners whose angle within the domain is below 60 degrees (by more than the rounding of
/// coordinates can make of an exact 60: their cosine exceeds 1/2 + 1e-9), by apex.
/// Cost: linear.
std::vector<Corner> sharp_corners(const PlanarTriangulation& graph);

}  // namespace wellspaced
