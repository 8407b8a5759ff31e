#include "wellspaced/algorithms/coarsening/node_selection.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "wellspaced/kernel/local_search.hpp"

namespace wellspaced {

ConflictRule function_conflicts(const Graph& graph, std::span<const double> f, double beta) {
  const auto search = std::make_shared<LocalSearch>(graph);
  return [=](Index node, std::vector<Index>& conflicts) {
    const double radius = 3 * f[node] / beta;
    search->run(
        std::array{node},
        [&](Index v, double d) { return f[node] + f[v] > beta * d && d <= radius; },
        [&](Index v, double) { return conflicts.push_back(v), true; });
  };
}

ConflictRule neighbor_conflicts(const Graph& graph) {
  return [&graph](Index node, std::vector<Index>& conflicts) {
    for (const Graph::Arc& arc : graph.arcs_of(node)) conflicts.push_back(arc.target);
  };
}

NodeSelection::NodeSelection(Index nodes, const TwinNodes& twins, ConflictRule rule)
    : twins_(twins), rule_(std::move(rule)), states_(nodes, State::kFree) {}

void NodeSelection::force(std::span<const Index> nodes) {
  for (const Index v : nodes) mark_selected(v);
  for (const Index v : nodes) {
    find_conflicts(v);
    invalidate_conflicts();
  }
}

void NodeSelection::select(Index v) {
  if (!is_free(v)) return;
  find_conflicts(v);
  const auto is_chosen = [&](Index w) { return is_selected(w); };
  if (std::any_of(conflicts_.begin(), conflicts_.end(), is_chosen)) return;
  mark_selected(v);
  invalidate_conflicts();
}

void NodeSelection::invalidate(Index v) {
  twins_.for_each(v, [&](Index w) {
    if (is_free(w)) states_[w] = State::kInvalid;
  });
}

std::vector<Index> NodeSelection::selected() const {
  std::vector<Index> nodes;
  for (Index v = 0; v < states_.size(); ++v)
    if (is_selected(v)) nodes.push_back(v);
  return nodes;
}

void NodeSelection::find_conflicts(Index v) {
  conflicts_.clear();
  twins_.for_each(v, [&](Index w) { rule_(w, conflicts_); });
}

void NodeSelection::mark_selected(Index v) {
  twins_.for_each(v, [&](Index w) { states_[w] = State::kSelected; });
}

void NodeSelection::invalidate_conflicts() {
  for (const Index w : conflicts_) invalidate(w);
}

}  // namespace wellspaced
