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
  const ProtectiveSphere& sphere_of_triangle(Index triangle) const {
    return triangle_spheres_[triangle];
  }
  const ProtectiveSphere& sphere_of_piece(Index piece) const { return piece_spheres_[piece]; }

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

}  // namespace wellspaced
