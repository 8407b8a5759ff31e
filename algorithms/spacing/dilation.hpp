// The dilation of a mesh: how much longer its paths are than the way through the domain.
#pragma once

#include <cstddef>

#include "wellspaced/algorithms/mesh/visibility.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// mu: the largest ratio of the distance along edges to the geodesic one, over the pairs compared;
///   1 if there are none. from, to: the pair. complete: whether all pairs were compared; mu is the
///   dilation then, otherwise a lower bound of it.
struct Dilation {
  double mu = 1;
  Index from = kNoIndex, to = kNoIndex;
  bool complete = true;
};

/// Measures the dilation of a mesh from at most `sources` nodes, spread evenly over their numbers,
/// to all others. Nodes that no path joins are not compared.
/// graph: of the mesh. Requires: sources > 0.
/// Cost: that of a geodesic coarsening function for each source.
/// See: Definition 7.1.3 and the remark after it on constrained distances.
Dilation measured_dilation(const Visibility& visibility, const Graph& graph, std::size_t sources);

}  // namespace wellspaced
