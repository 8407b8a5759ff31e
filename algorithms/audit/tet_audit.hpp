// The audit of a tetrahedral mesh, all four layers.
#pragma once

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/algorithms/audit/tet_domain.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// domain: the domain that the mesh should be a mesh of; null: not known.
/// allowance: how far nodes may be off it (SolidToMeet).
struct TetAuditOptions {
  const PolyhedralDomain* domain = nullptr;
  double allowance = 2;
  Progress progress = {};
};

/// Judges a tetrahedral mesh, whoever made it: syntax and topology (tet_topology.hpp), embedding
/// (tet_embedding.hpp), Delaunay properties (tet_delaunay.hpp) and shape (tet_shape.hpp); and
/// conformity to a domain where one is given (tet_domain.hpp). Every decision is exact.
/// Returns: the checks, in the order of the layers, and the measures. If the syntax is wrong,
///   nothing else can be judged, and the report ends there. It is not complete if cancelled.
/// Requires: 4 * tets + facets < 2^32; indices of the domain in range.
/// Cost: O(n log n), 250 bytes a tet.
Report audit_tet_mesh(const TetMesh& mesh, const TetAuditOptions& options = {});

}  // namespace wellspaced::audit
