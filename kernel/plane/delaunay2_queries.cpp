// Questions to Delaunay2: hull, nearest vertex, Voronoi cell, validity.
#include <algorithm>
#include <array>
#include <cassert>

#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/plane/circumcircle.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// The direction from a to b turned clockwise: out of the hull, for a hull edge.
Point2 outward(Point2 a, Point2 b) { return {b.y - a.y, a.x - b.x}; }

}  // namespace

std::vector<Index> Delaunay2::hull() const {
  std::vector<Index> hull;
  Index ghost = 0;
  while (ghost < topology_.size() && !topology_.is_ghost(ghost)) ++ghost;
  if (ghost == topology_.size()) return hull;
  Index t = ghost;
  do {  // the hull runs from the ghost's second next corner back to its next one, reversed
    const unsigned g = topology_.corner_of(t, kGhost);
    hull.push_back(topology_.vertex(t, Triangulation2::previous(g)));
    t = topology_.neighbor(t, Triangulation2::previous(g));
  } while (t != ghost);
  std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end()), hull.end());
  return hull;
}

Index Delaunay2::nearest_vertex(Point2 p, Index hint) const {
  Index nearest = topology_.origin(locate(p, hint).edge);
  for (bool moved = true; moved;) {
    moved = false;
    const Edge first = edge_from(nearest);
    Edge e = first;
    do {
      const Index v = topology_.destination(e);
      if (v != kGhost) {
        const int order = compare_distances(p, points_[v], points_[nearest]);
        if (order < 0 || (order == 0 && v < nearest)) {
          nearest = v;
          moved = true;
          break;
        }
      }
      e = topology_.next_around_origin(e);
    } while (e != first);
  }
  return nearest;
}

Result<Delaunay2::VoronoiCell> Delaunay2::voronoi_cell(Index v) const {
  assert(is_vertex(v) && dimension_ == 2);
  Edge first = edge_from(v);
  Edge e = first;
  do {  // on the hull, begin with the hull edge that leaves v
    e = topology_.next_around_origin(e);
    if (topology_.apex(topology_.mirror(e)) == kGhost) first = e;
  } while (e != first);
  VoronoiCell cell;
  cell.bounded = topology_.apex(topology_.mirror(first)) != kGhost;
  if (!cell.bounded) cell.first_ray = outward(points_[v], points_[topology_.destination(first)]);
  do {
    const std::array<Index, 3> t{v, topology_.destination(e), topology_.apex(e)};
    const Point2 centre = circumcircle(points_[t[0]], points_[t[1]], points_[t[2]]).centre;
    if (!is_finite(centre))
      return Error{ErrorCode::kInvalidGeometry, "a circumcentre is not finite", {t[0], t[1], t[2]}};
    cell.corners.push_back(centre);
    if (!cell.bounded) cell.last_ray = outward(points_[t[2]], points_[v]);
    e = topology_.next_around_origin(e);
  } while (e != first && topology_.apex(e) != kGhost);
  return cell;
}

bool Delaunay2::is_locally_convex(Index ghost) const {
  const unsigned g = topology_.corner_of(ghost, kGhost);
  const Index beyond = topology_.apex(topology_.mirror({ghost, Triangulation2::next(g)}));
  return side_of_edge({ghost, g}, points_[beyond]) <= 0;
}

bool Delaunay2::is_valid() const {
  if (!topology_.is_valid()) return false;
  for (Index t = 0; t < topology_.size(); ++t) {
    if (topology_.is_ghost(t)) {
      if (!is_locally_convex(t)) return false;
      continue;
    }
    const auto& v = topology_.vertices(t);
    if (turn(v[0], v[1], v[2]) <= 0) return false;
    for (unsigned i = 0; i < 3; ++i)
      if (!is_locally_delaunay({t, i})) return false;
  }
  return true;
}

}  // namespace wellspaced
