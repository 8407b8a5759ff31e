// The special points F: the nodes that coarsening never drops.
#pragma once

#include <vector>

#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The special points of a mesh where none are given: the nodes where the boundary turns by more
/// than 30 degrees, where markers change, where other than two boundary edges meet; and on each
/// closed loop that has fewer than 3 of these, as many of its farthest points as make 3 (4 on an
/// outer boundary). Boundary edges are the segments and the edges with a triangle on one side.
/// Returns: ascending node numbers.
/// Cost: O(b log b) for b boundary nodes, after a pass over the mesh.
/// See: section 8.2, CHOICES 6.
std::vector<Index> automatic_special_points(const TriangleMesh& mesh, const Skeleton& skeleton);

/// For each of mesh.fixed the distance of the nearest other one elsewhere; infinite if there is
/// none.
std::vector<double> special_point_distances(const TriangleMesh& mesh);

}  // namespace wellspaced
