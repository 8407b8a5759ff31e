// The special points F: the nodes that coarsening never drops.
#pragma once

#include <span>
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

/// Special points that are few, so that coarse levels have room for good angles, and yet keep the
/// outline: as above, but corners turn by more than 60 degrees; then the farthest pair of a loop
/// with fewer than 2 of them, and by Douglas and Peucker's rule the points farther than 0.15 of
/// the loop's diameter from the line between those before and after; at last at least 3 on a loop.
std::vector<Index> outline_special_points(const TriangleMesh& mesh, const Skeleton& skeleton);

/// The given nodes, and on each closed loop with fewer than 3 of them its farthest points, as
/// above. Returns: ascending node numbers.
std::vector<Index> completed_special_points(const TriangleMesh& mesh, const Skeleton& skeleton,
                                            std::span<const Index> given);

/// For each of mesh.fixed the distance of the nearest other one elsewhere; infinite if there is
/// none.
std::vector<double> special_point_distances(const TriangleMesh& mesh);

}  // namespace wellspaced
