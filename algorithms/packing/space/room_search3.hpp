// Full maximality in space: a search for places where a ball fits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "wellspaced/algorithms/packing/space/surface_index.hpp"
#include "wellspaced/algorithms/packing/space/surface_packing.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/space/circumsphere.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced {

/// A packing as it stands: its triangulation, the ball around each vertex, what protects the
/// surface, the radius of further balls, and by how much that grows at most per unit of length.
struct Packing3 {
  const Delaunay3& delaunay;
  const std::vector<double>& radius;
  const SurfaceIndex& surface;
  const BallRadius3& radius_at;
  double slope = 0;
};

/// Searches tets for places whose balls are disjoint from all others and that lie in no protective
/// sphere.
///
/// An octree over the tet is split until one ball or one protective sphere proves each cell full,
/// or it is smaller than 2^-8 of the radius there. Only tets whose circumspheres come near the tet
/// are looked at: a vertex put in a place would be joined to corners of tets in whose circumspheres
/// the place is, and where its ball meets any other, it meets one of theirs.
/// Requires: the packing outlives it. A slope beyond 1 counts as 1.
class RoomSearch3 {
 public:
  /// Takes a ball around a place if it can; then the search is over.
  using Offer = std::function<bool(Point3 place, double radius)>;

  explicit RoomSearch3(const Packing3& packing);

  /// Offers places in tet t until one is taken. Returns whether one was.
  /// Requires: t is no ghost and not flat. Cost: next to none where the balls of the corners cover
  /// the tet by far.
  bool run(Index t, const Offer& offer);

 private:
  // A cube by half its side; and half its diagonal.
  struct Cell {
    Point3 centre;
    double half = 0;
    double reach() const { return kRootOfThree * half; }
    static constexpr double kRootOfThree = 1.7320508075688773;
  };
  struct Plane {
    Point3 on, outwards;  // a point, and the normal of length 1
    double height(Point3 p) const;
  };

  const Point3& point(Index v) const { return packing_.delaunay.points()[v]; }
  bool corners_cover(const std::array<Index, 4>& corners) const;
  Cell look_at(const std::array<Index, 4>& corners);
  void look_around(Index t, Point3 middle);
  void gather(const std::array<Index, 4>& corners, const Sphere& around);
  double farthest_out(Point3 p) const;
  double least_radius(Point3 p) const;
  bool is_full(const Cell& cell, double least) const;
  void split(const Cell& cell);

  Packing3 packing_;
  std::array<Sphere, 4> corners_;       // the balls of the tet's corners
  std::array<Plane, 4> faces_;          // its faces
  std::vector<Sphere> balls_;           // those of the vertices around
  std::vector<Sphere> guards_;          // protective spheres around
  std::vector<Index> tets_, vertices_;  // that are looked at
  std::vector<std::uint32_t> run_of_;   // for each tet the last run in which it was
  std::uint32_t runs_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace wellspaced
