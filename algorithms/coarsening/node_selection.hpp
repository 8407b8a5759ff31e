// Which nodes of a level go on into the next: a maximal set without conflicts, chosen greedily.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Appends to `conflicts` the nodes in conflict with `node` (itself may be among them).
using ConflictRule = std::function<void(Index node, std::vector<Index>& conflicts)>;

/// Function-based: i and j are in conflict when f(i) + f(j) > beta d_G(i, j) and d_G(i, j) is at
/// most 3 f(i) / beta, d_G being summed from i outwards.
/// f: 1-Lipschitz in the graph metric (coarsened_spacing makes it so). Then every node on a
///   shortest path to a conflict is itself in conflict, and only such nodes are searched through.
/// Requires: graph and f outlive the rule; beta > 1.
/// Cost of a call: O(k log k) for k conflicts.
/// See: sections 7.3 and 8.2, Definition 5.3.4, CHOICES 1, 2 and 18.
ConflictRule function_conflicts(const Graph& graph, std::span<const double> f, double beta);

/// MIS-based: i and j are in conflict when an edge joins them.
/// Requires: graph outlives the rule. See: section 5.2.1, Figure 5.2.
ConflictRule neighbor_conflicts(const Graph& graph);

/// The choice while it is being made. Twins are selected, or made invalid, together.
class NodeSelection {
 public:
  /// Requires: twins outlive the selection.
  NodeSelection(Index nodes, const TwinNodes& twins, ConflictRule rule);

  bool is_selected(Index v) const { return states_[v] == State::kSelected; }
  /// Neither selected nor invalid.
  bool is_free(Index v) const { return states_[v] == State::kFree; }

  /// Selects nodes whatever they conflict with, then makes all others in conflict with them
  /// invalid (CHOICES 8).
  void force(std::span<const Index> nodes);

  /// Selects v if it is free and in conflict with no selected node, and makes the nodes in
  /// conflict with it invalid.
  void select(Index v);

  /// Makes v invalid unless it is selected.
  void invalidate(Index v);

  /// The selected nodes, ascending.
  std::vector<Index> selected() const;

 private:
  enum class State : std::uint8_t { kFree, kInvalid, kSelected };

  void find_conflicts(Index v);
  void mark_selected(Index v);
  void invalidate_conflicts();

  const TwinNodes& twins_;
  ConflictRule rule_;
  std::vector<State> states_;
  std::vector<Index> conflicts_;  // of the node last looked at
};

}  // namespace wellspaced
