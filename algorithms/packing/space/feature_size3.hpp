// The local feature size of a domain in space.
#pragma once

#include <array>
#include <vector>

#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/space/box3.hpp"

namespace wellspaced {

/// Answers how far a point is from the two nearest polytopes that do not touch each other.
///
/// Polytopes are the vertices, segments and facets of the complex. Two touch if they have a vertex
/// of the complex in common, as any two do that intersect in a piecewise linear system. A facet
/// that is not convex counts as the triangles that cover it, which touch each other and all that
/// the facet contains; so it is seen where it comes near to what it touches elsewhere.
///
/// The function is infinite where no two polytopes are apart. It is 1-Lipschitz, and right to a few
/// units in the last place of the extent of the complex.
/// Requires: the complex outlives it, in its place; coordinates whose cubes are doubles.
/// Cost: O(n log n) to build; a query O(log n) for polytopes that are spread out, plus those that
/// touch the vertex nearest by. See: Definition 2.2.5, section 4.2.
class FeatureSize3 {
 public:
  /// progress: phase "sort"; told to stop, the object is of no use.
  explicit FeatureSize3(const PolyhedralComplex& complex, const Progress& progress = {});

  /// A vertex (dimension 0), segment (1) or part of a facet (2).
  struct Feature {
    unsigned dimension = 0;
    Index number = 0;  ///< of the point, segment or facet
    friend bool operator==(const Feature&, const Feature&) = default;
  };

  /// The radius of the smallest ball around x that meets two features which do not touch.
  double at(Point3 x) const;

  /// at() for points that come one near the other: it remembers the features around the last few
  /// places. The values are the same but for rounding. Requires: the FeatureSize3 outlives it, in
  /// its place.
  class Cursor {
   public:
    explicit Cursor(const FeatureSize3& size) : size_(&size) {}
    double at(Point3 x);

    /// The smaller of at(x) and `cap`: in no time where the cap is far below.
    double capped(Point3 x, double cap);

   private:
    struct Place {
      Point3 centre;
      double size = 0;       // at the centre
      double reach_sq = -1;  // how far from the centre, squared, its items will do
      std::vector<Index> items;
    };
    const Place& place_of(Point3 x);
    double at_near(const Place& place, Point3 x) const;
    void explore(Point3 x, Place& place) const;

    const FeatureSize3* size_;
    std::vector<Place> places_;  // the latest first
  };

  /// Two features that should be apart and are not: no further from each other than `within`.
  struct Contact {
    Feature a, b;
  };
  /// The vertices and segments that come within a distance of something that they do not touch; at
  /// most `most` of them. Facets cannot meet otherwise, but for those that touch.
  /// progress: phase "contacts"; told to stop, what was found by then.
  std::vector<Contact> contacts(double within, std::size_t most,
                                const Progress& progress = {}) const;

 private:
  // What the tree holds: a point, a segment or a triangle.
  struct Item {
    Feature feature;
    std::array<Index, 3> corners{};  // the last is repeated
  };
  // An item as places: the shape that distances are measured from.
  struct Shape {
    unsigned dimension = 0;
    Point3 a, ab, ac;

    double distance_sq(Point3 x) const;
  };
  class Touching;

  Shape shape_of(const Item& item) const;
  void build_tree(std::size_t node, std::size_t first, std::size_t last, ProgressMeter& meter);
  Box3 box_of(const Item& item) const;
  bool touch(const Item& x, const Item& y) const;
  bool touches_facet(const Item& x, const Item& facet) const;
  bool facets_touch(const Item& x, const Item& y) const;
  template <class Visit>
  void visit_by_distance(Point3 x, Visit visit) const;
  template <class Visit>
  void visit_near(const Box3& box, double within, Visit visit) const;
  double distance_between(const Item& x, const Item& y) const;

  const PolyhedralComplex* complex_;
  std::vector<std::vector<Index>> touching_facets_;  // for each facet, ascending
  std::vector<Item> items_;                          // in the order of the tree's leaves
  std::vector<Shape> shapes_;                        // the same
  std::vector<Box3> around_;                         // node k has the children 2k + 1 and 2k + 2
};

}  // namespace wellspaced
