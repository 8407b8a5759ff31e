// Layer 2 of the audit: do the triangles tile a part of the plane? Decided exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The orientation of each triangle: 1 counter-clockwise, -1 clockwise, 0 flat.
std::vector<std::int8_t> orientations(const TriangleMesh& mesh);

/// Whether there are triangles and all are clockwise: a mesh written the other way round.
/// Requires: indices in range.
bool is_clockwise(const TriangleMesh& mesh);

/// Judges whether the triangles lie side by side. Checks, all required:
///   no_inverted      every triangle is counter-clockwise or flat
///   no_flat          no triangle has its corners on one line
///   no_overlap       no two triangles, turned counter-clockwise where need be, have an interior
///                    point in common. It is proven for the mesh as a whole by winding numbers (see
///                    winding.hpp); if the proof fails, the overlapping pairs are searched for, and
///                    violations is a lower bound where they are too many
///   no_hanging_node  no node lies inside a boundary edge. Not complete where triangles overlap
/// Measures: coincident_nodes, the nodes less the distinct places they lie at. The nodes of the two
///   lips of a slit coincide; that is no violation.
/// Requires: audit_syntax passed; half_edges and orientation are of this mesh; audit_topology has
///   reported.
/// Cost: linear and O(b log b) for b boundary edges; O(n log n + pairs) more if triangles overlap.
void audit_embedding(const TriangleMesh& mesh, const HalfEdges& half_edges,
                     const std::vector<std::int8_t>& orientation, Report& report);

}  // namespace wellspaced::audit
