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

namespace wellspaced {

/// Makes invalid the free interior nodes that lie in the diametral circle of an edge and nearer to
/// its line than ratio * |edge|. They are sought by a graph search from both ends, up to graph
/// distance |edge|: a straight line to the nearer end is at most sqrt(1/4 + ratio^2) |edge| long,
/// and a path through the mesh not much longer.
/// search: in the mesh's graph. on_boundary: one flag a node; boundary nodes are exempt. ratio: R,
/// >= 0. Returns: the nodes within graph distance sqrt(1/4 + ratio^2) |edge| of an end, for each
/// edge. Cost: linear in the nodes within reach of the edges. See: section 7.4.1, Figures 7.8
/// and 7.10 step 4; CHOICES 9 and 17.
SearchCount protect_edges(LocalSearch& search, std::span<const Point2> points,
                          std::span<const ContractedEdge> edges,
                          std::span<const std::uint8_t> on_boundary, double ratio,
                          NodeSelection& selection);

}  // namespace wellspaced
