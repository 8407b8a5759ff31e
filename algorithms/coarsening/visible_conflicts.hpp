// Conflicts of nodes that see each other (Definition 5.3.4).
#pragma once

#include <span>

#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/algorithms/mesh/visibility.hpp"
#include "wellspaced/kernel/graph.hpp"

namespace wellspaced {

/// i and j are in conflict when f(i) + f(j) > beta |i - j| and they see each other inside the
/// domain, or an edge of the mesh joins them.
/// f: 1-Lipschitz along lines of sight, so that conflicts lie within 2 f(i) / (beta - 1)
///   (Lemma 6.3.1).
/// Requires: visibility, graph and f outlive the rule; beta > 1. The rule is asked by one thread.
/// Cost of a call: that of SightSearch within that radius.
ConflictRule visible_conflicts(const Visibility& visibility, const Graph& graph,
                               std::span<const double> f, double beta);

}  // namespace wellspaced
