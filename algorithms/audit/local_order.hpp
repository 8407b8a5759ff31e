// Reorders a mesh so that what is near in the plane is near in memory. Auditors pass over a mesh
// many times; in the order of the file they would wait for memory most of the time.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// mesh: the points, triangles and segments, points along a Morton curve, triangles by their lowest
///   node; corners keep their cyclic order and segments their numbers. Point markers and fixed
///   nodes are left out.
/// given_node, given_triangle: for each node and triangle of `mesh` its number in the mesh given.
/// local_node: for each node given its number in `mesh`.
struct LocalOrder {
  TriangleMesh mesh;
  std::vector<Index> given_node, given_triangle, local_node;
};

/// Requires: indices in range, finite coordinates. Cost: linear; 60 bytes a triangle.
LocalOrder local_order(const TriangleMesh& mesh);

/// The same for a tetrahedral mesh: tets by their lowest node, facets and segments with their
/// numbers.
struct TetLocalOrder {
  TetMesh mesh;
  std::vector<Index> given_node, given_tet;
};

/// Requires: indices in range, finite coordinates. Cost: linear; 80 bytes a tet.
TetLocalOrder local_order(const TetMesh& mesh);

}  // namespace wellspaced::audit
