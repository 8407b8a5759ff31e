// Balanced quadtrees as arrays: nothing but the codes of the leaves along the Z curve.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/morton.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// An axis-parallel square; half its side, so that it is finite for any finite points.
struct Square {
  Point2 centre;
  double half_side = 1;

  /// The smallest square around some points: centred, not empty. No points: the default square.
  /// Requires: finite coordinates.
  static Square around(std::span<const Point2> points);

  /// The cell of the deepest grid that has p; the nearest one for a point outside. Coordinates are
  /// rounded, but monotonically: cells nest, and the order of columns and rows is that of x and y.
  MortonCode cell_of(Point2 p) const;
};

/// Which boxes of a balanced quadtree are at most twice as large as which others: those that share
/// a part of an edge (Definition 5.8.1), or also those that share a corner only.
enum class QuadtreeBalance { kEdge, kCorner };

/// A partition of a square into the leaf boxes of a quadtree.
///
/// Leaves are numbered along the Z curve. Since they leave no gap, the first deepest cell of each
/// says all: a leaf ends where the next begins, and its size is how far that is. So a quadtree is
/// one sorted array of 8 bytes a leaf. A box is closed to the south and west; a point belongs to
/// the leaf of its cell (Square::cell_of), and boxes have at least 2^-31 of the square's side:
/// points in one cell of the deepest grid are never told apart.
/// See: section 5.8.
class Quadtree {
 public:
  /// One leaf.
  explicit Quadtree(Square square) : Quadtree(square, {0}) {}
  /// starts: the first deepest cell of every leaf, ascending. Requires: they are a quadtree's.
  Quadtree(Square square, std::vector<MortonCode> starts);

  Index leaves() const { return static_cast<Index>(starts_.size() - 1); }
  const Square& square() const { return square_; }

  /// The first deepest cell of a leaf; leaves() may be asked, too: it is the end of all.
  MortonCode start(Index leaf) const { return starts_[leaf]; }
  /// How often the square was halved: 0 .. 31.
  int depth(Index leaf) const {
    return kMortonDepth - std::countr_zero(starts_[leaf + 1] - starts_[leaf]) / 2;
  }
  /// The side of boxes of a depth: exact but for underflow, infinite if the square's is.
  double side_at(int depth) const;
  double side(Index leaf) const { return side_at(depth(leaf)); }
  Point2 centre(Index leaf) const;
  Box2 box(Index leaf) const;

  /// The leaf that has a cell of the deepest grid, or a point. Cost: O(log leaves).
  Index locate(MortonCode cell) const;
  Index locate(Point2 p) const { return locate(square_.cell_of(p)); }

 private:
  Square square_;
  std::vector<MortonCode> starts_;  // and the end of the last
};

/// The coarsest balanced quadtree whose leaves hold at most max_points points each; points that
/// share a cell of the deepest grid count as one.
/// Requires: max_points >= 1; finite coordinates. Points outside of the square count for the cell
/// next to them. Cost: linear in points and leaves.
Quadtree quadtree_of_points(const Square& square, std::span<const Point2> points,
                            std::size_t max_points, QuadtreeBalance balance);

/// The coarsest balanced quadtree in which no leaf that holds a point is larger than that point's
/// value: the construction of Theorem 5.8.4 for the largest 1-Lipschitz function with these values.
/// sizes: one a point, >= 0. Requires: as above. Cost: linear in points and leaves.
Quadtree quadtree_of_sizes(const Square& square, std::span<const Point2> points,
                           std::span<const double> sizes, QuadtreeBalance balance);

/// The coarsest quadtree that is nowhere coarser than either; balanced where both are.
/// Requires: the same square. Cost: linear in the leaves.
Quadtree overlay(const Quadtree& a, const Quadtree& b);

/// The coarsest balanced quadtree in which no leaf is larger than the least value of a spacing
/// function g in it. For a 1-Lipschitz g its q_T satisfies a1 q_T <= g <= a2 q_T (Theorem 5.8.4
/// with the constant C = 5 sqrt(2) of its erratum: side <= g <= 5 sqrt(2) side in every leaf).
/// least_in(box): the least value of g in a closed box.
/// Errors: kLimit where more than max_leaves would be needed before balancing.
/// Cost: 4/3 calls a leaf, and linear time.
Result<Quadtree> quadtree_of_spacing(const Square& square,
                                     const std::function<double(const Box2&)>& least_in,
                                     QuadtreeBalance balance, std::size_t max_leaves = 1 << 28);

}  // namespace wellspaced
