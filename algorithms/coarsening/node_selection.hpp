// Which nodes of a level go on into the next: a maximal set without conflicts, chosen greedily.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/local_search.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A node that another is, or nearly is, in conflict with. Nearly: not by the rule as asked from
/// the other's side, but perhaps, by a rounding error, as asked from its own.
struct Conflict {
  Index node = 0;
  bool holds = true;
};

/// Appends the conflicts of a node, itself possibly among them.
using ConflictRule = std::function<void(Index node, std::vector<Conflict>& conflicts)>;

/// Function-based: i and j are in conflict when f(i) + f(j) > beta d_G(i, j) and d_G(i, j) is at
/// most 3 f(i) / beta, d_G being summed from i outwards.
/// f: 1-Lipschitz in the graph metric (coarsened_spacing makes it so). Then every node on a
///   shortest path to a conflict is itself in conflict, and only such nodes are searched through.
/// search: in the graph of the metric. Requires: search and f outlive the rule; beta > 1.
/// Cost of a call: O(k log k) for k conflicts.
/// See: sections 7.3 and 8.2, Definition 5.3.4, CHOICES 1, 2 and 18.
ConflictRule function_conflicts(LocalSearch& search, std::span<const double> f, double beta);

/// MIS-based: i and j are in conflict when an edge joins them.
/// Requires: graph outlives the rule. See: section 5.2.1, Figure 5.2.
ConflictRule neighbor_conflicts(const Graph& graph);

/// The choice while it is being made. Twins are selected, or made invalid, together.
class NodeSelection {
 public:
  /// No keys: nodes come in the order of their numbers.
  static constexpr std::span<const std::uint64_t> kByNumber{};

  /// Told of every node whose turn comes before it is invalid.
  using Considered = std::function<void(Index node)>;

  /// Requires: twins outlive the selection.
  NodeSelection(Index nodes, const TwinNodes& twins, ConflictRule rule, Considered considered = {});

  bool is_selected(Index v) const { return states_[v] == State::kSelected; }
  /// Neither selected nor invalid.
  bool is_free(Index v) const { return states_[v] <= State::kCandidate; }

  /// Asked now and then, after so much work that an answer costs nothing beside it; false to stop,
  /// with the choice unfinished. Empty: nobody is asked.
  using KeepGoing = std::function<bool()>;

  /// Selects nodes whatever they conflict with, then makes all others in conflict with them
  /// invalid (CHOICES 8). Returns: false when told to stop.
  bool force(std::span<const Index> nodes, const KeepGoing& keep_going = {});

  /// Considers nodes in ascending order of their keys: one that is free and in conflict with no
  /// selected node is selected, and makes those in conflict with it invalid. No node that was
  /// considered is free afterwards.
  ///
  /// The order is kept in effect only. A node's fate depends on the nodes in conflict with it that
  /// come before it, and theirs on others near by; so the nodes are taken as they lie in memory,
  /// and each is decided as soon as those before it are.
  /// keys: one a node of the mesh, all different, or kByNumber; twins come with the lower of
  /// theirs. Returns: false when told to stop.
  bool select(std::span<const Index> nodes, std::span<const std::uint64_t> keys,
              const KeepGoing& keep_going);

  /// Makes v invalid unless it is selected.
  void invalidate(Index v);

  /// The selected nodes, ascending.
  std::vector<Index> selected() const;

 private:
  enum class State : std::uint8_t { kFree, kCandidate, kInvalid, kSelected };

  // A candidate that waits for those before it among its conflicts, which are those from
  // `conflicts` on in the pool.
  struct Waiting {
    Index node = 0;
    std::uint64_t key = 0;
    std::size_t conflicts = 0;
    std::size_t next = 0;
  };

  std::uint64_t key_of(Index v, std::span<const std::uint64_t> keys) const;
  void wait_for(Index v, std::span<const std::uint64_t> keys);
  void decide(Index v, std::span<const std::uint64_t> keys);
  Index conflict_before(Waiting& waiting, std::span<const std::uint64_t> keys) const;
  void consider(Index v, std::size_t conflicts);
  void find_conflicts(Index v);
  void mark_selected(Index v);
  void invalidate_conflicts(std::size_t conflicts);
  bool goes_on(const KeepGoing& keep_going);

  const TwinNodes& twins_;
  ConflictRule rule_;
  Considered considered_;
  std::vector<State> states_;
  std::vector<Waiting> waiting_;
  std::vector<Conflict> pool_;
  std::size_t work_ = 0;  // conflicts looked at since keep_going was asked
};

}  // namespace wellspaced
