#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "wellspaced/kernel/local_search.hpp"
#include "wellspaced/kernel/shortest_paths.hpp"

namespace wellspaced {
namespace {

// Sums of lengths along different paths differ by some 2^-52 an edge.
constexpr double kBeyondRounding = 1 + 0x1p-30;

void check_independence(const Graph& graph, const Level& level, double beta,
                        const Progress& progress, SelectionCheck& check) {
  std::vector<Index> number(graph.nodes(), kNoIndex);
  for (Index i = 0; i < level.origin.size(); ++i) number[level.origin[i]] = i;
  std::vector<std::uint8_t> is_fixed(level.origin.size(), 0);
  for (const Index i : level.mesh.fixed) is_fixed[i] = 1;

  LocalSearch search(graph);
  ProgressMeter meter(progress, "measure", level.origin.size(), 1 << 10);
  for (Index i = 0; i < level.origin.size() && meter.step(); ++i) {
    const double f = level.spacing[i], reach = 2 * f / beta;
    for (const Index v :
         search.run(std::array{level.origin[i]}, [=](Index, double d) { return d <= reach; })) {
      const Index j = number[v];
      // The node with the smaller value finds too few: a pair belongs to the other.
      if (j == kNoIndex || j == i || std::pair{level.spacing[j], j} > std::pair{f, i}) continue;
      if (is_fixed[i] && is_fixed[j]) continue;
      const double ratio = (f + level.spacing[j]) / (beta * search.distance(v));
      check.conflict_max = std::max(check.conflict_max, ratio);
      check.conflicts += ratio > kBeyondRounding;
    }
  }
}

// The least f(j) + d(i, j) over the nodes j of the level, for all i; and likewise the least
// d(i, j) - f(j) / beta, to which a constant is added to keep it above 0.
void check_maximality(const Graph& graph, const Level& level, double beta, ProgressParts& progress,
                      SelectionCheck& check) {
  if (level.spacing.empty()) return;
  const double most = *std::max_element(level.spacing.begin(), level.spacing.end()) / beta;
  std::vector<double> continued(graph.nodes(), HUGE_VAL), reached(graph.nodes(), HUGE_VAL);
  for (Index i = 0; i < level.origin.size(); ++i) {
    continued[level.origin[i]] = level.spacing[i];
    reached[level.origin[i]] = most - level.spacing[i] / beta;
  }
  continued = shortest_distances(graph, continued, progress.part(1));
  if (!progress.go_on(2)) return;
  reached = shortest_distances(graph, reached, progress.part(2));
  if (progress.stopped()) return;
  for (Index v = 0; v < graph.nodes(); ++v) {
    if (std::ranges::binary_search(level.origin, v) || !std::isfinite(continued[v])) continue;
    const double ratio = beta * (reached[v] - most) / continued[v];
    check.uncovered_max = std::max(check.uncovered_max, ratio);
    check.uncovered += ratio > kBeyondRounding;
  }
}

}  // namespace

SelectionCheck check_selection(const Graph& graph, const Level& level, double beta,
                               const Progress& progress) {
  SelectionCheck check;
  ProgressParts parts(progress, "measure", 3);
  check_independence(graph, level, beta, parts.part(0), check);
  if (parts.go_on(1)) check_maximality(graph, level, beta, parts, check);
  return check;
}

}  // namespace wellspaced
