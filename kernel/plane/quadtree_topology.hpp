// Which leaves of a quadtree touch which, and coarsening by that.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/quadtree.hpp"

namespace wellspaced {

/// The boxes around every box of a quadtree, split or not: its eight neighbours of the same size,
/// or what is there instead.
///
/// Cost: linear in the leaves to build, about 20 bytes a leaf. Asking for the neighbours of a leaf
/// costs O(1) in a balanced tree.
class QuadtreeTopology {
 public:
  explicit QuadtreeTopology(const Quadtree& tree);

  Index leaves() const { return static_cast<Index>(parent_.size()); }

  /// Calls visit(neighbour) once for every leaf that shares a part of an edge with this one
  /// (Definition 5.8.1).
  template <class Visit>
  void for_each_neighbor(Index leaf, Visit visit) const {
    for (const int direction : kEdgeDirections)
      for_each_facing(around(leaf, direction), direction, visit);
  }

  /// The same for every leaf that shares a point with this one: also over the corners.
  template <class Visit>
  void for_each_extended_neighbor(Index leaf, Visit visit) const {
    for_each_neighbor(leaf, visit);
    for (const int direction : kCornerDirections) {
      // A larger leaf at the corner may lie along an edge, too.
      const Box box = around(leaf, direction);
      if (box != around(leaf, horizontal_part(direction)) &&
          box != around(leaf, vertical_part(direction)))
        for_each_facing(box, direction, visit);
    }
  }

  friend Quadtree coarsened(const Quadtree& tree, const QuadtreeTopology& topology,
                            QuadtreeBalance balance);

 private:
  // A leaf, a split box, or nothing: beyond the square. Leaves count from 0, split boxes from
  // kSplit.
  using Box = Index;
  static constexpr Box kSplit = Index{1} << 31;
  static constexpr Box kNothing = kNoIndex;

  // Directions are numbered by rows from the south-west, 0 .. 8; 4 is the box itself.
  static constexpr std::array kEdgeDirections{1, 3, 5, 7};
  static constexpr std::array kCornerDirections{0, 2, 6, 8};
  static constexpr int horizontal_part(int direction) { return 3 + direction % 3; }
  static constexpr int vertical_part(int direction) { return direction / 3 * 3 + 1; }

  struct SplitBox {
    std::array<Box, 4> quarter{};  // in the order of the Z curve
    std::array<Box, 9> around{};   // by direction
  };

  static bool is_split(Box box) { return box >= kSplit && box != kNothing; }
  const SplitBox& split(Box box) const { return splits_[box - kSplit]; }

  // Whether a quarter touches the side or corner of its box that faces back from a direction.
  static constexpr bool faces(int quarter, int direction) {
    const int column = direction % 3 - 1, row = direction / 3 - 1;
    return (column == 0 || (quarter & 1) == (column < 0)) &&
           (row == 0 || (quarter >> 1) == (row < 0));
  }

  Box around_quarter(const SplitBox& parent, int quarter, int direction) const;
  Box around(Index leaf, int direction) const;
  void number_boxes(const Quadtree& tree);
  void find_surroundings();
  bool may_collapse(const SplitBox& box, QuadtreeBalance balance,
                    const std::vector<std::uint8_t>& collapsing) const;
  std::vector<std::uint8_t> collapsing(QuadtreeBalance balance) const;

  // The leaves of `box` along the side or at the corner towards where it was seen from, in the
  // given direction. Recursion is as deep as the tree, at most 31; 1 over an edge and 2 over a
  // corner if it is balanced.
  template <class Visit>
  void for_each_facing(Box box, int direction, Visit& visit) const {
    if (box == kNothing) return;
    if (!is_split(box)) return visit(box);
    for (int quarter = 0; quarter < 4; ++quarter)
      if (faces(quarter, direction)) for_each_facing(split(box).quarter[quarter], direction, visit);
  }

  std::vector<Index> parent_;          // one a leaf: the split box whose quarter it is
  std::vector<std::uint8_t> quarter_;  // one a leaf: which quarter of its parent
  std::vector<SplitBox> splits_;       // in preorder along the Z curve
  std::vector<std::uint8_t> depth_;    // one a split box
};

/// QUADTREE_COARSEN (Figure 5.14, as corrected: all four siblings are tested): from the smallest
/// boxes up, four leaves that are a whole box become one, unless one of them has by then a smaller
/// neighbour. Where the tree is balanced so is the result.
/// topology: of `tree`. balance: as the tree has it; with kCorner, smaller leaves over a corner
/// count, too. Cost: linear in the leaves.
/// See: section 5.8.1, Theorem 5.8.5 with its erratum.
Quadtree coarsened(const Quadtree& tree, const QuadtreeTopology& topology, QuadtreeBalance balance);

}  // namespace wellspaced
