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

/// A workspace for searches from few nodes that end early: starting the next search costs nothing
/// but a stamp, whatever the size of the graph.
///
/// The distances are those of Dijkstra's algorithm, summed from the sources outwards. They are
/// found by correction (Moore 1959): nodes wait in a queue, not a heap, and wait again when a
/// shorter path to them turns up. In the neighbourhoods of a mesh that is rare, and no order is
/// kept. A search that grows large goes on in order of distance, with a heap; the distances are the
/// same.
/// Requires: the graph outlives the workspace. Memory: 16 bytes a node.
class LocalSearch {
 public:
  explicit LocalSearch(const Graph& graph) : graph_(graph), labels_(graph.nodes()) {}

  /// Reaches the sources, at distance 0, and every node that a path through reached nodes leads to
  /// over acceptable distances.
  /// accept(v, distance): whether v may be reached at this distance. Requires: what is accepted at
  ///   a distance is accepted at any shorter one.
  /// Returns: the nodes reached, each once; valid until the next search.
  /// Cost: proportional to the k nodes reached and their degrees where these are few, O(k log k)
  ///   where they are many.
  template <class Accept>
  std::span<const Index> run(std::span<const Index> sources, Accept accept) {
    ++search_;
    reached_.clear();
    queue_.clear();
    for (const Index s : sources)
      if (improves(s, 0)) label(s, 0);
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      if (next == kLargeSearch) {
        go_on_by_distance(next, accept);
        break;
      }
      follow_arcs(queue_[next], accept);
    }
    return reached_;
  }

  /// The distance of a node that the last search reached.
  double distance(Index v) const { return labels_[v].distance; }

  /// Adds to the nodes that the last search reached those beside them, at no known distance.
  /// Returns: all of them, each once; valid until the next search.
  std::span<const Index> include_frontier() {
    const std::size_t inside = reached_.size();
    for (std::size_t i = 0; i < inside; ++i)
      for (const Graph::Arc& arc : graph_.arcs_of(reached_[i]))
        if (labels_[arc.target].search != search_) label(arc.target, 0);
    return reached_;
  }

 private:
  struct Label {
    double distance = 0;
    std::uint64_t search = 0;  // the search that set it
  };

  bool improves(Index v, double distance) const {
    return labels_[v].search != search_ || distance < labels_[v].distance;
  }
  void label(Index v, double distance) {
    if (labels_[v].search != search_) reached_.push_back(v);
    labels_[v] = {distance, search_};
    queue_.push_back(v);
  }

  template <class Accept>
  void follow_arcs(Index v, Accept& accept) {
    const double d = distance(v);
    for (const auto& [w, length] : graph_.arcs_of(v)) {
      const double through_v = d + length;
      if (improves(w, through_v) && accept(w, through_v)) label(w, through_v);
    }
  }

  // Dijkstra's algorithm from the nodes that wait in the queue, from position `next` on. A node
  // waits once more for every shorter path to it; what a shorter path has outdated is left out.
  template <class Accept>
  void go_on_by_distance(std::size_t next, Accept& accept) {
    heap_.clear();
    while (next < queue_.size() || !heap_.empty()) {
      for (; next < queue_.size(); ++next) {
        heap_.emplace_back(distance(queue_[next]), queue_[next]);
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
      }
      std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
      const auto [d, v] = heap_.back();
      heap_.pop_back();
      if (d == distance(v)) follow_arcs(v, accept);
    }
  }

  static constexpr std::size_t kLargeSearch = 1024;

  const Graph& graph_;
  std::vector<Label> labels_;
  std::vector<Index> reached_, queue_;
  std::vector<std::pair<double, Index>> heap_;
  std::uint64_t search_ = 0;
};

}  // namespace wellspaced
