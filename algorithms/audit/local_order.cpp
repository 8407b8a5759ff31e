#include "wellspaced/algorithms/audit/local_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace wellspaced::audit {
namespace {

constexpr int kBitsPerAxis = 22;
constexpr int kDigitBits = 11;

// Puts the low 22 bits at the even places.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 16) & 0x0000FFFF0000FFFFu;
  x = (x | x << 8) & 0x00FF00FF00FF00FFu;
  x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Fu;
  x = (x | x << 2) & 0x3333333333333333u;
  return (x | x << 1) & 0x5555555555555555u;
}

// Maps an interval to cells 0 .. 2^22 - 1. Halved first, so that the width cannot overflow.
class Cells {
 public:
  void include(double x) {
    low_ = std::min(low_, x / 2);
    high_ = std::max(high_, x / 2);
  }
  std::uint64_t cell(double x) const {
    const double width = high_ - low_;
    const double position = width > 0 ? (x / 2 - low_) / width : 0;
    return static_cast<std::uint64_t>(position * ((1 << kBitsPerAxis) - 1));
  }

 private:
  double low_ = 1e308, high_ = -1e308;
};

struct Keyed {
  std::uint64_t key;
  Index item;
};

// Sorts by key, equal keys as they come.
void radix_sort(std::vector<Keyed>& items) {
  std::vector<Keyed> other(items.size());
  for (int shift = 0; shift < 2 * kBitsPerAxis; shift += kDigitBits) {
    std::array<Index, (1 << kDigitBits) + 1> first{};
    const auto digit = [&](const Keyed& k) { return k.key >> shift & ((1 << kDigitBits) - 1); };
    for (const Keyed& k : items) ++first[digit(k) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const Keyed& k : items) other[first[digit(k)]++] = k;
    items.swap(other);
  }
}

std::vector<Index> along_curve(std::span<const Point2> points) {
  Cells x, y;
  for (const Point2 p : points) x.include(p.x), y.include(p.y);
  std::vector<Keyed> items;
  items.reserve(points.size());
  for (const Point2 p : points)
    items.push_back(
        {spread(x.cell(p.x)) | spread(y.cell(p.y)) << 1, static_cast<Index>(items.size())});
  radix_sort(items);
  std::vector<Index> order;
  order.reserve(items.size());
  for (const Keyed& k : items) order.push_back(k.item);
  return order;
}

Index lowest(const std::array<Index, 3>& t) { return std::min({t[0], t[1], t[2]}); }

// Sorts the triangles by their lowest node, and notes where they came from.
void order_triangles(std::vector<std::array<Index, 3>> triangles, LocalOrder& order) {
  std::vector<Index> first(order.mesh.points.size() + 1, 0);
  for (const auto& t : triangles) ++first[lowest(t) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  order.mesh.triangles.resize(triangles.size());
  order.given_triangle.resize(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    const Index place = first[lowest(triangles[t])]++;
    order.mesh.triangles[place] = triangles[t];
    order.given_triangle[place] = t;
  }
}

}  // namespace

LocalOrder local_order(const TriangleMesh& mesh) {
  LocalOrder order;
  order.given_node = along_curve(mesh.points);
  order.local_node.resize(mesh.points.size());
  order.mesh.points.reserve(mesh.points.size());
  for (const Index v : order.given_node) {
    order.local_node[v] = static_cast<Index>(order.mesh.points.size());
    order.mesh.points.push_back(mesh.points[v]);
  }
  const auto& local = order.local_node;
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({local[a], local[b], local[c]});
  order_triangles(std::move(triangles), order);
  order.mesh.segments.reserve(mesh.segments.size());
  for (const Segment& s : mesh.segments)
    order.mesh.segments.push_back({local[s.a], local[s.b], s.marker});
  return order;
}

}  // namespace wellspaced::audit
