// Point sets of space on which triangulators are tried and measured.
//
// All are the same bytes for the same arguments everywhere; those made of whole numbers are exact.
// progress: as in point_sets.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// Uniform in the unit cube ("box3").
std::vector<Point3> box_points3(std::size_t count, std::uint64_t seed,
                                const Progress& progress = {});

/// The points (i, j, k), 0 <= i < nx, 0 <= j < ny, 0 <= k < nz, k the fastest ("lattice3").
std::vector<Point3> lattice_points3(std::size_t nx, std::size_t ny, std::size_t nz,
                                    const Progress& progress = {});

/// Uniform on the unit sphere, rounded to doubles, so nearly but not exactly cospherical
/// ("sphere3").
std::vector<Point3> sphere_points3(std::size_t count, std::uint64_t seed,
                                   const Progress& progress = {});

/// The points (i, i^2, i^3) for `count` consecutive whole i, the middle one 0 ("moment3"): every
/// two are joined by a Delaunay edge. Exact up to 2^18 points.
std::vector<Point3> moment_points3(std::size_t count, const Progress& progress = {});

/// The points (i, 0, 0) and (0, i, 1), 0 <= i < count: two lines that do not meet ("lines3"), with
/// (count - 1)^2 Delaunay tets.
std::vector<Point3> line_points3(std::size_t count, const Progress& progress = {});

/// A helix of radius 1 about the z-axis, which rises by `rise` a turn, with `per_turn` points a
/// turn ("helix3"). Requires: per_turn > 0.
std::vector<Point3> helix_points3(std::size_t count, double per_turn, double rise,
                                  const Progress& progress = {});

/// Puts the points into random order.
void shuffle_points(std::vector<Point3>& points, std::uint64_t seed, const Progress& progress = {});

}  // namespace wellspaced
