// Are the nodes of a mesh well-spaced (Definitions 2.3.3 and 3.1.1)? The definitions, measured.
#pragma once

#include <span>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// spacing: f, one value a node; empty: NN, the distance of each node from the nearest other one.
///   Between the nodes f is the largest 1-Lipschitz function with these values.
/// beta: the spacing constant that is claimed; 0: none is, and beta_spaced is not judged.
/// tolerance: how far apart the ends of a bracket may be, relative to the lower one.
/// progress: phase "audit". Once it says stop the report is not complete.
struct SpacingAuditOptions {
  std::span<const double> spacing = {};
  double beta = 0;
  double tolerance = 0.05;
  Progress progress = {};
};

/// Judges how the nodes are spaced, in the Euclidean metric. Nodes at one place, as on the lips of
/// a slit, count as one, with the smallest value. Checks, none required:
///   spacing_positive  every value is positive and finite (node); without that nothing else is
///                     judged
///   lipschitz         f(p) - f(q) <= |p - q| (pairs of nodes, for each p the worst)
///   beta_spaced       f(p) + f(q) <= beta |p - q|, Definition 2.2.3 (pairs of nodes, for each p
///                     the worst); only if a beta is given
///   spheres_empty     no node lies inside the circumscribed circle (sphere) of an element, be it
///                     behind a boundary: all elements are Delaunay, and the circles are gaps
///                     (triangle, tet; flat ones are not judged)
///   well_spaced       f is 1-Lipschitz, and all gaps are bounded; value: the bound
///   gaps_certified    the triangulation in which the interior gaps were sought is Delaunay and has
///                     a convex boundary, decided exactly
/// Only what rounding cannot explain is a violation. Measures:
///   beta                  the smallest constant for which the nodes are spaced by f
///   gap_interior_lower, gap_interior_upper  a bracket of the gap parameter of interior gaps; see
///                         gaps.hpp. The lower end belongs to a gap that exists
///   gap_segment_lower, gap_segment_upper    the same of gaps on segments
///   gap_face_lower, gap_face_upper          and on faces, in space
///   gap                   the largest of the upper ends: the bounded gaps property holds with it
///   boundary_distance     b: the least distance of a node from a segment (face) of the boundary
///                         that it does not lie on, by its f (Theorem 2.5.1, III); straight runs of
///                         edges, and flat ones of faces, are one segment or face. A segment whose
///                         nearest place lies behind the outside of the domain does not count
///   spacing_to_nn_min, spacing_to_nn_max  the ratio f / NN over the nodes
///   density_graph_constant  C of Definition 3.4.1: the largest ratio of an edge at a node to NN
///   spacing_integral      the integral of 1/f^2 (1/f^3 in space) over the mesh, by the midpoint
///                         rule: how many nodes f asks for, but for a constant (section 4.4)
/// Witnesses: beta (two nodes), gap_interior, gap_segment, gap_face (centre c, at x),
///   boundary_distance (a node, the nearest place of the boundary).
/// Requires: audit_syntax passed; as many values as nodes, or none.
/// Cost: O(n log n), and the search of the boundary for gaps.
/// See: Definitions 2.2.1 to 2.2.4, 2.3.1 to 2.3.3, 3.1.1 and 3.1.2.
void audit_spacing(const TriangleMesh& mesh, const SpacingAuditOptions& options, Report& report);
void audit_spacing(const TetMesh& mesh, const SpacingAuditOptions& options, Report& report);

}  // namespace wellspaced::audit
