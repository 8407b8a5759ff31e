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
///   2.4.1     L <= E^N max(el / NN), for NN: triangles side by side differ by E = 1/sin(theta) at
///             most, and a gap meets N <= 2 + 12/sin^4(theta) of them in a row (2.4.3 to 2.4.5);
///             both sides as logarithms; el and NN at the nodes
///   2.4.2     P is 2-spaced by NN
///   2.4.6     sin(theta) <= b, theta the smallest angle, b the distance from the boundary, for NN
///   2.5.1(1)  1/sin(theta) <= L (2 + beta), over triangles that see their circumcentre
///   2.5.1(2)  1/sin(theta) <= (2 + beta) rho, over the others; rho as in the errata, with the
///             longest boundary gap as an interval
///   2.5.2     f <= (beta + 1) NN, and NN <= D (2 + D) f, D = L (3 + 2L), at the nodes
/// In space 2.4.2, 2.5.2, and
///   3.4.3     E/e <= 2 rho in a tet
///   3.4.4     E <= C2^(2 C3 - 1) NN at a node, E its longest edge (both sides as logarithms)
///   3.4.5     degrees <= (2 C^2 + 1)^3, C the largest E/NN
///   3.5.1     R <= rho C NN for the corners of the Voronoi cell of a node
///   3.5.2     NN / 2 <= R <= (1 + rho C) NN there
///   3.6.2     L <= 130 rho^2 C^2 for interior gaps, for NN: by the proof of Lemma 3.6.1, with an
///             epsilon of R / (130 rho^2 C^2), one node p at most is nearer than that to the x of a
///             gap of radius R, and NN(p) >= R / (2 rho C)
///   4.3.4     no node lies inside the smallest sphere of a boundary face; for lfs, as what follows
///   4.3.6     no circumcentre lies outside the domain
///   4.3.7     rho <= 2 beta / (beta - 7 - 2 sqrt 2)
///   4.4.1     nodes <= 6 / pi (beta + 1)^3 times the integral of 1 / lfs^3
/// Theorem 4.3.5, conformity, is what audit_tet_domain() judges; where it fails the others are not
/// compared.
/// The left side is always the smaller one, if the theorem holds.
/// Requires: the report holds what audit_mesh() or audit_tet_mesh(), and audit_spacing(), found
/// about this mesh, and the syntax is right. Cost: linear.
void compare_with_theorems(const TriangleMesh& mesh, SpacingKind kind, Report& report);
void compare_with_theorems(const TetMesh& mesh, SpacingKind kind, Report& report);

}  // namespace wellspaced::audit
