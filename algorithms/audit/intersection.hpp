// How many triangles of one mesh each triangle of another meets (Definitions 5.1.5 and 5.1.6).
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// Two triangles meet if their interiors have a point in common; touching does not count.
///
/// per_coarse, per_fine: for each triangle of either mesh the number of triangles of the other that
///   it meets.
/// similarity: the least C for which the meshes are C-locally similar where both are defined: the
///   largest ratio, either way, of the longest edges of two triangles that meet; 1 if none do.
struct Intersections {
  std::vector<Index> per_coarse, per_fine;
  double similarity = 1;

  double mean_per_coarse() const;
  Index max_per_coarse() const;
  Index max_per_fine() const;
};

/// Counts exactly, by walking through the fine mesh from one triangle to the next across the edges
/// that meet the coarse triangle.
/// origin: for each coarse node the fine node at the same place, to start from; or empty, or
///   numbers that do not fit: then a search tree finds the starts.
/// progress: phase "intersect", in coarse triangles.
/// Requires: both meshes have valid indices, distinct corners and finite coordinates; the fine one
///   has no flat triangle and does not overlap itself. Orientation does not matter.
/// Degenerate: a flat coarse triangle meets nothing.
/// Cost: linear in the meshes and the number of pairs that meet, for bounded degrees; where the
///   fine mesh has a boundary inside a coarse triangle, or there is no origin, a factor log n.
/// See: section 5.1; CHOICES 11.
Intersections count_intersections(const TriangleMesh& fine, const TriangleMesh& coarse,
                                  std::span<const Index> origin, const Progress& progress = {});

}  // namespace wellspaced::audit
