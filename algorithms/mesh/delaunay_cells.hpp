// The Delaunay cells of a triangulation, and a hash of them that every correct answer shares.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The Delaunay polygons: triangles that share an edge, no segment, and have exactly one common
/// circumscribed circle are one cell. Each is the ascending list of its vertices. The cells of a
/// (constrained) Delaunay triangulation, as a set, do not depend on how its ties are broken.
/// Requires: counter-clockwise triangles, at most one on each side of an edge; valid indices.
/// Cost: one exact test an edge, O(n log n) in all.
std::vector<std::vector<Index>> delaunay_cells(std::span<const Point2> points,
                                               std::span<const std::array<Index, 3>> triangles,
                                               std::span<const Segment> segments);

/// SHA-256 of the canonical text of `cells`: the distinct points are numbered in lexicographic
/// order from 0 (0 and -0 are equal); a cell is the ascending list of its vertices joined by
/// blanks; the cells are sorted as integer tuples and joined by newlines, none at the end.
/// Requires: finite points; every index in `cells` < points.size().
/// Cost: O(n log n).
std::string cells_sha256(std::span<const Point2> points, std::vector<std::vector<Index>> cells);
std::string cells_sha256(std::span<const Point3> points, std::vector<std::vector<Index>> cells);

}  // namespace wellspaced
