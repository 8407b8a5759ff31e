// Shortest paths the slow way, and graphs to try the fast way on.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/graph.hpp"

namespace wellspaced::test {

// Bellman and Ford: lowers every value over every arc until nothing changes.
inline std::vector<double> bellman_ford(const Graph& graph, std::vector<double> distance) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Index v = 0; v < graph.nodes(); ++v)
      for (const auto& [w, length] : graph.arcs_of(v))
        if (distance[v] + length < distance[w]) {
          distance[w] = distance[v] + length;
          changed = true;
        }
  }
  return distance;
}

inline Graph random_graph(std::uint64_t seed) {
  return mesh_graph(grid_mesh({.nx = 25, .ny = 17, .hole = 0.1, .seed = seed}));
}

}  // namespace wellspaced::test
