#include "wellspaced/algorithms/coarsening/node_order.hpp"

#include <numeric>

#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {

// splitmix64 is a bijection, and so is the exclusive or with a constant.
std::vector<std::uint64_t> random_keys(std::span<const Index> origin, std::uint32_t level,
                                       std::uint64_t seed) {
  const std::uint64_t seed_bits = splitmix64(seed), high = std::uint64_t{level} << 32;
  std::vector<std::uint64_t> keys(origin.size());
  for (std::size_t v = 0; v < origin.size(); ++v)
    keys[v] = splitmix64(seed_bits ^ splitmix64(high + origin[v]));
  return keys;
}

std::vector<std::uint64_t> priority_keys(std::span<const double> values) {
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order, [&](Index a, Index b) { return values[a] > values[b]; });
  std::vector<std::uint64_t> keys(values.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) keys[order[rank]] = rank;
  return keys;
}

}  // namespace wellspaced
