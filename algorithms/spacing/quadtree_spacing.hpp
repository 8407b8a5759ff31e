// The spacing functions of a balanced quadtree (Definition 5.8.2), from the boxes around a leaf.
#pragma once

#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/quadtree.hpp"
#include "wellspaced/kernel/plane/quadtree_topology.hpp"

namespace wellspaced {

/// What the spacing functions of a quadtree T are in one of its leaves b.
///
/// By Lemma 5.8.3 the leaves that share a point with b decide them, so a value costs O(1); and
/// (1 + sqrt 2) / 4 l_T <= q_T <= (1 + sqrt 2) l_T (corrected lower bound, attained where b meets
/// a leaf of a quarter of its side at a corner).
class LeafSpacing {
 public:
  /// Requires: an edge-balanced tree, its topology, leaf < tree.leaves(). Cost: O(1).
  LeafSpacing(const Quadtree& tree, const QuadtreeTopology& topology, Index leaf);

  /// l_T: half the side of b, everywhere in b. Not continuous.
  double box_value() const { return own_.half_side; }

  /// q_T(x), x in b: the least of half a leaf's side and the distance to its centre, over all
  /// leaves. 1-Lipschitz, but in a uniform part of the tree it more than doubles from the middle
  /// of each box to its corners.
  double cone_value(Point2 x) const;

  /// The least of half a leaf's side and the distance to its box, over all leaves: the greatest
  /// 1-Lipschitz function that is at most l_T, so constant where the tree is uniform.
  /// l_T / 4 <= value <= l_T, so it is similar to q_T, and as good for Theorems 5.8.4 and 5.8.5.
  double envelope_value(Point2 x) const;

 private:
  struct Leaf {
    double half_side;
    Point2 centre;
    Box2 box;
  };
  static Leaf leaf_of(const Quadtree& tree, Index leaf);

  Leaf own_;
  std::vector<Leaf> around_;
};

}  // namespace wellspaced
