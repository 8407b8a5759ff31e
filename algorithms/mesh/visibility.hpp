// Who sees whom inside the domain of a mesh?
#pragma once

#include <vector>

#include "wellspaced/algorithms/mesh/triangle_links.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Lines of sight: two points see each other when the segment between them is contained in the
/// domain, the closed union of the triangles. Lines may run along the boundary and touch it; holes
/// and slits block them, inner segments do not.
///
/// Found by a walk through the triangles; all decisions are exact.
/// Requires: a valid mesh of counter-clockwise triangles that do not overlap, coincident nodes only
/// across slits; it outlives the object.
class Visibility {
 public:
  explicit Visibility(const TriangleMesh& mesh);

  /// Whether node p sees node q. A node sees itself, but not its twin on the other lip of a slit;
  /// a node in no triangle sees no other. Cost: the triangles along the segment, the stars of the
  /// nodes on it.
  bool sees(Index p, Index q) const;

  /// Whether point x, in the closed triangle `at`, sees node q. On a slit, x lies on the lip that
  /// the triangle belongs to.
  bool sees(Point2 x, Index at, Index q) const;

  const TriangleMesh& mesh() const { return mesh_; }
  const TriangleLinks& links() const { return links_; }

 private:
  // A place on the way: at a node, or on the way through a triangle by the edge opposite `corner`.
  struct Place {
    Index node = kNoIndex;
    Index triangle = kNoIndex;
    unsigned corner = 0;
  };
  // A line of sight, from `from` to node `to`.
  struct Line {
    Point2 from;
    Index to = 0;
    Point2 end;
  };

  bool arrives(Line line, Place place) const;
  Place leave_node(const Line& line, Index v, std::vector<Index>& put_off) const;
  Place leave_triangle(const Line& line, Index t) const;
  Place cross_edge(const Line& line, Place place) const;

  const TriangleMesh& mesh_;
  TriangleLinks links_;
};

}  // namespace wellspaced
