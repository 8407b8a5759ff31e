// Interpolation from a level of a hierarchy to the next finer one, as a sparse matrix.
#pragma once

#include <vector>

#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/algorithms/transfer/sparse_matrix.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A node that is interpolated at another place than its own, and how far from it that is.
struct DisplacedNode {
  Index node = 0;
  double distance = 0;
};

/// The prolongation P from a coarser level to a finer one: a row for each node of the finer, a
/// column for each of the coarser. Restriction is its transpose.
///
/// A node that is kept has the row of the identity; so P has full column rank. Any other node is
/// interpolated linearly in the coarser triangle that it lies in. A node outside the coarser
/// polygon is interpolated at the nearest place on a boundary edge near it; and no node is
/// interpolated from one that is more than twice as far through the finer mesh (in the graph
/// metric) as it is straight: so nothing is taken from across a slit or a thin island. Such nodes
/// take their values at the nearest place on the edge, or in the node, that is left of the
/// triangle. Values are positive; those of a row add up to 1 but for rounding.
///
/// displaced: ascending; the nodes outside, and those on the wrong side.
struct Transfer {
  SparseMatrix prolongation;
  std::vector<DisplacedNode> displaced;
};

/// Requires: the coarser level's nodes are nodes of the finer one (`parent`), as `coarsen` makes
///   them; finite coordinates.
/// progress: phase "transfer", in nodes of the finer level.
/// Errors: kUsage where the levels are not nested; kInvalidGeometry where a part of the finer mesh
///   has no node in the coarser one; kCancelled.
/// Method: from the kept nodes outwards through the finer mesh, each node starts where a neighbour
///   was found and walks; nothing is searched for.
/// Cost: O(n) for bounded degrees.
/// Audit: audit_transfer. See: section 1.2.4.
Result<Transfer> transfer_between(const Level& finer, const Level& coarser,
                                  const Progress& progress = {});

/// All transfers of a hierarchy: entry k is that between levels k and k + 1.
/// Requires: at least one level. Errors, progress: as transfer_between().
Result<std::vector<Transfer>> transfers_of(const Hierarchy& hierarchy,
                                           const Progress& progress = {});

}  // namespace wellspaced
