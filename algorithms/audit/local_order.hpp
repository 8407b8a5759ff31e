// Renumbers the nodes of a mesh so that triangles near each other in the list use nodes near each
// other in memory. Auditors pass over the triangles many times; with nodes numbered at random they
// would wait for memory most of the time.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// mesh: points, triangles and segments, the nodes in the order in which the triangles first name
///   them, then those that no triangle names; triangles and segments keep their numbers. Point
///   markers and fixed nodes are left out.
/// given: for each node of `mesh` its number in the mesh given.
/// local: for each node given its number in `mesh`.
struct LocalOrder {
  TriangleMesh mesh;
  std::vector<Index> given, local;
};

/// Requires: indices in range. Cost: linear.
LocalOrder local_order(const TriangleMesh& mesh);

}  // namespace wellspaced::audit
