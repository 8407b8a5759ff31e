#include "wellspaced/algorithms/spacing/graph_spacing.hpp"

#include <algorithm>

#include "wellspaced/kernel/shortest_paths.hpp"

namespace wellspaced {
namespace {

double shortest_arc(std::span<const Graph::Arc> arcs) {
  if (arcs.empty()) return 0;
  const auto shorter = [](const auto& a, const auto& b) { return a.length < b.length; };
  return std::min_element(arcs.begin(), arcs.end(), shorter)->length;
}

}  // namespace

std::vector<double> mesh_spacing(const Graph& graph) {
  std::vector<double> spacing(graph.nodes());
  for (Index v = 0; v < graph.nodes(); ++v) spacing[v] = 0.5 * shortest_arc(graph.arcs_of(v));
  return spacing;
}

std::vector<double> coarsened_spacing(const Graph& graph, std::span<const double> spacing,
                                      double factor) {
  std::vector<double> start(spacing.begin(), spacing.end());
  for (double& value : start) value *= factor;
  return shortest_distances(graph, start);
}

}  // namespace wellspaced
