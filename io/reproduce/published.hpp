// The figures that the thesis prints in chapters 6 and 8: facts, as they are printed.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Stands where the thesis prints a dash.
inline constexpr double kNotPrinted = -1;

/// A row of Tables 8.3 to 8.8 after its level: nodes; smallest and average smallest angle of the
/// interior triangles, then of the boundary ones; interior and boundary angles of at most 10
/// degrees; mean and largest intersection. Table 8.2 explains the columns.
using PublishedLevel = std::array<double, 9>;

/// One half of Tables 8.3 to 8.8. mesh: "grid1", "grid10", "crack", "airfoil1" to "airfoil3".
/// runs: how many its figures are taken over. small_angle_sums: whether the counts of small angles
/// are sums over the runs, not means (erratum to Table 8.4).
struct PublishedSequence {
  std::string_view mesh, method;
  std::size_t runs = 0;
  bool small_angle_sums = false;
  std::span<const PublishedLevel> levels;
};
/// Null for a mesh or method that the tables do not have.
const PublishedSequence* published_sequence(std::string_view mesh, std::string_view method);

/// A row of the three tables of section 8.4: for CRACK, AIRFOIL 1, 2 and 3 the largest count and
/// the largest average over ten runs, for C = 4, then for C = 8.
using PublishedWork = std::array<double, 16>;
std::span<const PublishedWork> published_path_depth();   ///< section 8.4.1
std::span<const PublishedWork> published_node_search();  ///< section 8.4.2
std::span<const PublishedWork> published_edge_search();  ///< section 8.4.3

/// A row of Table 8.1: nodes, triangles, gradation, triangles a scale, smallest and largest angle,
/// angles of at most 10 and 20 degrees.
struct PublishedMesh {
  std::string_view mesh;
  std::array<double, 8> figures;
};
std::span<const PublishedMesh> published_suite();

/// A row of the table of section 6.1: the smallest angle in degrees and the nodes needed for it.
using PublishedDegradation = std::array<double, 2>;
std::span<const PublishedDegradation> published_degradation();

/// The special points, by number from 0, with which the original mesh of that name was coarsened to
/// the published sizes; empty for other names. The thesis says how many there are, not which.
std::span<const Index> special_points_of(std::string_view mesh);

}  // namespace wellspaced
