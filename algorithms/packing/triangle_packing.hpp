// The triangulation of a domain while points are packed into it. For the .cpp files beside it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/packing/interior_packing.hpp"
#include "wellspaced/kernel/plane/circumcircle.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"

namespace wellspaced {

/// A constrained Delaunay triangulation that knows which triangles are inside, the balls around its
/// vertices, and whose piece every constrained edge is.
///
/// Four far vertices surround the domain, so that no piece lies on the hull.
class TrianglePacking {
 public:
  using Edge = Delaunay2::Edge;
  using Corners = std::array<Index, 3>;

  static Result<TrianglePacking> start(const PackedBoundary& boundary,
                                       const InteriorOptions& options);

  const Delaunay2& delaunay() const { return delaunay_; }
  Point2 point(Index v) const { return delaunay_.points()[v]; }
  double radius(Index v) const { return radius_[v]; }
  double radius_at(Point2 p) const { return options_->radius(p); }
  double slope() const { return options_->slope; }
  BallPlacement placement() const { return options_->placement; }
  bool stays_far(Point2 p, double distance) const {
    return !options_->is_far || options_->is_far(p, distance);
  }
  bool is_inside(Index t) const { return zones_[zone_of_[t]].is_inside; }
  const Zone& zone(Index t) const { return zones_[zone_of_[t]]; }
  Circle circle_of(const Corners& corners) const {
    return circumcircle(point(corners[0]), point(corners[1]), point(corners[2]));
  }

  /// Where a walk from triangle t to p ends: at the triangle that contains p, or before the
  /// constrained edge that hides it. Both kNoIndex if p is not finite.
  struct Walk {
    Index triangle = kNoIndex;
    Edge wall;
  };
  Walk walk(Index t, Point2 p) const;

  /// Adds p, in triangle t, with its ball if this is disjoint from the others and p in no
  /// protective circle. Returns the new vertex or kNoIndex.
  Index add_ball(Point2 p, Index t, double radius);

  /// Adds p, in triangle t, if it is at least `clearance` from the vertices around and in no
  /// protective circle; if it is in one, `wall` receives that edge.
  Index add_point(Point2 p, Index t, double clearance, Edge& wall);

  /// Splits a piece. Returns the new vertex, or kNoIndex if it is fixed or would become shorter
  /// than `clearance`.
  Index split(Edge wall, double clearance);

  /// Whether the edge joins two points of two segments that meet at a sharp corner, equally far
  /// from it: the triangle behind it cannot be improved.
  bool spans_sharp_corner(Index p, Index q) const;

  /// Twice the area of a triangle.
  double doubled_area(Index t) const;

  /// The mesh as it is now. Afterwards no more points can be added.
  PackedInterior result();

 private:
  TrianglePacking(Delaunay2 delaunay, const PackedBoundary& boundary,
                  const InteriorOptions& options)
      : delaunay_(std::move(delaunay)), boundary_(&boundary), options_(&options) {}

  Status insert_pieces(ProgressMeter& meter);
  void index_pieces();
  void find_zones();
  bool is_chord(Edge e) const;
  Index flood(Index first, Index zone);
  const BoundaryPiece* initial_piece(Index a, Index b) const;
  Index segment_of(Index a, Index b) const;
  bool is_sharp(Index v) const;
  double split_fraction(const Segment& segment, Index a, Index b) const;
  template <class Clearance>
  Index add(Point2 p, Index t, Clearance clearance, Edge& wall);
  void remember(double radius, Index segment);
  void adopt_star(Index v, Index zone);
  void adopt_split(Index v, Index b, Index left_zone, Index right_zone);
  void release_chords();
  void collect_segments(std::span<const Index> number, std::vector<Segment>& segments) const;

  Delaunay2 delaunay_;
  const PackedBoundary* boundary_;
  const InteriorOptions* options_;
  std::vector<BoundaryPiece> pieces_;  // the initial ones, a < b, ascending
  std::vector<Index> segment_of_;      // for each vertex in the interior of a segment, that
  std::vector<double> radius_;         // for each vertex
  std::vector<Zone> zones_;
  std::vector<Index> zone_of_;  // for each triangle
};

/// Adds points until none fits anywhere: candidates are the centres of the cells of quadtrees, one
/// over each triangle, or places near them if balls are to be kGeneric. Cells are split until a
/// ball, a protective circle or what balls stay far from proves them full, or they are smaller than
/// 2^-12 of the radius there. Returns the number of points added; `stop` is asked now and then.
std::size_t fill_completely(TrianglePacking& packing, const std::function<bool()>& stop);

}  // namespace wellspaced
