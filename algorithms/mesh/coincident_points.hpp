// Points with equal coordinates.
#pragma once

#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// For each point the lowest-numbered point with its coordinates: itself if there is no other.
/// +0 and -0 are equal. Requires: no NaN. Cost: O(n log n) time, 24 bytes a point.
std::vector<Index> first_coincident(std::span<const Point2> points);
std::vector<Index> first_coincident(std::span<const Point3> points);

}  // namespace wellspaced
