// Point sets of the plane on which triangulators are tried and measured.
//
// All are the same bytes for the same arguments everywhere. Points of the unit square or disc
// unless the comment says otherwise; those made of whole numbers are exact. progress: phases
// "generate" and "shuffle"; told to stop, they return fewer points, or some not shuffled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// Uniform in the unit square.
std::vector<Point2> random_points(std::size_t count, std::uint64_t seed,
                                  const Progress& progress = {});

/// Normal clusters of deviation 0.01 around `clusters` uniform centres of the unit square, each
/// point in a random one. (The normal deviate is a sum of 12 uniform ones.)
/// Requires: clusters > 0.
std::vector<Point2> clustered_points(std::size_t count, std::size_t clusters, std::uint64_t seed,
                                     const Progress& progress = {});

/// First `on_circle` points at random angles of the unit circle, rounded to doubles, so nearly but
/// not exactly cocircular; then `inside` points uniform in the disc of radius 0.999.
std::vector<Point2> circle_points(std::size_t on_circle, std::size_t inside, std::uint64_t seed,
                                  const Progress& progress = {});

/// A spiral about the origin, one point every 0.381966 turns (the golden angle), whose radius grows
/// evenly in logarithm from 1 to 2^`octaves`. Requires: 0 <= octaves < 1000.
std::vector<Point2> spiral_points(std::size_t count, double octaves, const Progress& progress = {});

/// The points (i, j), 0 <= i < nx, 0 <= j < ny, row by row.
std::vector<Point2> grid_points(std::size_t nx, std::size_t ny, const Progress& progress = {});

/// The points (i, i^2) for `count` consecutive whole i, the middle one 0: convex position.
/// Exact up to 2^27 points.
std::vector<Point2> parabola_points(std::size_t count, const Progress& progress = {});

/// The points (i, 3 i), 0 <= i < count, then one more off their line, (0, 1).
std::vector<Point2> collinear_points_and_one(std::size_t count, const Progress& progress = {});

/// `count` points, each a copy of a random one of `distinct` uniform points.
/// Requires: distinct > 0.
std::vector<Point2> repeated_points(std::size_t count, std::size_t distinct, std::uint64_t seed,
                                    const Progress& progress = {});

/// Puts the points into random order.
void shuffle_points(std::vector<Point2>& points, std::uint64_t seed, const Progress& progress = {});

}  // namespace wellspaced
