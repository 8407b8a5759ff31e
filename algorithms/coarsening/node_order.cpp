#include "wellspaced/algorithms/coarsening/node_order.hpp"

#include "wellspaced/kernel/random.hpp"

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

}  // namespace wellspaced
