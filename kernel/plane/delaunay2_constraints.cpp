// Constrained edges: inserting a segment into Delaunay2.
#include <algorithm>
#include <array>
#include <cassert>
#include <string>

#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// Whether u, collinear with a and b, lies on b's side of a.
bool same_direction(Point2 a, Point2 b, Point2 u) { return (a < b) == (a < u); }

}  // namespace

// Where the segment from vertex a to vertex b leaves the star of a: the edge from a along it
// (then the edge's destination lies on the segment), or the edge opposite a that it crosses, with
// the near side on its left.
Delaunay2::Edge Delaunay2::first_step(Index a, Index b) const {
  const Edge first = edge_from(a);
  Edge e = first;
  do {
    const Index u = topology_.destination(e), w = topology_.apex(e);
    const int right = u == kGhost ? 1 : turn(a, b, u);
    if (right == 0 && same_direction(points_[a], points_[b], points_[u])) return e;
    if (right < 0 && w != kGhost && turn(a, b, w) > 0)
      return {e.triangle, Triangulation2::next(e.i)};
    e = topology_.next_around_origin(e);
  } while (e != first);
  assert(false && "a straight line leaves every star");
  return {};
}

Index Delaunay2::walk_to_next_vertex(Index a, Index b, std::vector<Edge>& crossed) const {
  crossed.clear();
  Edge e = first_step(a, b);
  if (topology_.origin(e) == a) return topology_.destination(e);
  for (;;) {
    crossed.push_back(e);
    const Edge m = topology_.mirror(e);
    const Index x = topology_.apex(m);
    const int side = turn(a, b, x);
    if (side == 0) return x;
    e = {m.triangle, side > 0 ? Triangulation2::next(m.i) : Triangulation2::previous(m.i)};
  }
}

Result<std::vector<Index>> Delaunay2::insert_constraint(Index a, Index b) {
  assert(dimension_ == 2 && a < points_.size() && b < points_.size());
  a = representative(a);
  b = representative(b);
  if (const Edge e = find_edge(a, b); e.triangle != kNoIndex) {
    topology_.set_constrained(e, true);
    return std::vector<Index>{a, b};
  }
  std::vector<Index> path{a};
  std::vector<Edge> crossed;
  while (path.back() != b) {
    const Index v = walk_to_next_vertex(path.back(), b, crossed);
    for (const Edge e : crossed)
      if (topology_.is_constrained(e)) {
        const Index c = topology_.origin(e), d = topology_.destination(e);
        return Error{ErrorCode::kInvalidGeometry,
                     {"segment ", a, "-", b, " crosses segment ", c, "-", d},
                     {a, b, c, d}};
      }
    path.push_back(v);
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) force_edge(path[i], path[i + 1], crossed);
  return path;
}

// Makes the edge between two vertices, which no vertex and no constrained edge keeps apart.
void Delaunay2::force_edge(Index a, Index b, std::vector<Edge>& crossed) {
  walk_to_next_vertex(a, b, crossed);
  if (crossed.empty()) {
    topology_.set_constrained(find_edge(a, b), true);
    return;
  }
  // The crossed triangles form two polygons, one on each side of the segment. Their rims, counter-
  // clockwise: the left one from b back to a, the right one from a to b.
  std::vector<Index> hole{crossed.front().triangle};
  std::vector<Edge> left, right;
  const Edge near = crossed.front();
  left.push_back({near.triangle, Triangulation2::next(near.i)});
  right.push_back({near.triangle, Triangulation2::previous(near.i)});
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    const Edge m = topology_.mirror(crossed[i]);
    const Edge to_apex{m.triangle, Triangulation2::next(m.i)};
    const Edge from_apex{m.triangle, Triangulation2::previous(m.i)};
    hole.push_back(m.triangle);
    const bool last = i + 1 == crossed.size();
    if (last || crossed[i + 1] == to_apex) left.push_back(from_apex);
    if (last || crossed[i + 1] == from_apex) right.push_back(to_apex);
  }
  std::reverse(left.begin(), left.end());
  const Index first_new = topology_.size();
  const Edge above = triangulate_side(left, a, first_new);
  const Edge below = triangulate_side(right, b, first_new);
  topology_.link(above, below, true);
  topology_.move_into(hole);
  for (const Index t : hole) refresh_triangle_of(t);
  restore_delaunay(hole);
}

// Triangulates the polygon between a segment and the rim on one side of it, by new triangles at
// the end. The rim runs counter-clockwise to vertex `end`. Returns the edge along the segment.
//
// Every point of the rim can be seen from the segment, since the edges that were crossed show it.
// In such a polygon every convex corner is an ear (Toussaint and Avis 1982), and cutting one
// leaves such a polygon; so a stack as in Graham's scan does it in linear time. The rim may meet
// the same edge from both sides, where a spike reaches into the polygon. So what lies outside an
// edge of the rim is looked up only when its triangle is made, in the old triangle inside, which
// stays as it was until then.
Delaunay2::Edge Delaunay2::triangulate_side(std::span<const Edge> rim, Index end, Index first_new) {
  struct Side {
    Index origin;
    Edge edge;
  };
  std::vector<Side> stack;
  const auto attach = [&](Edge fresh, Edge side) {
    if (side.triangle >= first_new)
      topology_.link(fresh, side, false);
    else
      topology_.link(fresh, topology_.mirror(side), topology_.is_constrained(side));
  };
  for (std::size_t i = 0; i < rim.size(); ++i) {
    stack.push_back({topology_.origin(rim[i]), rim[i]});
    const Index w = i + 1 < rim.size() ? topology_.origin(rim[i + 1]) : end;
    while (stack.size() > 1) {
      const Side second = stack.back(), first = stack[stack.size() - 2];
      if (turn(first.origin, second.origin, w) <= 0) break;
      const Index t = topology_.add(first.origin, second.origin, w);
      attach({t, 2}, first.edge);
      attach({t, 0}, second.edge);
      stack.resize(stack.size() - 2);
      stack.push_back({first.origin, {t, 1}});
    }
  }
  assert(stack.size() == 1);
  return stack.front().edge;
}

void Delaunay2::remove_constraint(Edge e) {
  topology_.set_constrained(e, false);
  restore_delaunay(std::array{e.triangle});
}

// Lawson's flips, beginning with the edges of `triangles`. They end: each flip lowers the surface
// over the triangulation on the paraboloid.
void Delaunay2::restore_delaunay(std::span<const Index> triangles) {
  std::vector<Edge> suspects;
  for (const Index t : triangles)
    for (unsigned i = 0; i < 3; ++i) suspects.push_back({t, i});
  while (!suspects.empty()) {
    const Edge e = suspects.back();
    suspects.pop_back();
    if (is_locally_delaunay(e)) continue;
    const Index u = topology_.mirror(e).triangle;
    topology_.flip(e);
    for (const Index t : {e.triangle, u}) {
      refresh_triangle_of(t);
      suspects.push_back({t, 0});
      suspects.push_back({t, 2});
    }
  }
}

}  // namespace wellspaced
