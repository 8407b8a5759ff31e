// The seeded random order in which nodes are considered for a level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The keys by which the nodes of a level are ordered (CHOICES 13):
/// splitmix64(splitmix64(seed) ^ splitmix64((level << 32) + origin)). All are different.
/// origin: for each node of the finer level its number in M_0. level: the one being built, >= 1.
std::vector<std::uint64_t> random_keys(std::span<const Index> origin, std::uint32_t level,
                                       std::uint64_t seed);

/// Keys that put the greatest value first, the lower node of equal ones: the ranks.
/// values: one a node, no NaN. Cost: O(n log n).
std::vector<std::uint64_t> priority_keys(std::span<const double> values);

}  // namespace wellspaced
