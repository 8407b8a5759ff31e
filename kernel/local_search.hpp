// Many small shortest-path searches in one graph, each through a few nodes only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A workspace for Dijkstra searches from few nodes that end early: starting the next search costs
/// nothing but a stamp, whatever the size of the graph.
/// Requires: the graph outlives the workspace. Memory: 16 bytes a node.
class LocalSearch {
 public:
  explicit LocalSearch(const Graph& graph) : graph_(graph), labels_(graph.nodes()) {}

  /// Settles nodes in order of their distance from the nearest source; equal distances by number.
  /// accept(v, distance): whether v is to be labelled with this distance, and so be settled later;
  ///   asked again whenever a shorter path to v is found. Sources are accepted unasked.
  /// settle(v, distance): told the final distance; returns false to end the search there, before
  ///   the arcs of v are followed.
  /// Cost: O(k log k) for k labelled nodes of bounded degree.
  template <class Accept, class Settle>
  void run(std::span<const Index> sources, Accept accept, Settle settle) {
    start();
    for (const Index s : sources)
      if (improves(s, 0)) label(s, 0);
    while (!queue_.empty()) {
      const auto [d, v] = pop();
      if (d != labels_[v].distance) continue;  // an entry that a shorter path has outdated
      if (!settle(v, d)) return;
      for (const auto& [w, length] : graph_.arcs_of(v)) {
        const double through_v = d + length;
        if (improves(w, through_v) && accept(w, through_v)) label(w, through_v);
      }
    }
  }

  /// The nodes that the last search labelled.
  std::size_t labelled() const { return labelled_; }

 private:
  struct Label {
    double distance = 0;
    std::uint64_t search = 0;  // the search that set it
  };
  using Entry = std::pair<double, Index>;

  void start() {
    ++search_;
    labelled_ = 0;
    queue_.clear();
  }
  bool improves(Index v, double distance) const {
    return labels_[v].search != search_ || distance < labels_[v].distance;
  }
  void label(Index v, double distance) {
    if (labels_[v].search != search_) ++labelled_;
    labels_[v] = {distance, search_};
    queue_.emplace_back(distance, v);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
  }
  Entry pop() {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const Entry entry = queue_.back();
    queue_.pop_back();
    return entry;
  }

  const Graph& graph_;
  std::vector<Label> labels_;
  std::vector<Entry> queue_;
  std::uint64_t search_ = 0;
  std::size_t labelled_ = 0;
};

}  // namespace wellspaced
