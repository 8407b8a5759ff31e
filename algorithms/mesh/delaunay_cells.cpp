#include "wellspaced/algorithms/mesh/delaunay_cells.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "wellspaced/algorithms/mesh/directed_edges.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sha256.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

using Triangle = std::array<Index, 3>;

// Disjoint sets of triangles; a set's name is its lowest member.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index i, Index j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<Index> parent_;
};

std::vector<std::pair<Index, Index>> sorted_ends(std::span<const Segment> segments) {
  std::vector<std::pair<Index, Index>> ends;
  for (const Segment& s : segments) ends.push_back(std::minmax(s.a, s.b));
  sort(ends);
  return ends;
}

Index corner_off_edge(const Triangle& t, Index a, Index b) {
  for (const Index v : t)
    if (v != a && v != b) return v;
  return t[0];
}

// Joins the triangles across each edge without a segment whose four points are cocircular.
Sets join_ties(std::span<const Point2> points, std::span<const Triangle> triangles,
               std::span<const Segment> segments) {
  const auto constrained = sorted_ends(segments);
  const DirectedEdges edges(triangles);
  Sets sets(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Index other = edges.triangle_of(to, from);
      if (from > to || other == kNoIndex) continue;
      if (std::binary_search(constrained.begin(), constrained.end(), std::pair(from, to))) continue;
      const Index apex = corner_off_edge(triangles[other], from, to);
      if (incircle(points[a], points[b], points[c], points[apex]) == 0) sets.join(t, other);
    }
  }
  return sets;
}

// The number of each point among the distinct ones in lexicographic order.
template <class Point>
std::vector<Index> lexicographic_ranks(std::span<const Point> points) {
  std::vector<Index> order(points.size()), rank(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order, [&](Index i, Index j) { return points[i] < points[j]; });
  Index next = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && points[order[i - 1]] < points[order[i]]) ++next;
    rank[order[i]] = next;
  }
  return rank;
}

std::string line_of(const std::vector<Index>& cell) {
  std::string line;
  for (const Index v : cell) {
    if (!line.empty()) line += ' ';
    line += std::to_string(v);
  }
  return line;
}

template <class Point>
std::string hash_cells(std::span<const Point> points, std::vector<std::vector<Index>> cells) {
  const std::vector<Index> rank = lexicographic_ranks(points);
  for (std::vector<Index>& cell : cells) {
    for (Index& v : cell) v = rank[v];
    sort_unique(cell);
  }
  sort(cells);
  Sha256 hash;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) hash.add("\n");
    hash.add(line_of(cells[i]));
  }
  return hash.finish();
}

}  // namespace

std::vector<std::vector<Index>> delaunay_cells(std::span<const Point2> points,
                                               std::span<const Triangle> triangles,
                                               std::span<const Segment> segments) {
  Sets sets = join_ties(points, triangles, segments);
  std::vector<std::vector<Index>> cells(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    std::vector<Index>& cell = cells[sets.find(t)];
    cell.insert(cell.end(), triangles[t].begin(), triangles[t].end());
  }
  std::erase_if(cells, [](const auto& cell) { return cell.empty(); });
  for (std::vector<Index>& cell : cells) sort_unique(cell);
  return cells;
}

std::string cells_sha256(std::span<const Point2> points, std::vector<std::vector<Index>> cells) {
  return hash_cells(points, std::move(cells));
}

std::string cells_sha256(std::span<const Point3> points, std::vector<std::vector<Index>> cells) {
  return hash_cells(points, std::move(cells));
}

}  // namespace wellspaced
