// The test grids GRID(a) of section 8.1, cut into triangles.
#pragma once

#include <cstdint>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// How the cells of a grid are cut: all from the lower left to the upper right corner; by turns,
/// like a chess board; or each the other way with a given probability.
enum class GridDiagonals { kSlash, kAlternating, kMixed };

/// nx, ny: nodes in a row and in a column. aspect: height of a cell of width 1.
/// mixed: for kMixed, the probability that a cell is cut the other way (1/2: at random; 0.13 fits
/// the published counts of Table 8.3).
struct GridOptions {
  Index nx = 1000, ny = 1000;
  double aspect = 1;
  GridDiagonals diagonals = GridDiagonals::kSlash;
  double mixed = 0.5;
  std::uint64_t seed = 1;
};

/// The grid of nodes (i, aspect * j), row by row, node j * nx + i.
/// Returns: 2 (nx - 1) (ny - 1) triangles, the lower cells first; the segments run around the
///   boundary counter-clockwise from node 0, with markers 1 bottom, 2 right, 3 top, 4 left.
/// progress: phase "generate".
/// Errors: kUsage unless nx, ny >= 2, 0 <= mixed <= 1, aspect > 0 and the height is finite; kLimit
///   beyond 2^29 nodes; kCancelled.
/// Cost: linear.
/// See: section 8.1; CHOICES 12.
Result<TriangleMesh> generate_grid(const GridOptions& options, const Progress& progress = {});

}  // namespace wellspaced
