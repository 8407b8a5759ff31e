// From the arrays that a file or a caller hands over to a mesh that algorithms may trust.
#pragma once

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// What prepare_mesh() found and did.
struct MeshPreparation {
  bool turned = false;           ///< all triangles were clockwise and have been turned
  Index recovered_segments = 0;  ///< boundary edges that were not listed
  Index repeated_segments = 0;   ///< segments listed again, which have been dropped
  Index unused_points = 0;       ///< points in no triangle, which stay
  Index slit_points = 0;         ///< points that coincide with another one across a slit
};

/// Checks a triangle mesh and completes it: all triangles counter-clockwise, and every edge with a
/// triangle on one side only among the segments (recovered ones come last, with marker 1, directed
/// as their triangle is).
///
/// base: the number of the first point and triangle in messages; the ids of errors count from 0.
/// progress: phase "check".
/// Requires: at most 2^30 triangles; finite coordinates.
/// Errors: kCancelled; else kInvalidGeometry: an index out of range; a triangle without area;
/// triangles that are partly clockwise; two triangles on the same side of an edge; a segment that
/// is no edge; coincident points in use that are no pair across a slit. Two points are one if they
/// are joined to coincident points by boundary edges whose triangles lie on opposite sides (CHOICES
/// 5, 16). The mesh is then unspecified.
/// Not checked: whether triangles without a common edge overlap; that is the auditor's work.
/// Cost: O(n log n).
Result<MeshPreparation> prepare_mesh(TriangleMesh& mesh, Index base = 0,
                                     const Progress& progress = {});

}  // namespace wellspaced
