// How far two boundaries are from each other.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

using Line = std::array<Point2, 2>;

/// The edges with a triangle on one side only, and the segments, of a mesh.
std::vector<Line> boundary_lines(const TriangleMesh& mesh);

/// The Hausdorff distance between two sets of line segments: the largest distance of a point of
/// either set from the other set. It may lie inside a segment; found by halving segments where
/// more could hide, to a relative error of 1e-6 or 2^-39 of the largest coordinate. Coordinates may
/// be any finite doubles.
/// Degenerate: infinite if exactly one of the sets is empty, 0 if both are.
/// Cost: O((a + b) log (a + b)) for boundaries that follow each other.
double hausdorff_distance(std::span<const Line> a, std::span<const Line> b);

}  // namespace wellspaced::audit
