// The boundary description B behind a mesh: its straight segments and their end-points.
#pragma once

#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The graph B that a mesh discretizes, as far as the mesh tells.
///
/// vertices: its end-points and points, as node numbers, ascending: the nodes where the boundary
///   turns, be it ever so little, where markers change, where other than two segments meet, and
///   the nodes in no edge. graph.points[i] is vertices[i].
/// graph.segments: the straight chains of mesh segments between them, each with its marker.
struct BoundaryDescription {
  std::vector<Index> vertices;
  Pslg graph;
};

/// mesh: its segments are complete, as those of a Level are.
/// Straightness is decided exactly: a slanting segment whose nodes were rounded off its line is a
/// chain of short segments, and cannot be coarsened without changing B.
/// Cost: O(s log s) for s segments, and a pass over the mesh. See: sections 2.1 and 7.4.
BoundaryDescription boundary_description(const TriangleMesh& mesh);

}  // namespace wellspaced
