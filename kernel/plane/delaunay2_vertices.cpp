// Dynamic vertices of Delaunay2: inserting a point, removing a vertex.
#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/point_order.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {

// ---- Insertion -----------------------------------------------------------------------------

Result<Index> Delaunay2::insert(Point2 p, Index hint) {
  if (!is_finite(p))
    return Error{ErrorCode::kInvalidGeometry, "the point has a coordinate that is not finite", {}};
  if (points_.size() >= kMaxOrderedPoints)
    return Error{ErrorCode::kLimit, "more than 2^28 points", {}};
  if (dimension_ < 2) return insert_below_dimension_2(p);
  const Location location = locate(p, hint);
  if (location.place == Place::kVertex) return topology_.origin(location.edge);
  const bool on_wall = location.place == Place::kEdge && topology_.is_constrained(location.edge);
  if (on_wall) return split_edge(location.edge, p);
  find_cavity(location.edge, p, cavity_);
  return fill_cavity(p);
}

Index Delaunay2::insert_if(Point2 p, Index t, const RimTest& accepts) {
  find_cavity({t, 0}, p, cavity_);
  return accepts(cavity_.rim) ? fill_cavity(p) : kNoIndex;
}

Result<Index> Delaunay2::split_edge(Edge e, Point2 p) {
  if (points_.size() >= kMaxOrderedPoints)
    return Error{ErrorCode::kLimit, "more than 2^28 points", {}};
  if (topology_.is_ghost(e.triangle)) e = topology_.mirror(e);
  const auto& [u, v, w] = topology_.vertices(e.triangle);
  const Index a = topology_.origin(e), b = topology_.destination(e);
  const bool in_circle = incircle(points_[u], points_[v], points_[w], p) > 0;
  topology_.set_constrained(e, false);
  find_cavity(e, p, cavity_);
  const bool in_both = in_circle && is_among(topology_.mirror(e).triangle, cavity_.hole);
  if (!in_both || !sees_whole_rim(p)) {
    topology_.set_constrained(e, true);
    return Error{
        ErrorCode::kInvalidGeometry, {"edge ", a, "-", b, " cannot be split there"}, {a, b}};
  }
  const Index fresh = fill_cavity(p);
  for (const Index end : {a, b}) topology_.set_constrained(find_edge(fresh, end), true);
  return fresh;
}

// Whether p lies strictly to the left of every edge of the cavity's rim. On the hull, where there
// is nothing to see, it has to lie exactly on the edge that is split: then it always does.
bool Delaunay2::sees_whole_rim(Point2 p) const {
  const auto& rim = cavity_.rim;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Index a = rim[i].origin, b = rim[i + 1 < rim.size() ? i + 1 : 0].origin;
    if (a == kGhost || b == kGhost) continue;
    if (orient2d(points_[a], points_[b], p) <= 0) return false;
  }
  return true;
}

// Replaces the triangles of the cavity by the star of p, a new vertex.
Index Delaunay2::fill_cavity(Point2 p) {
  const Index v = append_point(p);
  triangle_of_.push_back(kNoIndex);
  topology_.fill_with_star(cavity_.hole, cavity_.rim, v);
  for (const Index t : cavity_.hole) refresh_triangle_of(t);
  for (Index t = topology_.size() - 2; t < topology_.size(); ++t) refresh_triangle_of(t);
  return v;
}

Index Delaunay2::append_point(Point2 p) {
  const Index v = static_cast<Index>(points_.size());
  points_.push_back(p);
  if (!representative_.empty()) representative_.push_back(v);
  return v;
}

// Few points, or all on a line: they are looked through, and ordered afresh with the new one.
Result<Index> Delaunay2::insert_below_dimension_2(Point2 p) {
  for (Index v = 0; v < points_.size(); ++v)
    if (is_vertex(v) && points_[v] == p) return v;
  const Index v = append_point(p);
  rebuild();
  return v;
}

// Builds the triangulation of the vertices anew.
void Delaunay2::rebuild() {
  InsertionRuns runs{1, insertion_order(points_), {}};
  std::erase_if(runs.order, [this](Index point) { return !is_vertex(point); });
  runs.ends = {static_cast<Index>(runs.order.size())};
  build_from(std::vector<Point2>(points_), runs, {});
}

