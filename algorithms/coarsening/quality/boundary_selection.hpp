// Which boundary nodes a level has, while nodes come and go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// The selected nodes of every boundary curve, linked in their order along it.
///
/// A place is a position on a curve; places of all curves are numbered through. A node has several
/// where curves touch. A link runs from a selected place to the next: it is a contracted edge, and
/// the places between are those that it hides.
/// Requires: the boundary outlives the selection; nodes come and go with their twins.
class BoundarySelection {
 public:
  struct Link {
    std::size_t from = 0, to = 0;
    friend bool operator==(Link, Link) = default;
  };

  /// No node is selected. nodes: of the mesh. Cost: linear.
  BoundarySelection(const Boundary& boundary, std::size_t nodes);

  std::size_t places() const { return node_.size(); }
  Index node(std::size_t place) const { return node_[place]; }
  std::span<const std::size_t> places_of(Index node) const {
    return {place_.data() + first_place_[node], place_.data() + first_place_[node + 1]};
  }
  bool is_selected(std::size_t place) const { return is_selected_[place] != 0; }
  bool is_on_domain_curve(std::size_t place) const {
    return curve(place).kind == BoundaryCurve::Kind::kDomain;
  }

  /// Adds a node to its curves. Cost: the places from there to the selected ones before and after.
  void select(Index node);
  void unselect(Index node);

  /// The link that hides a place; none where its curve has no two selected places around it.
  /// Requires: the place is not selected.
  std::optional<Link> link_over(std::size_t place) const;

  /// Whether a link leaves, or reaches, a selected place; it is then from next() or previous().
  bool has_next(std::size_t place) const { return next_[place] != kNone; }
  bool has_previous(std::size_t place) const { return previous_[place] != kNone; }
  Link next(std::size_t place) const { return {place, next_[place]}; }
  Link previous(std::size_t place) const { return {previous_[place], place}; }

  /// Calls visit with each place that a link hides, in order.
  template <class Visit>
  void for_each_hidden(Link link, Visit visit) const {
    for (std::size_t p = after(link.from); p != link.to; p = after(p)) visit(p);
  }

 private:
  static constexpr std::size_t kNone = SIZE_MAX;

  const BoundaryCurve& curve(std::size_t place) const { return boundary_.curves[curve_of_[place]]; }
  std::size_t after(std::size_t place) const;
  std::size_t before(std::size_t place) const;
  void tie(std::size_t place);

  const Boundary& boundary_;
  std::vector<std::size_t> first_of_curve_, curve_of_;
  std::vector<Index> node_;
  std::vector<std::size_t> first_place_, place_;
  std::vector<std::size_t> next_, previous_;
  std::vector<std::uint8_t> is_selected_;
};

}  // namespace wellspaced
