// The statistics of a level of a coarsening sequence: the columns of Tables 8.1 and 8.3 to 8.8.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The angles of a mesh's triangles. Boundary triangles are those with a boundary node, that is, a
/// node on a segment; the others are interior. Empty where there is no such triangle.
/// le_10: the number of angles of at most 10 degrees.
struct AngleStatistics {
  std::optional<double> interior_min_deg, boundary_min_deg, max_deg;
  std::size_t interior_le_10 = 0, boundary_le_10 = 0;
};

/// Requires: triangle and segment indices in range.
/// Degenerate: a flat triangle has the angles 0, 0 and 180; coincident corners have none.
/// Cost: linear.
/// See: section 8.1, Tables 8.3 to 8.8.
AngleStatistics angle_statistics(const TriangleMesh& mesh);

/// log2 of the longest over the shortest edge of the triangles (CHOICES 4).
/// Returns: empty for a mesh without triangles; infinity where an edge has no length.
std::optional<double> gradation(const TriangleMesh& mesh);

/// The mean and the largest of a count.
struct MeanAndMax {
  double mean = 0;
  std::size_t max = 0;
};

/// One row of the tables of chapter 8. What was not measured is empty.
///
/// intersection: triangles of the next finer level that a triangle of this level meets.
/// The work of the step from this level to the next (see CoarseningWork): path_depth: edges on the
/// shortest path that gave a node its spacing. search: nodes inspected by a selection; the mean is
/// over all nodes of the level (CHOICES 2). edge_search: nodes inspected by a node of the
/// next level's boundary, to protect its edges.
struct LevelStatistics {
  std::size_t nodes = 0, triangles = 0, boundary_edges = 0;
  AngleStatistics angles;
  std::optional<double> gradation;
  std::optional<MeanAndMax> intersection, path_depth, search, edge_search;
};

/// What the level's mesh alone tells: sizes, angles and gradation. Requirements and cost as above.
LevelStatistics mesh_statistics(const TriangleMesh& mesh);

/// The statistics of every level; of the work, what the levels hold: CoarseningOptions::count_work.
/// Intersections: of a level's triangles with those of the level before, if both have some.
/// progress: phase "measure", at each level; once it says stop, no more intersections are counted.
/// Requires: as `coarsen` makes hierarchies.
/// Cost: that of counting the intersections.
/// See: sections 8.1 and 8.4.
std::vector<LevelStatistics> hierarchy_statistics(const Hierarchy& hierarchy,
                                                  const Progress& progress = {});

}  // namespace wellspaced
