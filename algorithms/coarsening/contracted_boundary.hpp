// Where contraction would tear or fold the domain, and what it leaves outside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/contraction.hpp"
#include "wellspaced/algorithms/coarsening/node_selection.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The areas that the domain may have.
struct AreaRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The contracted boundary with the regions that it sweeps over: region i lies between edge i and
/// the chain that it replaces. All decisions are by exact predicates.
class ContractedBoundary {
 public:
  /// Requires: points are those of the boundary's mesh.
  ContractedBoundary(const Boundary& boundary, std::span<const Point2> points,
                     std::vector<ContractedEdge> edges);

  const std::vector<ContractedEdge>& edges() const { return edges_; }

  /// The edges that must get an eliminated node back, ascending: those that replace a chain and
  /// cross another edge, or pass through a selected node, or whose region has a selected node
  /// inside, which the boundary would jump over, or that join the same two nodes as another edge.
  ///
  /// Where there are none, the new boundary lies in the plane as the old one did: every chain can
  /// be pulled straight without passing over another node, so no hole closes or leaves its
  /// component, and no curve is turned over. (A curve without 2 selected nodes is lost before.)
  /// Cost: O(b log b) for b boundary nodes, and the chains of the regions whose boxes overlap.
  std::vector<std::size_t> broken_edges(std::span<const Index> selected) const;

  /// Whether any edge has left its chain. If none has, nothing is broken or left outside.
  bool moves_anything() const { return !regions_.empty(); }

  /// The area that the domain curves enclose.
  double area() const;

  /// The edges of the domain curves that change the area most: by half of what the first of them
  /// does, or more. Ascending; none if no edge changes it.
  std::vector<std::size_t> edges_that_move_most() const;

  /// Whether a point that was inside the domain, off the boundary, now is not: outside, or on a
  /// contracted edge.
  bool leaves_outside(Point2 p) const;

 private:
  // The chain of an edge that moves: the edge closes it to a polygon.
  struct Region {
    std::size_t edge = 0;
    std::vector<Point2> chain;
  };

  Point2 from(const ContractedEdge& edge) const { return points_[edge.a]; }
  Point2 to(const ContractedEdge& edge) const { return points_[edge.b]; }
  void mark_crossings(std::vector<std::uint8_t>& broken) const;
  void mark_met_nodes(std::span<const Index> selected, std::vector<std::uint8_t>& broken) const;
  void mark_doubles(std::vector<std::uint8_t>& broken) const;

  std::span<const Point2> points_;
  std::vector<ContractedEdge> edges_;
  std::vector<std::uint8_t> on_domain_curve_;  // one an edge
  std::vector<Region> regions_;
  BoxTree edge_tree_{{}}, region_tree_{{}};
};

/// Contracts the boundary to the selected nodes. While edges are broken, the middle node that each
/// has eliminated is selected again, by force (CHOICES 10); then, while the area is out of range,
/// those of the edges that move most.
/// Ends: at the latest when every boundary node is selected, or when keep_going, asked before each
/// contraction but the first, says stop.
ContractedBoundary contract_and_repair(const Boundary& boundary, std::span<const Point2> points,
                                       NodeSelection& selection, AreaRange areas = {},
                                       const NodeSelection::KeepGoing& keep_going = {});

}  // namespace wellspaced
