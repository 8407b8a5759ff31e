// A coarsening sequence: meshes from fine to coarse, tied together node by node.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// How many nodes were inspected by searches.
struct SearchCount {
  std::size_t searches = 0, max = 0, total = 0;

  void add(std::size_t inspected) {
    ++searches;
    max = std::max(max, inspected);
    total += inspected;
  }
};

/// What the step from a level to the next cost (section 8.4).
struct CoarseningWork {
  Index path_depth_max = 0;    ///< edges on paths of the shortest-path tree (CHOICES 14); kFunction
  double path_depth_mean = 0;  ///< over all nodes
  SearchCount selection;       ///< nodes inspected within 2 f / beta of each node that was
                               ///< considered, the frontier included (CHOICES 2); kFunction
  SearchCount edge_protection;  ///< nodes inspected by each node of the new boundary, to protect
                                ///< its edges (see inspect_edges)
};

/// A mesh of the sequence.
///
/// mesh: its segments are all its boundary edges and inner segments; its fixed points are F.
/// spacing: one value a node: the function that spaces the level; kMis: half the shortest edge at
///   the node; at level 0: see input_spacing().
/// parent: for each node its number in the next finer level, kNoIndex where the levels are not
///   nested (kFromFinest) and it is not there; empty at level 0.
/// origin: for each node its number in the input mesh. It ascends: a level's nodes keep the
///   input's order.
/// step: the how-manieth step of the run built it, from 1 on; 0 at level 0.
struct Level {
  TriangleMesh mesh;
  std::vector<double> spacing;
  std::vector<Index> parent;
  std::vector<Index> origin;
  std::size_t step = 0;
  std::size_t reinstated = 0;       ///< boundary nodes taken back to keep the boundary intact
  std::size_t dropped_outside = 0;  ///< nodes of the finer level that the new boundary left outside
  std::optional<CoarseningWork> work;  ///< of the step to the next level; none from the last one
};

/// For each node of a level its number in another level of the same input, kNoIndex where it is not
/// there. origin, other: Level::origin of the two; both ascend. Cost: linear.
inline std::vector<Index> numbers_among(std::span<const Index> origin,
                                        std::span<const Index> other) {
  std::vector<Index> numbers;
  numbers.reserve(origin.size());
  Index next = 0;
  for (const Index v : origin) {
    while (next < other.size() && other[next] < v) ++next;
    numbers.push_back(next < other.size() && other[next] == v ? next : kNoIndex);
  }
  return numbers;
}

/// levels[0] is the input, its segments completed and its fixed points those used. complete is
/// false where coarsening was told to stop before its end; the levels that are there are whole.
/// nodes_for_angles: kRefinement: a level of fewer nodes may have smaller angles than those sought,
/// for the special points ask for so many; 0: not known.
struct Hierarchy {
  std::vector<Level> levels;
  bool complete = true;
  std::size_t nodes_for_angles = 0;
};

}  // namespace wellspaced
