// Does a mesh conform to a domain, a planar straight-line graph? Decided exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// allowance: how far nodes may be from their segments, see below. 2 covers a place that is rounded
/// once; a file with 15 decimal digits needs more. progress: phase "audit"; told to stop, the
/// report is unfinished.
struct DomainToMeet {
  const Pslg& domain;
  double allowance = 2;
  Progress progress = {};
};

/// Judges a mesh against the domain that it should be a mesh of. Checks:
///   domain_points_are_nodes    (required) at every point of the domain there is a node
///   domain_segments_are_edges  (required) every segment is a chain of mesh edges, from end to end
///   domain_segments_exact      the nodes inside these chains lie exactly on their segments
///   boundary_on_domain         (required) every edge with a triangle on one side only is part of
///                              such a chain. Not judged for a domain without segments, nor for a
///                              mesh that fills a convex polygon, unless the domain has hole seeds:
///                              it is then a triangulation of the hull
///   holes_are_open             (required) no triangle contains a hole seed in its interior or on
///                              its edges; only for a domain with hole seeds
/// A point of a sloping segment can hardly be represented exactly: a node counts as on a segment if
/// the segment's line passes through the box around the node whose half sides are `allowance` units
/// in the last place of the segment's largest x and y. domain_segments_exact tells which nodes
/// needed that.
/// Requires: audit_syntax passed; half_edges is of this mesh; segment ends of the domain in range.
/// Cost: O(n log n + m) for n nodes and the degrees m of the nodes on the segments.
/// See: section 2.1.
void audit_domain(const TriangleMesh& mesh, const HalfEdges& half_edges, const DomainToMeet& domain,
                  Report& report);

/// The check holes_are_open alone. progress: as in DomainToMeet.
/// Cost: O(n log h) for n triangles and h seeds.
void audit_holes(const TriangleMesh& mesh, std::span<const Point2> holes, const Progress& progress,
                 Report& report);

/// Whether the mesh has one boundary loop, which turns left or goes straight on at every node. If
/// no_overlap passes too, the mesh fills a convex polygon.
bool has_convex_boundary(const TriangleMesh& mesh, const HalfEdges& half_edges);

}  // namespace wellspaced::audit
