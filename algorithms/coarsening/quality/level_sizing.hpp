// Which coarsening factor gives a level about so many nodes.
#pragma once

#include <cstddef>
#include <vector>

#include "wellspaced/algorithms/coarsening/hierarchy.hpp"
#include "wellspaced/kernel/graph.hpp"

namespace wellspaced {

/// Estimates the nodes of levels spaced by 2 f / beta, f the coarsening function f_{g,C} of the
/// finest level in its graph metric.
class LevelSizing {
 public:
  /// Covers levels down to `least_nodes`. Requires: finest, whose graph it is, and graph outlive
  /// it. Cost: a coarsening function for every power of 4 among the factors.
  LevelSizing(const Level& finest, const Graph& graph, double beta, std::size_t least_nodes);

  /// The factor C for a number of nodes: the larger the fewer nodes.
  double factor_for(std::size_t nodes) const;
  /// How far apart the nodes of a level are to be, by node of the finest level.
  std::vector<double> spacing_for(double factor) const;

 private:
  double estimated_nodes(double factor) const;

  const Level& finest_;
  const Graph& graph_;
  double beta_;
  std::vector<double> area_, length_;  // of the domain and its boundary, by node
  struct Sample {
    double log_factor, log_nodes;
  };
  std::vector<Sample> samples_;
};

}  // namespace wellspaced
