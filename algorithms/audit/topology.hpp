// Layer 1 of the audit: is this a triangle mesh at all, and what is its shape as a surface?
#pragma once

#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// Judges what every other check takes for granted. Checks, all required:
///   valid_indices       triangles name nodes that exist
///   distinct_corners    triangles name three different nodes
///   finite_coordinates  no coordinate is NaN or infinite
///   valid_segments      segments join two different nodes that exist
///   valid_node_data     as many point markers as nodes, or none; fixed nodes exist (node)
/// Returns: whether all pass; if not, nothing else can be judged.
/// Cost: linear.
bool audit_syntax(const TriangleMesh& mesh, Report& report);

/// Judges how the triangles are joined. Checks:
///   no_duplicate_triangle   (required) no two triangles have the same three nodes
///   manifold_edges          (required) at most two triangles share an edge
///   consistent_orientation  (required) two triangles on an edge run along it in opposite ways
///   manifold_nodes          the triangles around a node form one fan; two may touch in a node
///                           where boundary curves meet, so this is no fault by itself
///   euler                   (required) V - E + F = 2 components - boundary loops, nodes counted
///                           once a fan: no handle. violations: the number of handles
///   no_unused_node          every node is in a triangle
///   no_duplicate_segment    no two segments on one edge
///   one_marker_per_edge     (required) segments on one edge have the same marker
///   segments_are_edges      (required) every segment is an edge of a triangle
///   boundary_has_segments   every edge with a triangle on one side only is a segment; not judged
///                           for a mesh without segments
/// Measures: nodes, triangles, edges, segments, boundary_edges, components, boundary_loops, holes
///   (boundary loops less components), euler_characteristic.
/// Requires: audit_syntax passed; half_edges is of this mesh.
/// Cost: linear.
void audit_topology(const TriangleMesh& mesh, const HalfEdges& half_edges, Report& report);

}  // namespace wellspaced::audit
