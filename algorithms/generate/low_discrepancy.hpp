// Point sets of low discrepancy, and the discrepancy of a point set (section 1.1.2).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced {

/// The radical inverse phi: the digits of n in a base, mirrored at the point. In [0, 1), rounded
/// once. Requires: base >= 2, n < 2^50 / base.
double radical_inverse(std::size_t n, std::size_t base);

/// The Hammersley sequence of `count` points in base 2: (phi(n, 2), n / count), n from 0.
/// See: Definition 1.1.1.
std::vector<Point2> hammersley_points(std::size_t count, const Progress& progress = {});

/// The first `count` points of the Halton sequence of bases 2 and 3: (phi(n, 2), phi(n, 3)), n from
/// 0. See: Definition 1.1.2.
std::vector<Point2> halton_points(std::size_t count, const Progress& progress = {});

/// The star discrepancy: the largest difference, over all boxes [0, u) x [0, v) in the unit square,
/// between the share of the points in the box and its area.
/// points: in the unit square, its border included; coincident ones count each.
/// Returns: in (0, 1]; 1 for no points. Exact but for rounding.
/// Cost: O(n^2) time, O(n) memory.
/// See: section 1.1.2, the family J*.
double star_discrepancy(std::span<const Point2> points);

}  // namespace wellspaced
