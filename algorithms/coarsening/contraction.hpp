// The boundary of the next level: curves contracted to their selected nodes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/level_triangulation.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// An edge of the contracted boundary: it replaces the chain of `steps` edges of a curve that
/// starts at position `begin`. The nodes between its ends are eliminated. A chain of one edge is
/// that edge.
struct ContractedEdge {
  Index a = 0, b = 0;
  int marker = 0;  ///< of the chain's first edge
  std::size_t curve = 0, begin = 0, steps = 1;
};

/// Joins the survivors of each curve in their order along it. Survivors next to each other that
/// are one node, or lie at one place, get no edge: what the curve enclosed between them is gone.
/// survives: one flag a node. Requires: the ends of open curves survive.
/// Returns: the edges, curve by curve; domain curves keep the domain on the left.
/// Cost: linear. See: section 7.4.1, CHOICES 7.
std::vector<ContractedEdge> contract_boundary(const Boundary& boundary,
                                              std::span<const Point2> points,
                                              std::span<const std::uint8_t> survives);

/// The edges as constraints of the triangulation of their ends. number: for each node its number
/// there.
std::vector<ConstrainedEdge> constrained_edges(const Boundary& boundary,
                                               std::span<const ContractedEdge> edges,
                                               std::span<const Index> number);

/// The points along the chain that an edge replaces, its ends included.
std::vector<Point2> chain_points(const Boundary& boundary, std::span<const Point2> points,
                                 const ContractedEdge& edge);

/// The node in the middle of those that an edge eliminates. Requires: steps > 1.
Index middle_node(const Boundary& boundary, const ContractedEdge& edge);

}  // namespace wellspaced
