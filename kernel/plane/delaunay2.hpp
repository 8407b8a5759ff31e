// Delaunay and constrained Delaunay triangulation of the plane: exact, incremental, dynamic.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/triangulation2.hpp"
#include "wellspaced/kernel/point_order.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// A constrained Delaunay triangulation of the convex hull of its points.
///
/// Vertices are numbered as the input points are. A point with the coordinates of another is no
/// vertex: representative() names the one that stands for it, the lowest of them. Fewer than three
/// points, or collinear ones, give no triangle: dimension() says so.
///
/// Triangle numbers and edges die with every change of the triangulation; vertex numbers stay.
class Delaunay2 {
 public:
  using Edge = Triangulation2::Edge;

  /// Where a point lies. kOutside: beyond the hull edge of the ghost triangle `edge.triangle`.
  enum class Place { kFace, kEdge, kVertex, kOutside };
  struct Location {
    Place place = Place::kOutside;
    /// kFace: some edge of the triangle; kEdge: the edge; kVertex: an edge that leaves the vertex;
    /// kOutside: the hull edge, seen from its ghost triangle.
    Edge edge;
  };

  struct Options {
    Progress progress = {};  ///< phase "triangulate"; done: points
    /// How many threads may work, the caller's among them; beyond eight none is used. The result
    /// does not depend on it, not even in the numbers of triangles.
    unsigned threads = 1;
  };

  /// The Delaunay triangulation of `points`: exact. Ties (cocircular points) are broken by the
  /// order of insertion, which depends on the points and their numbers alone.
  /// Errors: kInvalidGeometry for a NaN or infinite coordinate (ids: the points); kLimit beyond
  /// 2^28 points; kCancelled.
  /// Cost: O(n log n) expected time for every input; 72 bytes a point kept and about 77 at the
  /// peak.
  static Result<Delaunay2> build(std::span<const Point2> points, const Options& options);
  static Result<Delaunay2> build(std::span<const Point2> points) {
    return build(points, Options());
  }

  /// The same, for points that were brought into order along a curve before: along_curve holds each
  /// point number once. Only ties may be broken differently. Cost: without a sort.
  static Result<Delaunay2> build(std::span<const Point2> points,
                                 std::span<const Index> along_curve);

  /// -1: no point; 0: all points are equal; 1: all are collinear; 2.
  int dimension() const { return dimension_; }
  const std::vector<Point2>& points() const { return points_; }
  /// Whose third corner may be Triangulation2::kGhost. Empty below dimension 2.
  const Triangulation2& topology() const { return topology_; }

  /// The vertex that stands for a point: itself unless it is a duplicate; kNoIndex if it was a
  /// vertex and has been removed.
  Index representative(Index point) const {
    return representative_.empty() ? point : representative_[point];
  }
  std::size_t duplicate_count() const { return duplicate_count_; }
  /// Whether the point is a vertex: no duplicate, and not removed.
  bool is_vertex(Index point) const { return representative(point) == point; }

  /// Where p lies. `hint` is a triangle to start from (any number will do).
  /// Requires: dimension() == 2.
  /// Cost: O(sqrt n) expected from afar, O(1) from near by.
  Location locate(Point2 p, Index hint = 0) const;

  /// Some edge that leaves vertex v; triangle == kNoIndex if v is a duplicate or dimension() < 2.
  Edge edge_from(Index v) const;
  /// The edge from vertex a to vertex b, if there is one (triangle == kNoIndex: none).
  /// Cost: the degree of a.
  Edge find_edge(Index a, Index b) const;

  /// Walks along the segment from vertex a towards vertex b up to the first vertex on it, which is
  /// returned. `crossed` receives the edges on the way, constrained or not, each with a's side on
  /// its left; it stays empty if there is an edge along the segment.
  /// Requires: a != b, both vertices. Cost: the degree of a and the triangles crossed.
  Index walk_to_next_vertex(Index a, Index b, std::vector<Edge>& crossed) const;

  /// Makes the segment from a to b part of the triangulation. Vertices that lie on it split it.
  /// Returns the vertices along it, a first. Duplicates are replaced by their vertex; a segment
  /// whose ends coincide changes nothing and returns that one vertex.
  /// Requires: dimension() == 2.
  /// Errors: kInvalidGeometry where it would cross a constrained edge in its interior (ids: a, b
  /// and the ends of that edge); then the triangulation is unchanged.
  /// Cost: typically proportional to the triangles crossed and the degrees of the vertices met;
  /// restoring the Delaunay property takes O(k^2) flips for k crossed triangles at the worst.
  Result<std::vector<Index>> insert_constraint(Index a, Index b);

  /// Makes the edge no constraint any more. Requires: dimension() == 2.
  /// Cost: the flips that restore the Delaunay property.
  void remove_constraint(Edge e);

  /// Adds a point and returns its number, or the number of the vertex that is there already (then
  /// nothing is added). A point on a constrained edge splits it into two. `hint` is a triangle to
  /// start from.
  /// Errors: kInvalidGeometry for a coordinate that is not finite; kLimit beyond 2^28 points.
  /// Cost: that of locate, and the degree of the new vertex. Below dimension 2: O(n log n).
  Result<Index> insert(Point2 p, Index hint = 0);

  /// Decides about a point before it goes in. `rim`: the edges that it would be joined to, counter-
  /// clockwise round it, each as its origin and the link to its outer side (rim_edge).
  using RimTest = std::function<bool(std::span<const Triangulation2::RimEdge> rim)>;

