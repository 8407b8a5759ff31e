#include "wellspaced/algorithms/coarsening/node_order.hpp"

#include "wellspaced/kernel/radix_sort.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {

std::vector<Index> random_order(std::vector<Index> nodes, std::span<const Index> origin,
                                std::uint32_t level, std::uint64_t seed) {
  const std::uint64_t seed_bits = splitmix64(seed), high = std::uint64_t{level} << 32;
  std::vector<KeyedItem> items(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    items[i] = {splitmix64(seed_bits ^ splitmix64(high + origin[nodes[i]])), nodes[i]};
  // splitmix64 is a bijection and origins are distinct, so no two keys are equal.
  radix_sort(items);
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = items[i].item;
  return nodes;
}

}  // namespace wellspaced
