// Keeps interior nodes from coming too close to the edges of the new boundary.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/contraction.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/kernel/local_search.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// What is too near to an edge: the points between the perpendiculars at its ends and nearer to its
/// line than ratio * |edge|, ratio >= 0.
///
/// kRectangle: all of them (Definition 5.3.5, gamma = ratio).
/// kLens: those inside the edge's diametral circle (Figure 7.8, R = ratio).
struct ProtectiveZone {
  enum class Shape { kLens, kRectangle };
  Shape shape = Shape::kLens;
  double ratio = 0.2;
};

/// The edges to protect. points, on_boundary: one a node of the mesh; boundary nodes are exempt.
struct ProtectedEdges {
  std::span<const Point2> points;
  std::span<const std::uint8_t> on_boundary;
  std::span<const ContractedEdge> edges;
  ProtectiveZone zone = {};
};

/// Makes invalid the free interior nodes that lie in the protective zone of an edge. They are
/// sought by a graph search from both ends, up to graph distance |edge|, so that a zone ends where
/// the boundary cuts it off: a straight line to the nearer end is at most sqrt(1/4 + ratio^2)
/// |edge| long, and a path through the mesh not much longer.
/// search: in the mesh's graph.
/// progress: phase "boundary", in nodes looked at.
/// Cost: linear in the nodes within reach of the edges.
/// See: section 7.4.1, Figures 7.8 and 7.10 step 4; CHOICES 9 and 17.
void protect_edges(const ProtectedEdges& around, LocalSearch& search, NodeSelection& selection,
                   const Progress& progress = {});

/// Counts the nodes that each node of the new boundary inspects to protect its edges: it searches
/// the diametral circle of every edge that ends in it, through nodes inside alone, and inspects the
/// edge's ends and what it reaches. A node in the circles of two of its edges counts twice.
/// Returns: one search for each end of an edge.
/// progress: as above. Requires: no edge joins two nodes at one place. Cost: linear in the nodes
/// inspected and in the points. See: section 8.4.3, whose figures this reading gives (README.md).
SearchCount inspect_edges(LocalSearch& search, std::span<const Point2> points,
                          std::span<const ContractedEdge> edges, const Progress& progress = {});

}  // namespace wellspaced