  /// Adds point p, which lies inside triangle t or on an edge of it that is not constrained, if
  /// `accepts` agrees. Returns its number, or kNoIndex if it was refused; then nothing is changed.
  /// Requires: a finite p there, no vertex; fewer than 2^28 points; dimension() == 2.
  /// Cost: twice the degree of the new vertex.
  Index insert_if(Point2 p, Index t, const RimTest& accepts);

  /// Splits a constrained edge at a point that should lie on it, but may be off it by its rounding.
  /// Returns the new vertex.
  /// Errors: kInvalidGeometry where p is not inside the circumcircles of both triangles at the edge
  /// or would turn a triangle over (ids: the ends of the edge); then nothing is changed. kLimit
  /// beyond 2^28 points.
  /// Cost: the degree of the new vertex.
  Result<Index> split_edge(Edge e, Point2 p);

  /// Removes a vertex. Its point keeps its number but is no vertex any more; nor are the points
  /// that it stood for.
  /// Errors: kInvalidGeometry if v is no vertex, or ends a constrained edge (ids: v and the other
  /// end); then nothing is changed.
  /// Cost: typically the degree of v, at worst its square. Below dimension 2: O(n log n).
  Status remove(Index v);

  /// The vertices on the boundary of the convex hull, counter-clockwise, collinear ones included,
  /// the lowest first. Empty below dimension 2. Cost: linear.
  std::vector<Index> hull() const;

  /// The vertex nearest to p; of several the lowest that a walk to ever nearer neighbours ends at.
  /// Requires: dimension() == 2 and no constrained edge, which could hide the nearest vertex.
  /// Cost: that of locate.
  Index nearest_vertex(Point2 p, Index hint = 0) const;

  /// A cell of the Voronoi diagram: the points nearer to one vertex than to any other.
  ///
  /// corners: circumcentres, rounded, counter-clockwise; cocircular ones are repeated. The cell of
  /// a hull vertex is unbounded: rays leave its last corner in direction last_ray and its first one
  /// in direction first_ray, at right angles to the two hull edges.
  struct VoronoiCell {
    std::vector<Point2> corners;
    bool bounded = true;
    Point2 first_ray, last_ray;
  };

  /// The Voronoi cell of a vertex, in the whole plane.
  /// Requires: is_vertex(v), dimension() == 2 and no constrained edge.
  /// Errors: kInvalidGeometry where a circumcentre is not finite as doubles (ids: the triangle's
  /// corners).
  /// Cost: the degree of v.
  Result<VoronoiCell> voronoi_cell(Index v) const;

  /// Whether the links are mutual, all triangles counter-clockwise, the hull convex, and every
  /// unconstrained edge locally Delaunay; exact. From that follows that the triangles cover the
  /// hull once and are constrained Delaunay. Cost: linear.
  bool is_valid() const;

 private:
  static constexpr Index kGhost = Triangulation2::kGhost;

  // A point that is no vertex, and the vertex that stands for it.
  struct Duplicate {
    Index point, vertex;
  };
  // Scratch space of an insertion, kept from one to the next to save allocations.
  struct Cavity {
    std::vector<Index> hole;
    std::vector<Triangulation2::RimEdge> rim;
    std::vector<std::uint32_t> stack;
  };

  static unsigned region_count(std::size_t points);
  bool build_from(std::span<const Point2> points, InsertionRuns& runs, const Options& options);
  bool start();
  bool insert_in_order(const InsertionRuns& runs, const Options& options,
                       std::vector<Duplicate>& duplicates);
  std::vector<Duplicate> sort_out_duplicates() const;
  void number_as_input(std::span<const Point2> points, std::vector<Index>& order,
                       const std::vector<Duplicate>& duplicates);
  void allocate_representatives();
  void refresh_triangle_of(Index t);

  int turn(Index a, Index b, Index c) const;
  int side_of_edge(Edge e, Point2 p) const;
  Location locate_exhaustively(Point2 p) const;
  bool in_conflict(Index t, Point2 p) const;
  bool ghost_in_conflict(Index t, Point2 p) const;
  void find_cavity(Edge root, Point2 p, Cavity& cavity) const;

  Edge first_step(Index a, Index b) const;
  void force_edge(Index a, Index b, std::vector<Edge>& crossed);
  Edge triangulate_side(std::span<const Edge> rim, Index end, Index first_new);
  bool is_locally_delaunay(Edge e) const;
  bool is_locally_convex(Index ghost) const;
  void restore_delaunay(std::span<const Index> triangles);

  Result<Index> insert_below_dimension_2(Point2 p);
  Index append_point(Point2 p);
  Index fill_cavity(Point2 p);
  bool sees_whole_rim(Point2 p) const;
  void rebuild();
  Edge constrained_edge_from(Index v) const;
  bool is_ear(Edge e, std::size_t degree) const;
  Edge flip_away(Edge e, std::vector<Index>& cut);
  void remove_from_triangles(Index v);
  void close_star(Edge e, std::vector<Index>& cut);

  int dimension_ = -1;
  std::size_t duplicate_count_ = 0;
  std::vector<Point2> points_;
  std::vector<Index> representative_;  // empty: every point is a vertex
  std::vector<Index> triangle_of_;     // for each vertex a triangle that has it as a corner
  Triangulation2 topology_;
  Cavity cavity_;
};

}  // namespace wellspaced
