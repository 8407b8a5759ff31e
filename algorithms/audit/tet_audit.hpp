// The audit of a tetrahedral mesh, all four layers.
#pragma once

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Judges a tetrahedral mesh, whoever made it: syntax and topology (tet_topology.hpp), embedding
/// (tet_embedding.hpp), Delaunay properties (tet_delaunay.hpp) and shape (tet_shape.hpp). Every
/// decision is exact.
/// Returns: the checks, in the order of the layers, and the measures. If the syntax is wrong,
///   nothing else can be judged, and the report ends there.
/// Requires: 4 * tets + facets < 2^32.
/// Cost: O(n log n), 250 bytes a tet.
Report audit_tet_mesh(const TetMesh& mesh);

}  // namespace wellspaced::audit
