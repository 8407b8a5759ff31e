// What a step of coarsening reads off a mesh: its edges, around nodes and as a graph, its boundary.
#pragma once

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/kernel/corner_table.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

struct Skeleton {
  CornerTable corners;
  Graph graph;
  Boundary boundary;
};

/// Cost: linear but for sorting the boundary. Requires: as boundary_of().
inline Skeleton skeleton_without_graph(const TriangleMesh& mesh) {
  Skeleton skeleton;
  skeleton.corners = corner_table(mesh.triangles, static_cast<Index>(mesh.points.size()));
  skeleton.boundary = boundary_of(mesh, skeleton.corners);
  return skeleton;
}

/// The same, whole. The graph takes four times the memory of the triangles.
inline Skeleton skeleton_of(const TriangleMesh& mesh) {
  Skeleton skeleton = skeleton_without_graph(mesh);
  skeleton.graph = mesh_graph(mesh.points, skeleton.corners, mesh.segments);
  return skeleton;
}

}  // namespace wellspaced
