// Coarsening in linear time: a node-nested sequence selected from quadtrees, coarse to fine.
#pragma once

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The coarsening sequence of section 5.8.
///
/// From fine to coarse a balanced quadtree is coarsened (QUADTREE_COARSEN), and with it the set of
/// nodes that a level may be made of is thinned: one node in each of the 4^k parts of a leaf, and
/// the boundary alike along its curves. Then the levels are selected from coarse to fine, each a
/// maximal set without conflicts f_i(p) + f_i(q) > beta |p - q| that holds the nodes of the coarser
/// level; conflicts are found among the leaves near by. Candidates are taken in the order of the
/// tree, and a level is triangulated in it. After one sort of the nodes, the time of a level is
/// proportional to its own candidates, but for a logarithm of its boundary's.
///
/// Distances are Euclidean, also across slits and thin walls.
/// finest: level 0, whose fixed points hold the anchors of its boundary. boundary: its boundary.
/// options: beta; factor, of which the next power of two is taken; max_levels, until_nodes,
///   protect, progress. Levels that drop no node are left out.
/// Returns: level 0 and the levels made from it; not complete if cancelled: then finer levels lack.
/// Errors: those of `coarsen`.
/// Limits: the tree tells apart 2^31 boxes along a side. Where nodes lie closer together than that
///   against the size of the domain times beta, level 1 is coarser than it should be.
/// See: Theorems 5.8.6 and 5.8.8; section 5.3.4, scheme 3.
Result<Hierarchy> coarsen_by_quadtree(Level finest, Boundary boundary,
                                      const CoarseningOptions& options);

}  // namespace wellspaced
