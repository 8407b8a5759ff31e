#include "wellspaced/algorithms/audit/local_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace wellspaced::audit {
namespace {

constexpr int kDigitBits = 11;

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

struct Keyed {
  std::uint64_t key;
  Index item;
};

// Sorts by key, equal keys as they come.
void radix_sort(std::vector<Keyed>& items, int bits) {
  std::vector<Keyed> other(items.size());
  for (int shift = 0; shift < bits; shift += kDigitBits) {
    std::array<Index, (1 << kDigitBits) + 1> first{};
    const auto digit = [&](const Keyed& k) { return k.key >> shift & ((1 << kDigitBits) - 1); };
    for (const Keyed& k : items) ++first[digit(k) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const Keyed& k : items) other[first[digit(k)]++] = k;
    items.swap(other);
  }
}

template <class Point>
std::vector<Index> along_curve(std::span<const Point> points) {
  constexpr int kDimension = static_cast<int>(coordinates(Point{}).size());
  constexpr int kBits = kDimension == 2 ? 22 : 14;
  std::array<Cells, kDimension> axes;
  for (const Point& p : points)
    for (int i = 0; i < kDimension; ++i) axes[i].include(coordinates(p)[i]);
  std::vector<Keyed> items;
  items.reserve(points.size());
  for (const Point& p : points) {
    std::uint64_t key = 0;
    for (int i = 0; i < kDimension; ++i)
      key |= spread<kDimension>(axes[i].cell(coordinates(p)[i], std::uint64_t{1} << kBits)) << i;
    items.push_back({key, static_cast<Index>(items.size())});
  }
  radix_sort(items, kDimension * kBits);
  std::vector<Index> order;
  order.reserve(items.size());
  for (const Keyed& k : items) order.push_back(k.item);
  return order;
}

// For each given node its place in the order; and the points in the order.
template <class Point>
std::vector<Index> reorder(std::span<const Point> points, std::span<const Index> given,
                           std::vector<Point>& reordered) {
  std::vector<Index> local(points.size());
  reordered.reserve(points.size());
  for (const Index v : given) {
    local[v] = static_cast<Index>(reordered.size());
    reordered.push_back(points[v]);
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
    return *std::min_element(nodes.begin(), nodes.end());
  };
  std::vector<std::array<Index, N>> elements;
  elements.reserve(given.size());
  std::vector<Index> first(local.size() + 1, 0), came_from(given.size());
  for (const auto& nodes : given) {
    elements.push_back(renumbered(nodes, local));
    ++first[lowest(elements.back()) + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  ordered.resize(given.size());
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
