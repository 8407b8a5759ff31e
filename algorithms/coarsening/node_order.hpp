// The seeded random order in which nodes are considered for a level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Puts nodes into the random order of CHOICES 13: ascending by
/// splitmix64(splitmix64(seed) ^ splitmix64((level << 32) + origin)). No two keys are equal.
/// level: the level being built, >= 1. origin: for each node of the finer level its number in M_0.
/// nodes: the nodes of the finer level to order.
/// Cost: linear.
std::vector<Index> random_order(std::vector<Index> nodes, std::span<const Index> origin,
                                std::uint32_t level, std::uint64_t seed);

}  // namespace wellspaced
