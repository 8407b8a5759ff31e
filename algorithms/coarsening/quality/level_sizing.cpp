#include "wellspaced/algorithms/coarsening/quality/level_sizing.hpp"

#include <algorithm>

#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

// The area that a node takes up, in units of its spacing squared: of nodes that keep their spacing
// and have circumradii of at most that, as seen on many levels.
constexpr double kAreaOfNode = 1.25;

// The length of boundary that a node takes up, in units of its spacing. Half of the nodes there is
// counted by their areas.
constexpr double kLengthOfNode = 1.2;

constexpr double kLogStep = 2;  // of the factor, to base 2
constexpr int kMostSamples = 512;

// A third of the triangles around each node.
std::vector<double> areas_of_nodes(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.points.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    const double doubled = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    for (const Index v : {a, b, c}) areas[v] += doubled / 6;
  }
  return areas;
}

// Half of the segments at each node.
std::vector<double> lengths_of_nodes(const TriangleMesh& mesh) {
  std::vector<double> lengths(mesh.points.size(), 0);
  for (const Segment& s : mesh.segments) {
    const double half = distance(mesh.points[s.a], mesh.points[s.b]) / 2;
    lengths[s.a] += half;
    lengths[s.b] += half;
  }
  return lengths;
}

}  // namespace

LevelSizing::LevelSizing(const Level& finest, const Graph& graph, double beta,
                         std::size_t least_nodes)
    : finest_(finest),
      graph_(graph),
      beta_(beta),
      area_(areas_of_nodes(finest.mesh)),
      length_(lengths_of_nodes(finest.mesh)) {
  const double least = std::max(1.0, static_cast<double>(least_nodes));
  for (int i = 0; i < kMostSamples; ++i) {
    const double nodes = estimated_nodes(power_of_two(i * kLogStep));
    samples_.push_back({i * kLogStep, binary_logarithm(nodes)});
    if (!(nodes > least)) break;
  }
}

double LevelSizing::estimated_nodes(double factor) const {
  const std::vector<double> spacing = spacing_for(factor);
  double nodes = 0;
  for (Index v = 0; v < spacing.size(); ++v) {
    const double s = spacing[v];
    if (!(s > 0)) continue;
    nodes += std::min(1.0, area_[v] / (kAreaOfNode * s * s) + length_[v] / (2 * kLengthOfNode * s));
  }
  return nodes;
}

// Between samples by their logarithms.
double LevelSizing::factor_for(std::size_t nodes) const {
  const double log_nodes = binary_logarithm(static_cast<double>(nodes));
  const auto after = std::ranges::find_if(
      samples_, [=](const Sample& sample) { return !(sample.log_nodes > log_nodes); });
  if (after == samples_.begin()) return 1;
  if (after == samples_.end()) return power_of_two(samples_.back().log_factor);
  const Sample& before = *(after - 1);
  const double part = (before.log_nodes - log_nodes) / (before.log_nodes - after->log_nodes);
  return power_of_two(before.log_factor + part * kLogStep);
}

std::vector<double> LevelSizing::spacing_for(double factor) const {
  std::vector<double> spacing = coarsened_spacing(graph_, finest_.spacing, factor);
  for (double& value : spacing) value *= 2 / beta_;
  return spacing;
}

}  // namespace wellspaced
