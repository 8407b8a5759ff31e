// A weighted graph in compressed rows: the 1D skeleton of a mesh with its edge lengths.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/corner_table.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// An undirected graph with weights (Definition 7.1.1): every edge appears as an arc at both ends.
struct Graph {
  struct Arc {
    Index target = 0;
    double length = 0;
  };
  std::vector<Index> first;  ///< one a node and one more: arcs of v are first[v] .. first[v+1]-1
  std::vector<Arc> arcs;

  Index nodes() const { return static_cast<Index>(first.size()) - 1; }
  std::span<const Arc> arcs_of(Index v) const {
    return {arcs.data() + first[v], arcs.data() + first[v + 1]};
  }
};

/// The graph of a mesh: the edges of its triangles, and the segments that lie on none; the length
/// of an edge is the Euclidean distance of its ends.
/// table: the corners of the mesh's triangles, over points.size() nodes.
/// Requires: points.size() < 2^32 - 1, at most 2^32 - 1 arcs; segment ends < points.size().
/// Degenerate: a segment whose ends are equal, or given twice, adds no further arc.
/// Cost: linear for bounded degrees. See: section 7.1.
Graph mesh_graph(std::span<const Point2> points, const CornerTable& table,
                 std::span<const Segment> segments);

/// The same, with a corner table made for the purpose.
Graph mesh_graph(const TriangleMesh& mesh);

}  // namespace wellspaced
