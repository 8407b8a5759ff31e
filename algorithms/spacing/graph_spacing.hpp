// Spacing functions in the weighted graph metric of a mesh.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The spacing that a mesh has: half the shortest edge at each node; 0 at a node without edges.
/// Cost: linear. See: section 8.3.
std::vector<double> mesh_spacing(const Graph& graph);

/// The same, of the graph that the mesh has, without making it. Edges so long that their length
/// overflows are passed over.
std::vector<double> mesh_spacing(const TriangleMesh& mesh);

/// The coarsening function f(p) = min over all nodes q of factor * g(q) + d_G(p, q): the greatest
/// function that is 1-Lipschitz in the graph metric and at most factor * g. Nodes without edges
/// keep 0.
/// spacing: g, one value >= 0 a node. factor: > 0. progress: as in shortest_distances.
/// Returns: one value a node.
/// Cost: that of shortest_distances.
/// See: section 7.2, Definition 5.3.2, Lemmas 5.4.1 to 5.4.4, 7.1.4, Corollary 7.1.5.
std::vector<double> coarsened_spacing(const Graph& graph, std::span<const double> spacing,
                                      double factor, const Progress& progress = {});

}  // namespace wellspaced
