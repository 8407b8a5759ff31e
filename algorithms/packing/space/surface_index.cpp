#include "wellspaced/algorithms/packing/space/surface_index.hpp"

#include <algorithm>

#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

ProtectiveSphere sphere_around(Point3 a, Point3 b) {
  const Point3 half = 0.5 * (b - a);
  return {a + half, dot(half, half)};
}

// The circumcircle of a triangle, as a sphere.
ProtectiveSphere sphere_around(Point3 a, Point3 b, Point3 c) {
  const Point3 u = b - a, v = c - a, normal = cross(u, v);
  const Point3 towards = dot(u, u) * cross(v, normal) + dot(v, v) * cross(normal, u);
  const Point3 offset = (0.5 / dot(normal, normal)) * towards;
  return {a + offset, dot(offset, offset)};
}

}  // namespace

template <std::size_t N>
Index SurfaceIndex::Table<N>::find(Index lowest, const std::array<Index, N>& others) const {
  for (Index i = first[lowest]; i < first[lowest + 1]; ++i)
    if (entries[i].others == others) return entries[i].number;
  return kNoIndex;
}

// Puts the elements, of N + 1 vertices each, into a table by their lowest vertex.
template <std::size_t N, class TableOfN>
static void fill_table(const std::vector<std::array<Index, N + 1>>& elements, Index vertices,
                       TableOfN& table) {
  table.first.assign(vertices + 1, 0);
  for (const auto& element : elements) ++table.first[element[0]];
  Index sum = 0;
  for (Index& first : table.first) first = sum += first;
  table.entries.resize(elements.size());
  for (std::size_t i = elements.size(); i-- > 0;) {
    auto& entry = table.entries[--table.first[elements[i][0]]];
    std::copy(elements[i].begin() + 1, elements[i].end(), entry.others.begin());
    entry.number = static_cast<Index>(i);
  }
}

SurfaceIndex::SurfaceIndex(const PackedSurface& surface, const std::vector<Index>& number,
                           std::span<const Point3> points) {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::array<Index, 2>> pieces;
  for (const auto& [a, b, c] : surface.triangles) {
    std::array<Index, 3> corners{number[a], number[b], number[c]};
    triangle_spheres_.push_back(
        sphere_around(points[corners[0]], points[corners[1]], points[corners[2]]));
    sort(corners);
    triangles.push_back(corners);
  }
  for (const auto& [a, b] : surface.pieces) {
    pieces.push_back({std::min(number[a], number[b]), std::max(number[a], number[b])});
    piece_spheres_.push_back(sphere_around(points[number[a]], points[number[b]]));
  }
  for (const Index v : number)
    if (v != kNoIndex) surface_vertices_ = std::max(surface_vertices_, v + 1);
  fill_table<2>(triangles, surface_vertices_, triangles_);
  fill_table<1>(pieces, surface_vertices_, pieces_);
}

Index SurfaceIndex::triangle(Index a, Index b, Index c) const {
  if (!is_on_surface(std::max({a, b, c}))) return kNoIndex;
  const Index low = std::min({a, b, c}), high = std::max({a, b, c});
  const Index middle = a ^ b ^ c ^ low ^ high;
  return triangles_.find(low, {middle, high});
}

Index SurfaceIndex::piece(Index a, Index b) const {
  if (!is_on_surface(std::max(a, b))) return kNoIndex;
  return pieces_.find(std::min(a, b), {std::max(a, b)});
}

}  // namespace wellspaced
