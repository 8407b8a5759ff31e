#include "wellspaced/algorithms/coarsening/visible_conflicts.hpp"

#include <memory>

#include "wellspaced/algorithms/mesh/sight_search.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

// f may exceed its Lipschitz bound by rounding errors.
constexpr double kReachMargin = 1 + 0x1p-20;

}  // namespace

ConflictRule visible_conflicts(const Visibility& visibility, const Graph& graph,
                               std::span<const double> f, double beta) {
  const auto search = std::make_shared<SightSearch>(visibility);
  const std::span<const Point2> points = visibility.mesh().points;
  return [=, &graph](Index node, std::vector<Conflict>& conflicts) {
    const auto add = [&](Index v, double d) {
      if (f[node] + f[v] > beta * d) conflicts.push_back({v});
    };
    for (const Index v : search->run(node, kReachMargin * 2 * f[node] / (beta - 1)))
      add(v, distance(points[node], points[v]));
    for (const Graph::Arc& arc : graph.arcs_of(node)) add(arc.target, arc.length);
  };
}

}  // namespace wellspaced
