// From fine to coarse: the quadtrees T_i, the candidates P(T_i, k) and the boundaries that a
// coarsening sequence by quadtree is then selected from.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/morton.hpp"
#include "wellspaced/kernel/plane/quadtree.hpp"
#include "wellspaced/kernel/plane/quadtree_topology.hpp"

namespace wellspaced {

/// The quadtree T_i with the candidates for level i, P(T_i, k) (Definition 5.8.7).
///
/// Candidates are numbered along the Z curve, so those in a leaf lie side by side in memory.
/// No level is selected from stage 0, whose candidates are all nodes of M_0: it has neither leaves
/// nor spacings of candidates, nor `finer`. Boundary candidates are those on the curves of
/// `boundary`, which is M_0's boundary contracted to them; interior candidates lie inside of it.
struct QuadtreeStage {
  Quadtree tree{Square{}};
  QuadtreeTopology topology{tree};
  std::vector<Index> first;       ///< one a leaf and one more: its candidates are first[leaf] on
  std::vector<Index> leaf_of;     ///< for each candidate its leaf
  std::vector<Index> origin;      ///< for each candidate its number in M_0
  std::vector<Index> finer;       ///< for each candidate its number in the stage before
  std::vector<MortonCode> cells;  ///< for each candidate its cell of the deepest grid
  std::vector<Point2> points;
  std::vector<double> spacing;  ///< for each candidate f_i, the tree's envelope function there
  std::vector<Index> fixed;     ///< the special points among them, ascending
  Boundary boundary;            ///< in the candidates' numbers; without anchors
  /// Of the candidates of the stage before: boundary nodes kept against crossings, and interior
  /// nodes that the boundary left outside.
  std::size_t reinstated = 0, dropped_outside = 0;

  Index nodes() const { return static_cast<Index>(origin.size()); }
};

/// Stage 0: all nodes of M_0 and a tree whose leaves are at most a multiple of beta f_0 wide.
/// finest: M_0 as level 0. boundary: its boundary.
/// Requires: finest.mesh.fixed holds the anchors of its boundary.
/// Cost: linear time.
QuadtreeStage first_stage(const Level& finest, const Boundary& boundary, double beta);

/// The next stage: T coarsened `doublings` times, and of the candidates one in each of the 4^k
/// parts of every leaf; on the boundary one for each visit of a curve to such a part. Special
/// points all stay, and boundary nodes that are needed to keep the boundary from crossing itself.
/// least: a tree that no stage gets coarser than; its root alone if none is.
/// Cost: linear in the candidates of this stage, but for contracting the boundary.
/// See: Theorem 5.8.8; k is 3, where its part 3, bounded gaps, asks for 2^k >= 6 sqrt 2 a L_0 (by
/// the erratum).
QuadtreeStage next_stage(const QuadtreeStage& stage, int doublings, const Quadtree& least);

/// The tree whose leaves at the special points are at most beta times as wide as these are apart,
/// so that nodes near them get no farther apart than that. stage: stage 0. Requires: as
/// first_stage().
Quadtree tree_of_special_points(const QuadtreeStage& stage, const Level& finest, double beta);

}  // namespace wellspaced
