// A level while it is being made: nodes of the finest mesh are added to it and taken from it, and
// its constrained Delaunay triangulation follows.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/quality/boundary_selection.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// The constrained Delaunay triangulation of the selected nodes of a mesh inside its contracted
/// boundary. Twins, the nodes across a slit, come and go together and are one vertex.
///
/// Every edit is local: it costs about the degrees of the vertices it touches. One that would
/// cross the boundary, push it over another node, or leave a node outside is refused, and changes
/// nothing. So a boundary edge is always its chain pulled straight over no selected node.
class EditableLevel {
 public:
  using Edge = Delaunay2::Edge;

  /// The level of the given nodes and what must join them for the boundary to stay whole.
  /// nodes: ascending, at least 3 on each closed curve, the anchors among them, twins together.
  /// Requires: mesh and skeleton, the mesh's, outlive the level.
  /// Errors: those of Delaunay2; kInvalidGeometry where the boundary crosses itself.
  /// Degenerate: with collinear nodes, or none, there is no triangle; has_triangles() says so, and
  /// no edit is possible.
  static Result<EditableLevel> build(const TriangleMesh& mesh, const Skeleton& skeleton,
                                     std::span<const Index> nodes);

  const Delaunay2& triangulation() const { return delaunay_; }
  bool has_triangles() const { return delaunay_.dimension() == 2; }
  std::size_t size() const { return size_; }

  bool has(Index node) const { return vertex_[node] != kNoIndex; }
  /// The vertex of a node that the level has.
  Index vertex(Index node) const { return vertex_[node]; }
  /// The node of a vertex; of twins the one that was named.
  Index node(Index vertex) const { return node_[vertex]; }
  bool is_on_boundary(Index node) const { return boundary_.on_boundary[node] != 0; }
  /// Calls visit with a node and its twins.
  template <class Visit>
  void for_each_twin(Index node, Visit visit) const {
    boundary_.twins.for_each(node, visit);
  }
  Point2 point(Index node) const { return points_[node]; }
  std::span<const Point2> finest_points() const { return points_; }
  /// The nodes that the level has, ascending.
  std::vector<Index> nodes() const;

  /// Whether a triangle of the triangulation belongs to the domain.
  bool is_inside(Index triangle) const;

  /// The boundary edges, as pairs of vertices, each once.
  struct Wall {
    Index a = 0, b = 0;
  };
  std::vector<Wall> walls() const;

  /// The node that a boundary edge hides and that splits it most evenly; none where it hides no
  /// node that leaves both pieces at least `least_part` of its length.
  std::optional<Index> middle_of(Wall wall, double least_part) const;
  /// The boundary edge that hides a boundary node, if there is one. Requires: !has(node).
  std::optional<Wall> wall_over(Index node) const;

  /// Where an interior node would go: into a triangle inside, or on a boundary edge.
  struct Site {
    enum class Kind { kNone, kInside, kWall };
    Kind kind = Kind::kNone;
    Edge edge;  ///< of the triangle; the boundary edge
  };
  /// hint: a triangle near the node.
  Site site_of(Index node, Index hint) const;

  /// Adds an interior node in the triangle of its site, if `accepts` agrees. Returns whether it was
  /// added.
  bool add_inside(Index node, Index triangle, const Delaunay2::RimTest& accepts);
  /// Adds any node. hint: a triangle near it. Returns whether it was added. Refuses boundary nodes
  /// that lie on several contracted edges (but for the lips of a slit).
  bool add(Index node, Index hint);
  /// Takes a node away. Returns whether it could be.
  /// Requires: has(node), and none of the nodes that the level was built of.
  bool remove(Index node);

  /// The vertices, ascending, at the triangles that the last successful edit made.
  std::span<const Index> touched() const { return touched_; }
  /// The triangles all of whose corners are in a list of vertices, ascending: those of touched()
  /// hold all that the edit made. Cost: the degrees of the vertices.
  std::vector<Index> triangles_among(std::span<const Index> vertices) const;

 private:
  EditableLevel(const TriangleMesh& mesh, const Skeleton& skeleton);

  void name(Index node, Index vertex);
  template <class Visit>
  void for_each_link(Wall wall, Visit visit) const;
  std::optional<bool> inside_right_of(Index a, Index b) const;
  std::optional<bool> inside_at(Edge corner) const;
  Wall wall_of(BoundarySelection::Link link) const;
  std::optional<Wall> single_wall_over(Index node) const;
  bool add_to_boundary(Index node);
  bool bend(Wall wall, Index x);
  bool join(Index end, Index x);
  bool is_between(Wall wall, Index x) const;
  void take_back(Wall wall, Index x);
  bool remove_from_boundary(Index node);
  bool straighten(Wall wall, Index x);
  void touch_star(Index vertex);

  std::span<const Point2> points_;
  const Boundary& boundary_;
  const CornerTable& corners_;
  BoundarySelection selection_;
  Delaunay2 delaunay_;
  std::vector<Index> vertex_, node_;
  std::vector<Index> touched_;
  std::vector<Edge> crossed_;
  std::size_t size_ = 0;
};

}  // namespace wellspaced
