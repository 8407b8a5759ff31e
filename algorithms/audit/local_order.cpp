#include "wellspaced/algorithms/audit/local_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "wellspaced/kernel/large_pages.hpp"

namespace wellspaced::audit {
namespace {

constexpr int kPlaceBits = 11, kPlaceDigits = 1 << kPlaceBits, kPlaceRounds = 3;

// Puts bit i of x at place D * i.
template <int D>
std::uint64_t spread(std::uint64_t x);

template <>
std::uint64_t spread<2>(std::uint64_t x) {
  x = (x | x << 16) & 0x0000FFFF0000FFFFu;
  x = (x | x << 8) & 0x00FF00FF00FF00FFu;
  x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Fu;
  x = (x | x << 2) & 0x3333333333333333u;
  return (x | x << 1) & 0x5555555555555555u;
}

template <>
std::uint64_t spread<3>(std::uint64_t x) {
  x = (x | x << 32) & 0x001F00000000FFFFu;
  x = (x | x << 16) & 0x001F0000FF0000FFu;
  x = (x | x << 8) & 0x100F00F00F00F00Fu;
  x = (x | x << 4) & 0x10C30C30C30C30C3u;
  return (x | x << 2) & 0x1249249249249249u;
}

constexpr std::array<double, 2> coordinates(Point2 p) { return {p.x, p.y}; }
constexpr std::array<double, 3> coordinates(Point3 p) { return {p.x, p.y, p.z}; }

// Maps an interval to cells 0 .. cells - 1. Halved first, so that the width cannot overflow.
class Cells {
 public:
  void include(double x) {
    low_ = std::min(low_, x / 2);
    high_ = std::max(high_, x / 2);
  }
  std::uint64_t cell(double x, std::uint64_t cells) const {
    const double width = high_ - low_;
    const double position = width > 0 ? (x / 2 - low_) / width : 0;
    return static_cast<std::uint64_t>(position * static_cast<double>(cells - 1));
  }

 private:
  double low_ = 1e308, high_ = -1e308;
};

// What is sorted: the place on the curve (32 bits) and the node, in one word.
using PlacedNode = std::uint64_t;

// Sorts by place, equal places as they come.
void sort_by_place(LargeVector<PlacedNode>& nodes) {
  std::array<std::array<Index, kPlaceDigits>, kPlaceRounds> first{};
  const auto digit = [](PlacedNode node, int round) {
    return node >> (32 + round * kPlaceBits) & (kPlaceDigits - 1);
  };
  for (const PlacedNode node : nodes)
    for (int round = 0; round < kPlaceRounds; ++round) ++first[round][digit(node, round)];
  LargeVector<PlacedNode> other(nodes.size());
  for (int round = 0; round < kPlaceRounds; ++round) {
    Index sum = 0;
    for (Index& f : first[round]) f = (sum += f) - f;
    for (const PlacedNode node : nodes) other[first[round][digit(node, round)]++] = node;
    nodes.swap(other);
  }
}

template <class Point>
std::vector<Index> along_curve(std::span<const Point> points) {
  constexpr int kDimension = static_cast<int>(coordinates(Point{}).size());
  constexpr int kBits = 32 / kDimension;
  std::array<Cells, kDimension> axes;
  for (const Point& p : points)
    for (int i = 0; i < kDimension; ++i) axes[i].include(coordinates(p)[i]);
  LargeVector<PlacedNode> nodes;
  nodes.reserve(points.size());
  for (const Point& p : points) {
    std::uint64_t place = 0;
    for (int i = 0; i < kDimension; ++i)
      place |= spread<kDimension>(axes[i].cell(coordinates(p)[i], std::uint64_t{1} << kBits)) << i;
    nodes.push_back(place << 32 | nodes.size());
  }
  sort_by_place(nodes);
  std::vector<Index> order;
  order.reserve(nodes.size());
  for (const PlacedNode node : nodes) order.push_back(static_cast<Index>(node));
  return order;
}

// For each given node its place in the order; and the points in the order.
template <class Point>
std::vector<Index> reorder(std::span<const Point> points, std::span<const Index> given,
                           std::vector<Point>& reordered) {
  std::vector<Index> local(points.size());
  assign_large(reordered, points.size());
  for (Index k = 0; k < given.size(); ++k) {
    local[given[k]] = k;
    reordered[k] = points[given[k]];
  }
  return local;
}

template <std::size_t N>
std::array<Index, N> renumbered(std::array<Index, N> nodes, std::span<const Index> local) {
  for (Index& v : nodes) v = local[v];
  return nodes;
}

std::vector<Segment> renumbered(std::vector<Segment> segments, std::span<const Index> local) {
  for (Segment& s : segments) s = {local[s.a], local[s.b], s.marker};
  return segments;
}

// Renumbers the nodes of elements and sorts these by their lowest node; returns where they came
// from.
template <std::size_t N>
std::vector<Index> order_elements(std::span<const std::array<Index, N>> given,
                                  std::span<const Index> local,
                                  std::vector<std::array<Index, N>>& ordered) {
  const auto lowest = [](const std::array<Index, N>& nodes) {
    Index low = nodes[0];
    for (const Index v : nodes) low = std::min(low, v);
    return low;
  };
  LargeVector<std::array<Index, N>> elements;
  elements.reserve(given.size());
  std::vector<Index> first(local.size() + 1, 0), came_from;
  assign_large(came_from, given.size());
  for (const auto& nodes : given) {
    elements.push_back(renumbered(nodes, local));
    ++first[lowest(elements.back()) + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  assign_large(ordered, given.size());
  for (Index i = 0; i < elements.size(); ++i) {
    const Index place = first[lowest(elements[i])]++;
    ordered[place] = elements[i];
    came_from[place] = i;
  }
  return came_from;
}

}  // namespace

LocalOrder local_order(const TriangleMesh& mesh) {
  LocalOrder order;
  order.given_node = along_curve<Point2>(mesh.points);
  order.local_node = reorder<Point2>(mesh.points, order.given_node, order.mesh.points);
  order.given_triangle = order_elements<3>(mesh.triangles, order.local_node, order.mesh.triangles);
  order.mesh.segments = renumbered(mesh.segments, order.local_node);
  return order;
}

TetLocalOrder local_order(const TetMesh& mesh) {
  TetLocalOrder order;
  order.given_node = along_curve<Point3>(mesh.points);
  const std::vector<Index> local =
      reorder<Point3>(mesh.points, order.given_node, order.mesh.points);
  order.given_tet = order_elements<4>(mesh.tets, local, order.mesh.tets);
  order.mesh.facets = mesh.facets;
  for (TetMesh::Facet& facet : order.mesh.facets) facet.points = renumbered(facet.points, local);
  order.mesh.segments = renumbered(mesh.segments, local);
  return order;
}

}  // namespace wellspaced::audit
