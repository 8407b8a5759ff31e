// The thesis' theorems, both sides measured on the instance.
#pragma once

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// What is known about the spacing function that audit_spacing() judged.
enum class SpacingKind {
  kNearestNeighbour,  ///< NN
  kGiven,             ///< any function
  kLocalFeatureSize   ///< lfs, by which a packing is spaced
};

/// Compares both sides of the inequalities of chapters 2 to 4, as corrected in the errata, and adds
/// them to the report's theorems. One whose hypotheses fail on the instance is listed with the
/// hypothesis, and judged neither true nor false. In the plane:
///   2.4.1     L <= 4/3 C^2 (1 + 3/sin(theta))^2 + 1/2, for NN: see below
///   2.4.2     P is 2-spaced by NN
///   2.4.6     sin(theta) <= b, theta the smallest angle, b the distance from the boundary, for NN
///   2.5.1(1)  1/sin(theta) <= L (2 + beta), over triangles that see their circumcentre
///   2.5.1(2)  1/sin(theta) <= (2 + beta) rho, over the others; rho as in the errata, with the
///             longest boundary gap as an interval. Triangles with a node inside their circle,
///             behind a segment, have no gap there and are left out
///   2.5.2     f <= (beta + 1) NN, and NN <= D (2 + D) f, D = L (3 + 2L), at the nodes
/// In space 2.4.2, 2.5.2, and
///   3.4.3     E/e <= 2 rho in a tet
///   3.4.4     E <= C2^(2 C3 - 1) e, E and e the longest and the shortest edge at a node; as
///             logarithms
///   3.4.5     degrees <= (2 C^2 + 1)^3
///   3.5.1     R <= rho C NN for the corners of the Voronoi cell of a node
///   3.5.2     NN / 2 <= R <= (1 + rho C) NN there
///   3.6.2     for NN, gaps on segments have L <= C (1 + 4 rho) / 2, those on faces
///             L <= 4/3 C^2 (1 + 6 rho)^2 + 1/2, interior ones L <= 3/2 C^2 (1 + 8 rho)^2 + 1/2
///   4.3.4     no node lies inside the smallest sphere of a boundary face; for lfs, as what follows
///   4.3.6     no circumcentre lies outside the domain
///   4.3.7     rho <= 2 beta / (beta - 7 - 2 sqrt 2)
///   4.4.1     nodes <= 6 / pi (beta + 1)^3 times the integral of 1 / lfs^3
/// Theorem 4.3.5, conformity, is what audit_tet_domain() judges; where it fails the others are not
/// compared. C is the density graph constant, the largest ratio of an edge at a node to its NN.
///
/// Why gaps are bounded where all spheres are empty of nodes (2.4.1 and 3.6.2). The thesis counts
/// the triangles or Voronoi cells that a gap meets, which leaves constants open. But let u be a
/// place in an edge, a face or a tet with k corners, p the one of largest weight w_p >= 1/k, s its
/// distance from u, R and e the radius and the shortest edge of a tet that this belongs to.
/// (1) The power of u in the sphere, h = sum w_i |u - p_i|^2 = sum over pairs of
///     w_i w_j |p_i - p_j|^2, is at least w_p e sum w_j |p - p_j| >= e s / k. The sphere is h / 2R
///     or more away from u, and so are all nodes: f(u) >= s / (2 k rho). As f(u) >= NN(p) - s, too,
///     NN(p) <= (1 + 2 k rho) f(u), and no edge at p exceeds K f(u), K = C (1 + 2 k rho).
/// (2) A gap on a segment lies in one edge, so 2 r <= K f(x) with k = 2.
/// (3) In a gap of radius r around c let u be on the way from x to c, at distance t from x. The
///     corners are at least r away from c: r^2 <= sum w_i |c - p_i|^2 = (r - t)^2 + h, and h is at
///     most sum w_i |p - p_i|^2 <= (1 - 1/k) E^2, E the longest edge at p. By (1), and as f(u) is
///     at most f(x) + t, sqrt((2 r t - t^2) k / (k - 1)) <= K (f(x) + t) for all t <= r. The t for
///     which that says most gives f(x) >= r (sqrt(1 + a) - 1), a = k / ((k - 1) K^2), and thus
///     r / f(x) <= 2 / a + 1/2: with k = 3 on faces, 4 inside. In the plane k is 3 and rho
///     1 / (2 sin(theta)), and segments are no worse.
/// The left side is always the smaller one, if the theorem holds.
/// Requires: the report holds what audit_mesh() or audit_tet_mesh(), and audit_spacing(), found
/// about this mesh, and the syntax is right. Cost: linear.
void compare_with_theorems(const TriangleMesh& mesh, SpacingKind kind, Report& report);
void compare_with_theorems(const TetMesh& mesh, SpacingKind kind, Report& report);

}  // namespace wellspaced::audit
