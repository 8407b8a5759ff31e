#include "wellspaced/algorithms/audit/level_spacing.hpp"

#include <algorithm>
#include <functional>

#include "wellspaced/algorithms/audit/stars.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// Whether f_i + f_j exceeds beta times the distance by more than rounding explains: each of the
// edges' lengths errs by 2 units in the last place, as do the sums and the products.
bool conflict(double sum, double beta, double distance, unsigned edges) {
  return sum > beta * distance * (1 + (edges + 4) * 0x1p-52);
}

// The graph of the mesh: neighbours of each node with their distances.
class Neighbours {
 public:
  explicit Neighbours(const TriangleMesh& mesh)
      : points_(mesh.points), stars_(mesh.triangles, mesh.points.size()) {
    for (const Segment& s : mesh.segments) {
      by_segment_.push_back({s.a, s.b});
      by_segment_.push_back({s.b, s.a});
    }
    sort(by_segment_);
  }

  template <class Visit>
  void for_each(Index v, Visit visit) const {
    const auto tell = [&](Index w) { visit(w, distance(points_[v], points_[w])); };
    stars_.for_each_neighbor(v, [&](Index w, Index) { tell(w); });
    auto arc = std::lower_bound(by_segment_.begin(), by_segment_.end(), std::array{v, Index{0}});
    for (; arc != by_segment_.end() && (*arc)[0] == v; ++arc) tell((*arc)[1]);
  }

 private:
  std::span<const Point2> points_;
  Stars stars_;
  std::vector<std::array<Index, 2>> by_segment_;
};

// Dijkstra's algorithm from one node after the other, each within a radius.
class BoundedSearch {
 public:
  explicit BoundedSearch(const TriangleMesh& mesh)
      : neighbours_(mesh), label_(mesh.points.size()) {}

  // Calls visit(node, distance, edges) for all nodes within the radius, but `start`.
  template <class Visit>
  void run(Index start, double radius, Visit visit) {
    ++search_;
    heap_.clear();
    relax(start, 0, 0);
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
      const double at = heap_.back().first;
      const Index v = heap_.back().second;
      heap_.pop_back();
      if (at != label_[v].distance) continue;
      const unsigned edges = label_[v].edges;
      if (v != start) visit(v, at, edges);
      neighbours_.for_each(v, [&](Index w, double length) {
        if (at + length <= radius) relax(w, at + length, edges + 1);
      });
    }
  }

 private:
  struct Label {
    double distance = 0;
    std::uint32_t search = 0;
    unsigned edges = 0;
  };

  void relax(Index v, double distance, unsigned edges) {
    if (label_[v].search == search_ && label_[v].distance <= distance) return;
    label_[v] = {distance, search_, edges};
    heap_.push_back({distance, v});
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }

  Neighbours neighbours_;
  std::vector<Label> label_;
  std::vector<std::pair<double, Index>> heap_;
  std::uint32_t search_ = 0;
};

}  // namespace

std::vector<std::array<Index, 2>> graph_spacing_violations(const TriangleMesh& mesh,
                                                           const SelectedNodes& selected,
                                                           const Progress& progress) {
  std::vector<std::array<Index, 2>> violations;
  std::vector<Index> position(mesh.points.size(), kNoIndex);
  for (Index i = 0; i < selected.nodes.size(); ++i) position[selected.nodes[i]] = i;
  const auto exempt = [&](Index i) { return !selected.exempt.empty() && selected.exempt[i] != 0; };
  BoundedSearch search(mesh);
  ProgressMeter meter(progress, "audit", selected.nodes.size(), 1 << 9);
  for (Index i = 0; i < selected.nodes.size() && meter.step(); ++i) {
    const double f = selected.spacing[i];
    // Each pair is found from the node with the larger value, whose radius reaches the other.
    search.run(selected.nodes[i], 2 * f / selected.beta, [&](Index v, double at, unsigned edges) {
      const Index j = position[v];
      if (j == kNoIndex || (exempt(i) && exempt(j))) return;
      const double g = selected.spacing[j];
      if (g > f || (g == f && j < i)) return;
      if (conflict(f + g, selected.beta, at, edges)) violations.push_back({i, j});
    });
  }
  return violations;
}

std::vector<std::array<Index, 2>> euclidean_spacing_violations(const TriangleMesh& mesh,
                                                               std::span<const double> spacing,
                                                               double beta) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      if (conflict(spacing[a] + spacing[b], beta, distance(mesh.points[a], mesh.points[b]), 1))
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
  sort_unique(edges);
  return edges;
}

std::vector<double> coarsened_in_graph(const TriangleMesh& mesh, std::span<const double> values,
                                       double factor, const Progress& progress) {
  const Neighbours neighbours(mesh);
  std::vector<double> coarsened;
  std::vector<std::pair<double, Index>> heap;
  for (Index v = 0; v < values.size(); ++v) {
    coarsened.push_back(factor * values[v]);
    heap.push_back({coarsened[v], v});
  }
  std::make_heap(heap.begin(), heap.end(), std::greater<>());
  ProgressMeter meter(progress, "audit", 0);
  while (!heap.empty() && meter.step()) {
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    const auto [at, v] = heap.back();
    heap.pop_back();
    if (at > coarsened[v]) continue;
    neighbours.for_each(v, [&, from = at](Index w, double length) {
      if (from + length >= coarsened[w]) return;
      coarsened[w] = from + length;
      heap.push_back({coarsened[w], w});
      std::push_heap(heap.begin(), heap.end(), std::greater<>());
    });
  }
  return coarsened;
}

}  // namespace wellspaced::audit
