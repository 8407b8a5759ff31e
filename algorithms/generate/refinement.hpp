// Delaunay refinement of a domain by a spacing function.
#pragma once

#include <cstddef>
#include <functional>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The distance that nodes should keep at a point: positive.
using SpacingFunction = std::function<double(Point2)>;

/// Meshes the domain by inserting circumcentres until no circumradius exceeds `spacing` at the
/// circumcentre; then the nodes are Delaunay maximal for the spacing (chapter 4). Where the spacing
/// is L-Lipschitz, L < 1, the angles away from the boundary are at least arcsin((1 - L) / 2).
/// Triangles with an angle below 25 degrees are cut as long as they are not much smaller than the
/// spacing.
///
/// boundary: the domain; its segments remain edges, and no other point is put on them.
/// Requires: segments meet at their ends only, bound the domain, and are 1 to sqrt(2) spacings
/// long;
///   angles between them are at least 60 degrees in the domain. Shorter or longer ones cost angles
///   near them, nothing else.
/// Returns: the boundary's points and segments with their numbers, then the inserted points.
/// Errors: those of Delaunay2; kLimit if there are more than max_points points; kCancelled.
/// Cost: O(n log n) expected.
/// See: Chew, Guaranteed-quality triangular meshes (1989), of which this is the graded form.
Result<TriangleMesh> refine_by_spacing(const Pslg& boundary, const SpacingFunction& spacing,
                                       std::size_t max_points, const Progress& progress = {});

}  // namespace wellspaced
