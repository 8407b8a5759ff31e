// Layer 4 of the audit in space: how well shaped are the tetrahedra?
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// The shape of a tet by every measure of Definitions 2.1.3 and 3.3.1 and their variants.
///
/// min_dihedral, max_dihedral: degrees.
/// aspect_ratio: R/r, the radius of the smallest ball that contains the tet by that of the largest
///   ball inside it; 3 for a regular tet, no less for any other.
/// circumradius_to_inradius: the same with the circumscribed sphere.
/// radius_edge: rho, the circumradius by the shortest edge; sqrt(6)/4 or more.
/// edge_ratio: the longest edge by the shortest, E/e.
/// volume, shortest_edge, longest_edge: in units of the coordinates.
struct TetShape {
  double min_dihedral = 0, max_dihedral = 0, aspect_ratio = 0, circumradius_to_inradius = 0;
  double radius_edge = 0, edge_ratio = 0, volume = 0, shortest_edge = 0, longest_edge = 0;
};

/// Degenerate: a flat tet has dihedral angles of 0 or 180, infinite ratios and no volume.
TetShape tet_shape(const std::array<Point3, 4>& tet);

/// The member of this name, if there is one.
std::optional<double> shape_value(const TetShape& shape, std::string_view name);

/// The classes of Figures 3.2 and 3.3. Tets of aspect ratio at most kBadAspectRatio are well
/// shaped. The others, Figure 3.2, have a large edge ratio, above kLargeEdgeRatio; their short
/// edges, those below the geometric mean of longest and shortest, tell them apart:
///   kNeedle   three around one face: the face is small, the apex far
///   kWedge    one, or two that meet
///   kSpindle  two opposite ones, or more that do not make one face
/// or, Figure 3.3, all edges of like length:
///   kCap      radius_edge above kLargeRadiusEdge, one corner over the inside of the face opposite
///   kFlat     radius_edge above kLargeRadiusEdge, four corners around a quadrilateral
///   kSliver   radius_edge at most kLargeRadiusEdge: the only bad tet of a well-spaced point set
enum class TetClass { kWellShaped, kNeedle, kWedge, kSpindle, kCap, kFlat, kSliver };
inline constexpr double kBadAspectRatio = 10, kLargeEdgeRatio = 4, kLargeRadiusEdge = 2;

TetClass classify_tet(const std::array<Point3, 4>& tet);

/// Measures the tets, flat and inverted ones too. Check:
///   no_sliver      no tet is a sliver: lists them
/// Measures: min_dihedral, max_dihedral (degrees), aspect_ratio, circumradius_to_inradius,
///   radius_edge, edge_ratio: the worst over all tets; needles, wedges, spindles, caps, flats,
///   slivers: how many there are of each class; shortest_edge, longest_edge, gradation, volume.
/// Histograms: dihedral (all six of each tet, degrees), aspect_ratio.
/// Worst lists: the ten worst tets by min_dihedral, max_dihedral, aspect_ratio and radius_edge.
/// progress: phase "audit".
/// Requires: audit_tet_syntax passed. Cost: linear.
void audit_tet_shape(const TetMesh& mesh, const Progress& progress, Report& report);

}  // namespace wellspaced::audit
