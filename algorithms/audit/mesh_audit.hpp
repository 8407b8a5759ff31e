// The audit of a triangle mesh, all four layers: a verdict that anyone can trust.
#pragma once

#include <span>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Whether the segments of a mesh describe its whole boundary or, say, the parts with conditions.
/// With kWholeBoundary boundary_has_segments is required, unless the mesh fills a convex polygon:
/// it may be a triangulation of the hull.
enum class SegmentMeaning { kSomeEdges, kWholeBoundary };

/// What a mesh is judged against, beside itself.
struct MeshAuditOptions {
  const Pslg* domain = nullptr;        ///< the domain that it should be a mesh of; null: not known
  double allowance = 2;                ///< how far nodes may be off it (DomainToMeet)
  std::span<const Point2> holes = {};  ///< points that must be in no triangle
  SegmentMeaning segments = SegmentMeaning::kSomeEdges;
  Progress progress = {};
};

/// Judges a triangle mesh, whoever made it: syntax and topology (topology.hpp), embedding
/// (embedding.hpp), Delaunay properties (delaunay.hpp) and shape (shape.hpp). Every decision is
/// exact; no code is shared with what makes meshes, predicates and exact arithmetic aside.
/// Conformity to a domain is judged where one is given (domain.hpp).
/// Returns: the checks, in the order of the layers, and the measures. If the syntax is wrong,
///   nothing else can be judged, and the report ends there. It is not complete if cancelled.
/// Requires: 3 * triangles + segments < 2^32; segment ends of the domain in range.
/// Cost: O(n + b log b) for n triangles and b boundary edges, 100 bytes a triangle.
Report audit_mesh(const TriangleMesh& mesh, const MeshAuditOptions& options = {});

}  // namespace wellspaced::audit
