// Layer 4 of the audit: how well shaped are the triangles?
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "wellspaced/algorithms/audit/half_edges.hpp"
#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced::audit {

/// The shape of a triangle by every measure of Definition 2.1.3 and its variants.
///
/// min_angle, max_angle: degrees.
/// aspect_ratio: R/r, the radius of the smallest disc that contains the triangle by that of the
///   largest disc inside it; 2 for an equilateral triangle, no less for any other.
/// circumradius_to_inradius: the same with the circumscribed circle.
/// radius_edge: the circumradius by the shortest edge; 1 / sqrt 3 or more.
/// edge_to_height: the largest ratio of an edge to the height upon it; 2 / sqrt 3 or more.
/// area, shortest_edge, longest_edge: in units of the coordinates.
struct TriangleShape {
  double min_angle = 0, max_angle = 0, aspect_ratio = 0, circumradius_to_inradius = 0;
  double radius_edge = 0, edge_to_height = 0, area = 0, shortest_edge = 0, longest_edge = 0;
};

/// Degenerate: a flat triangle has the angles 0 and 180, infinite ratios and no area.
TriangleShape triangle_shape(Point2 a, Point2 b, Point2 c);

/// The member of this name, if there is one.
std::optional<double> shape_value(const TriangleShape& shape, std::string_view name);

/// Measures the triangles, flat and inverted ones too. Measures:
///   min_angle, max_angle (degrees), aspect_ratio, circumradius_to_inradius, radius_edge,
///   edge_to_height: the worst over all triangles
///   triangles_le_10, triangles_le_20: the triangles whose smallest angle is at most so many
///     degrees (Table 8.1)
///   shortest_edge, longest_edge, gradation (log2 of their ratio, CHOICES 4),
///     triangles_per_scale (triangles by gradation), area, perimeter (all boundary edges)
/// Histograms: angle (all corners, degrees), aspect_ratio (triangles).
/// Worst lists: the ten worst triangles by min_angle, max_angle, aspect_ratio and radius_edge.
/// Requires: audit_syntax passed; half_edges is of this mesh.
/// Cost: linear.
void audit_shape(const TriangleMesh& mesh, const HalfEdges& half_edges, Report& report);

}  // namespace wellspaced::audit
