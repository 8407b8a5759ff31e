#include "wellspaced/algorithms/spacing/graph_spacing.hpp"

#include <algorithm>
#include <limits>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/shortest_paths.hpp"

namespace wellspaced {
namespace {

constexpr double kNoEdge = std::numeric_limits<double>::infinity();

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

std::vector<double> mesh_spacing(const TriangleMesh& mesh) {
  std::vector<double> shortest(mesh.points.size(), kNoEdge);
  const auto see = [&](Index a, Index b) {
    const double length = distance(mesh.points[a], mesh.points[b]);
    shortest[a] = std::min(shortest[a], length);
    shortest[b] = std::min(shortest[b], length);
  };
  for (const auto& [a, b, c] : mesh.triangles) see(a, b), see(b, c), see(c, a);
  for (const Segment& s : mesh.segments)
    if (s.a != s.b) see(s.a, s.b);
  for (double& length : shortest) length = length == kNoEdge ? 0 : 0.5 * length;
  return shortest;
}

std::vector<double> coarsened_spacing(const Graph& graph, std::span<const double> spacing,
                                      double factor, const Progress& progress) {
  std::vector<double> start(spacing.begin(), spacing.end());
  for (double& value : start) value *= factor;
  return shortest_distances(graph, start, progress);
}

}  // namespace wellspaced
