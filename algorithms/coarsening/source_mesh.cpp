#include "wellspaced/algorithms/coarsening/source_mesh.hpp"

#include <algorithm>
#include <utility>

#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/algorithms/spacing/threshold_spacing.hpp"

namespace wellspaced {
namespace {

// f_{g,C,P} in the metric of the options.
std::vector<double> cone_envelope(const SourceMesh& source, double factor, SpacingMetric metric,
                                  const Progress& progress) {
  const std::span<const double> g = source.level.spacing;
  const Graph& graph = source.skeleton.graph;
  switch (metric) {
    case SpacingMetric::kGraph:
      return coarsened_spacing(graph, g, factor, progress);
    case SpacingMetric::kEuclidean:
      return euclidean_coarsened_spacing(source.level.mesh.points, g, factor, progress);
    case SpacingMetric::kGeodesic:
      return geodesic_coarsened_spacing(*source.visibility, graph, g, factor, progress);
  }
  return {};
}

// The quasi-uniform scheme: one spacing for all nodes, C times the least of the source.
std::vector<double> uniform_spacing(std::span<const double> g, double factor) {
  const double least = g.empty() ? 0 : *std::min_element(g.begin(), g.end());
  return std::vector<double>(g.size(), factor * least);
}

std::vector<double> without_limit(const SourceMesh& source, double factor,
                                  const CoarseningOptions& options, const Progress& progress) {
  const std::span<const double> g = source.level.spacing;
  switch (options.method) {
    case CoarseningMethod::kThreshold:
      return threshold_spacing(g, factor);
    case CoarseningMethod::kQuasiUniform:
      return uniform_spacing(g, factor);
    default:
      return cone_envelope(source, factor, options.metric, progress);
  }
}

}  // namespace

bool uses_visibility(const CoarseningOptions& options) {
  return options.method != CoarseningMethod::kMis &&
         options.method != CoarseningMethod::kQuadtree && options.metric != SpacingMetric::kGraph;
}

bool uses_graph(const CoarseningOptions& options) {
  return options.method != CoarseningMethod::kQuadtree;
}

SourceMesh source_mesh(const Level& level, Skeleton skeleton, std::span<const double> limit,
                       const CoarseningOptions& options) {
  SourceMesh source{level, std::move(skeleton), std::nullopt, {}};
  if (uses_visibility(options)) source.visibility.emplace(level.mesh);
  if (!limit.empty())
    for (const Index v : level.origin) source.limit.push_back(limit[v]);
  return source;
}

std::vector<double> input_spacing(const TriangleMesh& mesh, const Graph& graph,
                                  const CoarseningOptions& options, const Progress& progress) {
  if (options.spacing) return *options.spacing;
  const bool is_of_chapter_6 = options.method == CoarseningMethod::kThreshold ||
                               options.method == CoarseningMethod::kQuasiUniform;
  if (is_of_chapter_6) return nearest_neighbor_spacing(mesh.points, progress);
  if (uses_visibility(options)) return scaled(nearest_neighbor_spacing(mesh.points, progress), 0.5);
  return uses_graph(options) ? mesh_spacing(graph) : mesh_spacing(mesh);
}

std::vector<double> coarsened(const SourceMesh& source, double factor,
                              const CoarseningOptions& options, const Progress& progress) {
  std::vector<double> f = without_limit(source, factor, options, progress);
  for (std::size_t v = 0; v < source.limit.size(); ++v) f[v] = std::min(f[v], source.limit[v]);
  return f;
}

}  // namespace wellspaced
