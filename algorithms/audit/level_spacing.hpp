// Are the nodes of a level spaced by its spacing function (Definition 2.2.3)?
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// The nodes selected from a mesh, with what selected them.
///
/// nodes: their numbers in that mesh. spacing: f, one value each, > 0. beta: > 0.
/// exempt: one flag each, or empty: two exempt nodes are no violation (special points are never
///   dropped for each other, CHOICES 8).
struct SelectedNodes {
  std::span<const Index> nodes;
  std::span<const double> spacing;
  double beta = 0;
  std::span<const std::uint8_t> exempt;
};

/// The pairs of selected nodes (positions in the list) with f_i + f_j > beta d_G(i, j), where d_G
/// is the weighted graph distance of the mesh (Definition 7.1.2), along triangle edges and
/// segments. Only what rounding cannot explain is a violation: a sum of k rounded lengths is
/// trusted to (k + 4) units of 2^-52.
/// progress: phase "audit".
/// Requires: indices in range; distinct nodes; as many spacing values as nodes.
/// Cost: O(s log s) for the s nodes within distance 2 f_i / beta of each node i.
/// See: sections 7.1 and 7.3; CHOICES 1 and 18.
std::vector<std::array<Index, 2>> graph_spacing_violations(const TriangleMesh& mesh,
                                                           const SelectedNodes& selected,
                                                           const Progress& progress = {});

/// The edges of a mesh, as pairs of nodes, with f + f > beta |edge|, beyond rounding. Spacing in
/// the graph metric does not imply this.
/// Requires: one spacing value a node. Cost: linear.
std::vector<std::array<Index, 2>> euclidean_spacing_violations(const TriangleMesh& mesh,
                                                               std::span<const double> spacing,
                                                               double beta);

/// The coarsening function f_{g,C} in the graph metric at the nodes of a mesh: for each node i the
/// least C g_j + d_G(i, j) over all nodes j (Lemma 7.1.4).
/// progress: phase "audit". Requires: one value >= 0 a node; factor > 0. Cost: O(n log n).
std::vector<double> coarsened_in_graph(const TriangleMesh& mesh, std::span<const double> values,
                                       double factor, const Progress& progress = {});

}  // namespace wellspaced::audit
