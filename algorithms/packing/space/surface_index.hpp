// The pieces of a packed surface by their corners, with the spheres that protect them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "wellspaced/algorithms/packing/space/surface_packing.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A sphere by the square of its radius.
struct ProtectiveSphere {
  Point3 centre;
  double radius_sq = 0;

  bool holds(Point3 p) const {
    const double x = p.x - centre.x, y = p.y - centre.y, z = p.z - centre.z;
    return x * x + y * y + z * z < radius_sq;
  }
};

/// Finds triangles and pieces of segments by their corners. Their protective spheres are the
/// smallest through the corners (Definition 4.3.2), in floating point.
/// Cost: O(n) to build for bounded degrees; a search is linear in the degree of its lowest corner.
class SurfaceIndex {
 public:
  SurfaceIndex(const PackedSurface& surface, const std::vector<Index>& number,
               std::span<const Point3> points);

  /// The number of the triangle in the surface; kNoIndex if there is none.
  Index triangle(Index a, Index b, Index c) const;
  /// The number of the piece in the surface; kNoIndex if there is none.
  Index piece(Index a, Index b) const;

  /// Whether a triangle or piece may start in vertex v: corners are asked for in vain else.
  bool is_on_surface(Index v) const { return v < surface_vertices_; }

  /// Whether `test` holds for the protective sphere of a face or edge of a tet.
  template <class Test>
  bool any_sphere(const std::array<Index, 4>& corners, Test test) const;

 private:
  template <std::size_t N>
  struct Entry {
    std::array<Index, N> others;  // the corners above the lowest, ascending
    Index number;
  };
  template <std::size_t N>
  struct Table {
    std::vector<Index> first;
    std::vector<Entry<N>> entries;
    Index find(Index lowest, const std::array<Index, N>& others) const;
  };

  Index surface_vertices_ = 0;
  Table<2> triangles_;
  Table<1> pieces_;
  std::vector<ProtectiveSphere> triangle_spheres_, piece_spheres_;
};

template <class Test>
bool SurfaceIndex::any_sphere(const std::array<Index, 4>& corners, Test test) const {
  std::array<Index, 4> on{};
  std::size_t count = 0;
  for (const Index v : corners)
    if (is_on_surface(v)) on[count++] = v;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Index edge = piece(on[i], on[j]);
      if (edge != kNoIndex && test(piece_spheres_[edge])) return true;
      for (std::size_t k = 0; k < j; ++k) {
        const Index face = triangle(on[i], on[j], on[k]);
        if (face != kNoIndex && test(triangle_spheres_[face])) return true;
      }
    }
  return false;
}

}  // namespace wellspaced
