// Small seeded meshes for property tests: grids with moved nodes, random diagonals and holes.
#pragma once

#include <cstdint>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::test {

/// nx, ny: cells. jitter: how far a node moves along each axis at most, below 0.25 so that no
/// triangle turns over. hole: the probability that a cell is left out.
struct GridMeshOptions {
  Index nx = 8, ny = 8;
  double jitter = 0.2;
  double hole = 0;
  std::uint64_t seed = 1;
};

/// A grid of cells of size 1, each cut along a random diagonal. The segments are left empty, nodes
/// of left-out cells stay: some may be isolated, and boundary curves may meet in a node.
inline TriangleMesh grid_mesh(const GridMeshOptions& options) {
  Random random(options.seed);
  TriangleMesh mesh;
  for (Index y = 0; y <= options.ny; ++y)
    for (Index x = 0; x <= options.nx; ++x)
      mesh.points.push_back({x + random.uniform(-options.jitter, options.jitter),
                             y + random.uniform(-options.jitter, options.jitter)});
  for (Index y = 0; y < options.ny; ++y) {
    for (Index x = 0; x < options.nx; ++x) {
      if (random.uniform() < options.hole) continue;
      const Index a = y * (options.nx + 1) + x, b = a + 1, c = b + options.nx + 1, d = c - 1;
      if (random.below(2) == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  }
  return mesh;
}

}  // namespace wellspaced::test
