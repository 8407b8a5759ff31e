// The local feature size of a planar straight-line graph, plain and geodesic.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Answers how far a point is from the two nearest features that do not touch each other.
///
/// The features are the vertices and segments of the graph closed under intersection: a segment is
/// cut where it crosses another or runs through a vertex, so features are incident only where they
/// share a vertex. Coincident points are one vertex, and the two lips of a slit one chain.
///
/// The functions are infinite where no two features are apart (fewer than two vertices). They are
/// 1-Lipschitz, each in its own metric (Lemma 2.2.7), and right to a few units in the last place of
/// the extent of the graph.
/// Cost: O(n log n) to build, 70 bytes a feature; a query O(log n) for features that are spread
/// out, plus the features that share the vertex nearest by. See: Definition 2.2.5.
class LocalFeatureSize {
 public:
  /// A vertex {v, v} or a segment {a, b} of the graph.
  using Feature = std::array<Index, 2>;

  /// Errors: those of triangulate; kInvalidGeometry if the extent of the graph is no double.
  static Result<LocalFeatureSize> build(const Pslg& graph, const TriangulateOptions& options = {});

  /// The radius of the smallest ball around x that meets two features which are not incident; or
  /// `bound`, if that is less. The smaller the bound, the less is looked at.
  double at(Point2 x, double bound = std::numeric_limits<double>::infinity()) const;

  /// at() for points that come one near the other: the features that decided there bound the
  /// search. The values are the same. Requires: the LocalFeatureSize outlives it, in its place.
  class Cursor {
   public:
    explicit Cursor(const LocalFeatureSize& lfs) : lfs_(&lfs) {}
    double at(Point2 x, double bound = std::numeric_limits<double>::infinity());

   private:
    const LocalFeatureSize* lfs_;
    std::array<Index, 2> last_{kNoIndex, kNoIndex};  // features
  };

  /// The same with distances inside the domain, around holes and cracks (Definition 2.2.6); a point
  /// of a boundary belongs to both of its sides where both are in the domain. Never less than
  /// at(x). Infinite where x lies outside the domain. Cost: beside that of at(), a short walk for
  /// each feature nearer than the answer, those hidden behind a thin wall included.
  double geodesic_at(Point2 x) const;

  /// The closed graph, and which triangles are the domain.
  const PlanarTriangulation& graph() const { return graph_; }

 private:
  using Edge = Triangulation2::Edge;

  explicit LocalFeatureSize(PlanarTriangulation graph);

  // A feature in scaled coordinates: a, and the way from there to b.
  struct Stretch {
    Point2 a, unit;
    double length;

    /// The point at that distance from a.
    Point2 at(double along) const { return {a.x + along * unit.x, a.y + along * unit.y}; }
    double nearest_to(Point2 x) const;
    double distance_sq(Point2 x) const;
  };

  Point2 point(Index v) const { return graph_.delaunay.points()[v]; }
  Point2 scaled(Point2 p) const { return {scale_ * p.x, scale_ * p.y}; }
  Point2 nearest_point(std::size_t feature, Point2 x) const;

  void measure_features();
  void build_tree(std::size_t node, std::size_t first, std::size_t last);
  // Two features that are apart, and how far the farther one is; kNoIndex: none were found.
  struct Answer {
    double size = std::numeric_limits<double>::infinity();
    std::array<Index, 2> features{kNoIndex, kNoIndex};
  };
  Answer search(Point2 x, double bound) const;
  template <class Visit>
  void visit_by_distance(Point2 x, Visit visit) const;

  std::vector<Index> triangles_around(Point2 x, Index near) const;
  bool sees(Point2 x, const std::vector<Index>& around, std::size_t feature) const;
  bool reaches(Point2 x, Index triangle, Point2 target, const Feature& feature) const;
  double geodesic_from_vertex(Index v) const;

  PlanarTriangulation graph_;
  double scale_ = 1;                // a power of two that makes the extent about 1
  std::vector<Feature> features_;   // in the order of the tree's leaves
  std::vector<Stretch> stretches_;  // the same
  std::vector<Box2> around_;        // scaled; node k has the children 2k + 1 and 2k + 2
};

}  // namespace wellspaced
