// Coarsening for angles: levels of given sizes whose triangles have no small angle, from coarse to
// fine by Delaunay refinement with the nodes of the finest mesh.
#pragma once

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The sequence of CoarseningMethod::kRefinement.
///
/// The coarsest level begins with the special points, every finer one with the nodes of the one
/// before. Nodes are added where triangles are largest against 2 f / beta, f being the coarsening
/// function f_{g,C} of the input with the C that suits the number of nodes; then to triangles with
/// too small an angle, the worst first; and so on in turn, ever fewer. At last nodes of the
/// triangles that are still thin are exchanged for others. One triangulation serves all levels and
/// is edited in place.
///
/// What a level keeps: its boundary is the input's pulled straight between nodes, over none. Its
/// size is within 2% of its target, unless the special points, or the nodes of the level before,
/// are more. Level::spacing is the greatest 1-Lipschitz function below beta / 2 times the shortest
/// edge at each node: by it the nodes are beta-spaced. Nearly no node is left out that it would
/// have room for: check_selection() tells. No angle is guaranteed.
///
/// finest: level 0, whose fixed points hold the anchors and at least 3 nodes on each closed curve.
/// options: targets or ratio, angle_deg, beta, seed, max_levels, until_nodes, progress.
/// Returns: level 0 and the levels made from it; not complete if cancelled: then finer levels lack.
/// Errors: those of `coarsen`.
/// Degenerate: a mesh without triangles has no further level.
/// Cost: a few coarsening functions for the sizes, one for each level, then O(log n) a node; some
///   30 local edits for each triangle that stays thin.
/// See: README.md beside this file, for what it reaches and what did not help.
Result<Hierarchy> coarsen_by_refinement(Level finest, const Skeleton& skeleton,
                                        const CoarseningOptions& options);

}  // namespace wellspaced
