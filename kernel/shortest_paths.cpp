#include "wellspaced/kernel/shortest_paths.hpp"

#include <algorithm>

#include "wellspaced/kernel/pairing_heap.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/radix_sort.hpp"

namespace wellspaced {
namespace {

// The distances are the largest values that no edge can lower any more. Any sequence of lowerings
// ends there, so the order serves speed alone. Dijkstra's order is never wasteful, but it jumps
// through memory; sweeps along the numbering of the nodes stream through it, and bring down most
// values when the nodes are numbered with any locality. So: sweeps while they pay, then Dijkstra.

// Lowers the value of v over its neighbours. Returns whether that changed it.
bool lower_over_neighbors(const Graph& graph, std::vector<double>& distance, Index v) {
  double best = distance[v];
  for (const auto& [u, length] : graph.arcs_of(v)) best = std::min(best, distance[u] + length);
  const bool lowered = best < distance[v];
  distance[v] = best;
  return lowered;
}

// One sweep forth and back through the nodes. Returns how many values it lowered.
std::size_t sweep(const Graph& graph, std::vector<double>& distance) {
  std::size_t lowered = 0;
  for (Index v = 0; v < graph.nodes(); ++v) lowered += lower_over_neighbors(graph, distance, v);
  for (Index v = graph.nodes(); v-- > 0;) lowered += lower_over_neighbors(graph, distance, v);
  return lowered;
}

// Sweeps as long as each has at most half the work of the one before and Dijkstra's share, which
// costs some 64 times as much a node, would be the greater.
void sweep_while_it_pays(const Graph& graph, std::vector<double>& distance, ProgressMeter& meter) {
  std::size_t before = 4 * std::size_t{graph.nodes()}, lowered = sweep(graph, distance);
  while (lowered > graph.nodes() / 64 && lowered <= before / 2 && meter.step(graph.nodes())) {
    before = lowered;
    lowered = sweep(graph, distance);
  }
}

// The nodes that lower a neighbour, by value, then by number.
std::vector<KeyedItem> sorted_seeds(const Graph& graph, std::span<const double> distance) {
  std::vector<KeyedItem> seeds;
  for (Index v = 0; v < graph.nodes(); ++v) {
    const auto arcs = graph.arcs_of(v);
    const bool lowers = any_of(arcs, [&](const Graph::Arc& arc) {
      return distance[v] + arc.length < distance[arc.target];
    });
    if (lowers) seeds.push_back({sort_key(distance[v]), v});
  }
  radix_sort(seeds);
  return seeds;
}

// Dijkstra's algorithm: its queue is the sorted list of the nodes that lower a neighbour, merged
// with a heap of the nodes that were lowered since, which so stays small.
void settle_by_distance(const Graph& graph, std::vector<double>& distance, ProgressMeter& meter) {
  const std::vector<KeyedItem> seeds = sorted_seeds(graph, distance);
  if (seeds.empty()) return;
  PairingHeap heap(graph.nodes());

  const auto relax_arcs = [&](Index u) {
    for (const auto& [v, length] : graph.arcs_of(u)) {
      const double through_u = distance[u] + length;
      if (!(through_u < distance[v])) continue;
      distance[v] = through_u;
      heap.contains(v) ? heap.decrease(v, through_u) : heap.push(v, through_u);
    }
  };
  for (const KeyedItem& seed : seeds) {
    if (!meter.step()) return;
    while (!heap.empty() && sort_key(heap.key(heap.top())) < seed.key && meter.step())
      relax_arcs(heap.pop());
    const bool lowered_since = sort_key(distance[seed.item]) != seed.key;
    if (!lowered_since) relax_arcs(seed.item);
  }
  while (!heap.empty() && meter.step()) relax_arcs(heap.pop());
}

// The neighbour that v's shortest path comes over: see the header.
Index parent_of(const Graph& graph, std::span<const double> distance, Index v) {
  Index parent = kNoIndex;
  for (const auto& [u, length] : graph.arcs_of(v)) {
    if (distance[u] + length != distance[v] || !(distance[u] < distance[v])) continue;
    const bool first = parent == kNoIndex || distance[u] < distance[parent] ||
                       (distance[u] == distance[parent] && u < parent);
    if (first) parent = u;
  }
  return parent;
}

// Depths along the parents; parents are strictly nearer to p*, so there is no circle.
std::vector<Index> depths(std::span<const Index> parent) {
  std::vector<Index> depth(parent.size(), kNoIndex);
  std::vector<Index> path;
  for (Index start = 0; start < parent.size(); ++start) {
    Index v = start;
    for (; depth[v] == kNoIndex && parent[v] != kNoIndex; v = parent[v]) path.push_back(v);
    if (depth[v] == kNoIndex) depth[v] = 0;
    for (Index known = depth[v]; !path.empty(); path.pop_back()) depth[path.back()] = ++known;
  }
  return depth;
}

}  // namespace

std::vector<double> shortest_distances(const Graph& graph, std::span<const double> start,
                                       const Progress& progress) {
  std::vector<double> distance(start.begin(), start.end());
  ProgressMeter meter(progress, "paths", 0);
  sweep_while_it_pays(graph, distance, meter);
  if (!meter.stopped()) settle_by_distance(graph, distance, meter);
  return distance;
}

ShortestPathTree shortest_path_tree(const Graph& graph, std::span<const double> start,
                                    std::span<const double> distance) {
  ShortestPathTree tree;
  tree.parent.assign(start.size(), kNoIndex);
  for (Index v = 0; v < start.size(); ++v)
    if (distance[v] < start[v]) tree.parent[v] = parent_of(graph, distance, v);
  tree.depth = depths(tree.parent);
  return tree;
}

}  // namespace wellspaced
