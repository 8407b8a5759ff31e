// A mesh that the nodes of a level are selected from, and the spacing that they are to get.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/algorithms/mesh/visibility.hpp"

namespace wellspaced {

/// A level with what the selection from it reads off its mesh.
///
/// visibility: where distances are not those of the graph. limit: one value a node of the level
///   that no coarsened spacing exceeds; empty: there is none.
struct SourceMesh {
  const Level& level;
  Skeleton skeleton;
  std::optional<Visibility> visibility;
  std::vector<double> limit;
};

/// skeleton: of the level's mesh. limit: one value a node of the input mesh, or empty.
/// Requires: the level outlives the result and stays where it is.
SourceMesh source_mesh(const Level& level, Skeleton skeleton, std::span<const double> limit,
                       const CoarseningOptions& options);

/// Whether conflicts are between nodes that see each other, not along edges.
bool uses_visibility(const CoarseningOptions& options);

/// Whether anything is read off the graph of the mesh.
bool uses_graph(const CoarseningOptions& options);

/// The spacing g that an input mesh has: half its shortest edges in the graph metric, half NN in
/// the others; for the methods of chapter 6 NN; or what the options give.
/// graph: of the mesh; may be empty where uses_graph() denies it. progress: phase "spacing".
std::vector<double> input_spacing(const TriangleMesh& mesh, const Graph& graph,
                                  const CoarseningOptions& options, const Progress& progress = {});

/// The coarsened spacing at the nodes of the source: of its own spacing, by a factor C > 0, by the
/// method's function in the options' metric, at most the limit. progress: of any phase.
std::vector<double> coarsened(const SourceMesh& source, double factor,
                              const CoarseningOptions& options, const Progress& progress = {});

}  // namespace wellspaced
