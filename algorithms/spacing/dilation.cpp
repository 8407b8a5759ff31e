#include "wellspaced/algorithms/spacing/dilation.hpp"

#include <limits>
#include <vector>

#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"

namespace wellspaced {
namespace {

constexpr double kNoCone = std::numeric_limits<double>::infinity();

// A cone of height 0 at one node: coarsened, it is the distance from there.
std::vector<double> cone_at(Index source, Index nodes) {
  std::vector<double> spacing(nodes, kNoCone);
  spacing[source] = 0;
  return spacing;
}

}  // namespace

Dilation measured_dilation(const Visibility& visibility, const Graph& graph, std::size_t sources) {
  Dilation result;
  result.complete = sources >= graph.nodes();
  const std::size_t step = result.complete ? 1 : graph.nodes() / sources;
  for (std::size_t s = 0; s < graph.nodes(); s += step) {
    const auto from = static_cast<Index>(s);
    const std::vector<double> cone = cone_at(from, graph.nodes());
    const std::vector<double> along_edges = coarsened_spacing(graph, cone, 1);
    const std::vector<double> straight = geodesic_coarsened_spacing(visibility, graph, cone, 1);
    for (Index to = 0; to < graph.nodes(); ++to) {
      const bool joined = straight[to] > 0 && straight[to] < kNoCone;
      if (!joined || !(along_edges[to] > result.mu * straight[to])) continue;
      result.mu = along_edges[to] / straight[to];
      result.from = from;
      result.to = to;
    }
  }
  return result;
}

}  // namespace wellspaced
