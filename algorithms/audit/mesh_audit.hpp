// The audit of a triangle mesh, all four layers: a verdict that anyone can trust.
#pragma once

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Judges a triangle mesh, whoever made it: syntax and topology (topology.hpp), embedding
/// (embedding.hpp), Delaunay properties (delaunay.hpp) and shape (shape.hpp). Every decision is
/// exact; no code is shared with what makes meshes, predicates and exact arithmetic aside.
/// Returns: the checks, in the order of the layers, and the measures. If the syntax is wrong,
///   nothing else can be judged, and the report ends there.
/// Requires: 3 * triangles + segments < 2^32.
/// Cost: O(n + b log b) for n triangles and b boundary edges, 100 bytes a triangle.
Report audit_mesh(const TriangleMesh& mesh);

}  // namespace wellspaced::audit
