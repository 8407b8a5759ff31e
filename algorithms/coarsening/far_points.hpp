// Points of a closed loop that are far from each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Adds points of a closed loop that are far from each other to those chosen, until there are
/// `count`: first a farthest pair (or the farthest from the one chosen), then the farthest from
/// the line of two (on a straight loop, from the two), then the farthest from the triangle of
/// three. loop: the points in order around the loop. chosen: positions in the loop. count: 2 to 4.
/// Returns: all chosen positions, those given first. Fewer than `count` where the loop has fewer
///   points, or all points lie where chosen ones do. Ties go to the lower position.
/// Cost: O(b log b). See: CHOICES 6.
std::vector<std::size_t> add_far_points(std::span<const Point2> loop,
                                        std::vector<std::size_t> chosen, std::size_t count);

}  // namespace wellspaced
