// Plain mesh structs: what every algorithm takes and returns.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace wellspaced {

/// Number of a point, triangle or tetrahedron: 0-based.
using Index = std::uint32_t;
inline constexpr Index kNoIndex = 0xFFFFFFFFu;

/// Points compare lexicographically.
struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
  friend auto operator<=>(const Point2&, const Point2&) = default;
};

struct Point3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
  friend auto operator<=>(const Point3&, const Point3&) = default;
};

/// A straight segment between two points, with its marker (0: none).
struct Segment {
  Index a = 0, b = 0;
  int marker = 0;
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// The mesh M = (P, T, B) of section 2.1, with the special points F of section 8.2.
///
/// triangles: counter-clockwise triples of point numbers.
/// segments: the mesh edges that lie on the boundary description: outer boundary, holes, cracks
///   and internal interfaces. A slit is two coincident chains of boundary segments on distinct,
///   pairwise coincident points.
/// point_markers: empty, or one a point.
/// fixed: the special points F, which coarsening never drops; ascending.
struct TriangleMesh {
  std::vector<Point2> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Segment> segments;
  std::vector<int> point_markers;
  std::vector<Index> fixed;
};

/// A planar straight-line graph: the description of a domain (Definition 2.1.1).
///
/// holes: one point in each region to leave out. regions: one point in each region that has an
/// attribute, and optionally a largest triangle area (negative: none).
struct Pslg {
  struct Region {
    Point2 seed;
    double attribute = 0;
    double max_area = -1;
  };
  std::vector<Point2> points;
  std::vector<Segment> segments;
  std::vector<Point2> holes;
  std::vector<Region> regions;
  std::vector<int> point_markers;
};

/// A tetrahedral mesh. A tet (a, b, c, d) is positive when det[b-a, c-a, d-a] > 0 (the convention
/// of VTK; Shewchuk's orient3d(a, b, c, d) is then negative).
///
/// facets: the mesh facets that lie on the boundary description, each with a marker.
struct TetMesh {
  struct Facet {
    std::array<Index, 3> points{};
    int marker = 0;
    friend bool operator==(const Facet&, const Facet&) = default;
  };
  std::vector<Point3> points;
  std::vector<std::array<Index, 4>> tets;
  std::vector<Facet> facets;
  std::vector<Segment> segments;
  std::vector<int> point_markers;
};

/// A piecewise linear system: the description of a domain in space (Definition 4.2.1).
///
/// facets: flat; each is bounded by its polygons, in any order and direction. A polygon of two
///   points is a segment in the facet, one of one point an isolated point in it. Facet::holes: one
///   point in each part of the facet to leave out.
/// segments: those that bound no facet; points may lie anywhere.
/// holes, regions: as in Pslg, a volume for the area.
struct Pls {
  struct Facet {
    std::vector<std::vector<Index>> polygons;
    std::vector<Point3> holes;
    int marker = 0;
    friend bool operator==(const Facet&, const Facet&) = default;
  };
  struct Region {
    Point3 seed;
    double attribute = 0;
    double max_volume = -1;
    friend bool operator==(const Region&, const Region&) = default;
  };
  std::vector<Point3> points;
  std::vector<Facet> facets;
  std::vector<Segment> segments;
  std::vector<Point3> holes;
  std::vector<Region> regions;
  std::vector<int> point_markers;
};

}  // namespace wellspaced