// ---- Removal -------------------------------------------------------------------------------

Status Delaunay2::remove(Index v) {
  assert(v < points_.size());
  if (!is_vertex(v)) return Error{ErrorCode::kInvalidGeometry, {"point ", v, " is no vertex"}, {v}};
  if (dimension_ == 2) {
    const Edge wall = constrained_edge_from(v);
    if (wall.triangle != kNoIndex)
      return Error{ErrorCode::kInvalidGeometry,
                   {"vertex ", v, " ends a constrained edge"},
                   {v, topology_.destination(wall)}};
    remove_from_triangles(v);
  }
  allocate_representatives();
  representative_[v] = kNoIndex;
  if (dimension_ < 2) rebuild();
  return Ok{};
}

Delaunay2::Edge Delaunay2::constrained_edge_from(Index v) const {
  const Edge first = edge_from(v);
  Edge e = first;
  do {
    if (topology_.is_constrained(e)) return e;
    e = topology_.next_around_origin(e);
  } while (e != first);
  return {};
}

// Whether the far end of e, an edge from v, and its two neighbours in v's link form a triangle that
// can be cut off v's star: a flip of e does it. At degree 4 v may lie on the triangle's third side:
// it goes away with the next step.
bool Delaunay2::is_ear(Edge e, std::size_t degree) const {
  const Index v = topology_.origin(e), w = topology_.destination(e);
  const Index u = topology_.apex(topology_.mirror(e)), x = topology_.apex(e);
  if (u == kGhost || w == kGhost || x == kGhost || turn(u, w, x) <= 0) return false;
  const int side = turn(u, x, v);
  return side > 0 || (side == 0 && degree == 4);
}

// Flips e, an edge from v, out of v's star. Returns the edge from v before it.
Delaunay2::Edge Delaunay2::flip_away(Edge e, std::vector<Index>& cut) {
  const Index u = topology_.mirror(e).triangle;
  topology_.flip(e);
  refresh_triangle_of(e.triangle);
  refresh_triangle_of(u);
  cut.push_back(u);
  return {e.triangle, 0};
}

// Flips the edges at v away until it has three neighbours left, whose triangle takes its place.
// First ears are cut off v's link; as long as it has more than three corners it has one that v is
// not in. On the hull, where the ghost is a neighbour, the ears may run out before: what is left
// of the link then is the new hull.
void Delaunay2::remove_from_triangles(Index v) {
  std::vector<Index> cut;
  Edge e = edge_from(v);
  std::size_t degree = topology_.degree(e);
  for (std::size_t idle = 0; degree > 3 && idle < degree;) {
    if (is_ear(e, degree)) {
      e = flip_away(e, cut);
      --degree;
      idle = 0;
    } else {
      e = topology_.next_around_origin(e);
      ++idle;
    }
  }
  for (; degree > 3; --degree) {
    while (topology_.apex(topology_.mirror(e)) != kGhost) e = topology_.next_around_origin(e);
    e = flip_away(e, cut);
  }
  close_star(e, cut);
}

// Removes the origin of e, which has three neighbours, and makes the triangulation Delaunay again
// around the place.
void Delaunay2::close_star(Edge e, std::vector<Index>& cut) {
  const Index v = topology_.origin(e);
  std::vector<std::pair<Index, Index>> moved;
  const Index t = topology_.merge_star(e, moved);
  triangle_of_[v] = kNoIndex;
  for (const auto& [from, to] : moved) {
    if (to < topology_.size()) refresh_triangle_of(to);  // else the next one moves it on
    std::replace(cut.begin(), cut.end(), from, to);
  }
  refresh_triangle_of(t);
  cut.push_back(t);
  if (topology_.is_ghost(t) &&
      topology_.is_ghost(topology_.neighbor(t, topology_.corner_of(t, kGhost)))) {
    topology_ = {};  // the rest is collinear: only ghosts are left
    dimension_ = 1;
    return;
  }
  restore_delaunay(cut);
}

}  // namespace wellspaced
