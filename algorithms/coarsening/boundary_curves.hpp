// The boundary of a mesh, taken apart into curves that can be coarsened.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "wellspaced/kernel/corner_table.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// Nodes with equal coordinates, tied into circular lists: the pairs across a slit.
struct TwinNodes {
  std::vector<Index> next;  ///< the next node of the list, the node itself if it has no twin;
                            ///< empty if no node has one

  bool has_twin(Index v) const { return !next.empty() && next[v] != v; }

  /// Calls visit with v and all its twins, v first.
  template <class Visit>
  void for_each(Index v, Visit visit) const {
    visit(v);
    if (next.empty()) return;
    for (Index w = next[v]; w != v; w = next[w]) visit(w);
  }
};

/// A curve of the boundary.
///
/// On a domain curve the domain lies on the left of every edge and not on the right; it is closed,
/// and may pass through a node more than once. An inner curve has the same on both sides: an
/// internal interface or crack, or segments away from all triangles. Inner curves end where they
/// meet anything else; those that meet nothing are closed.
struct BoundaryCurve {
  enum class Kind { kDomain, kInner };
  Kind kind = Kind::kDomain;
  bool closed = true;
  std::vector<Index> nodes;  ///< in order, the first not repeated at the end
  std::vector<int> markers;  ///< of the edges nodes[i], nodes[i+1]; cyclic if closed

  std::size_t edges() const { return markers.size(); }
  /// The node at a position, counted on around a closed curve.
  Index node(std::size_t position) const { return nodes[position % nodes.size()]; }
};

/// Boundary nodes are those on a boundary edge of the triangles or on a segment.
///
/// anchors: the boundary nodes that the curves hang on, ascending: ends of inner curves, tips of
///   slits. They stay in every level, whatever the special points are.
struct Boundary {
  std::vector<BoundaryCurve> curves;
  std::vector<std::uint8_t> on_boundary;  ///< one a node
  std::vector<Index> nodes;               ///< the boundary nodes, ascending
  std::vector<Index> anchors;
  TwinNodes twins;
};

/// Takes the boundary of a mesh apart. A boundary edge that no segment names gets marker 1.
/// table: the corners of the mesh's triangles.
/// Requires: a mesh with valid indices, no degenerate or doubly used directed edge.
/// Errors: none; where the triangles make no mesh, curves may be incomplete.
/// Cost: linear but for sorting the boundary edges.
/// See: section 7.4.1, CHOICES 7 and 16.
Boundary boundary_of(const TriangleMesh& mesh, const CornerTable& table);

/// The boundary edges and segments of the curves, in their order.
std::vector<Segment> boundary_segments(const Boundary& boundary);

}  // namespace wellspaced
