// How Delaunay2::build inserts its points: one after the other, each near the one before it.
//
// It is fast because everything is seen from the point p that goes in: a vertex as its difference
// from p and the square of that, an edge (u, v) as the minor ux vy - uy vx. The minor is
// orient2d(u, v, p), by which the walk to p steers, and both triangles at the edge need it for
// incircle. So a step over an edge costs one new vertex and two new minors, in the walk as in the
// search for the triangles that p ends. The ghost is seen as (0, 0, s), the point at infinity of
// the paraboloid: with it incircle says whether p lies beyond the hull edge.
#include <algorithm>
#include <utility>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/lifted_filter.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using predicate_filter::edge_minor;
using predicate_filter::Lifted;

// Triangles are appended so many at a time.
constexpr std::size_t kTriangleBlock = 1024;
// Most stars have fewer edges than this.
constexpr std::size_t kUsualStar = 64;

constexpr Index kGhostVertex = Triangulation2::kGhost;

// A triangle as p sees it: the link to one of its edges, which runs from a to b, the corner c
// opposite, and the minors of its sides.
struct SeenTriangle {
  std::uint32_t link;
  Lifted a, b, c;
  double ab, bc, ca;
};

// An edge on the way round the hole, as far as that is known: where it ends, its minor, and the
// link to its outer side. It starts where the one before it ends.
struct OpenEdge {
  Lifted end;
  double minor;
  std::uint32_t link;
};

// Makes points[v] vertex v, for all v. Triangle is Triangulation2's.
template <class Triangle>
class BulkInserter {
 public:
  // Requires: the triangles are the Delaunay triangulation of three of the points, unconstrained,
  // with room reserved for two triangles a point.
  BulkInserter(LargeVector<Triangle>& triangles, std::span<const Point2> points)
      : triangles_(triangles), points_(points), slots_(kUsualStar), stack_(kUsualStar) {
    const auto& v = triangles[0].vertex;
    ghost_sq_ = predicate_filter::lifted(points[v[0]], points[v[1]]).sq;
  }

  // Cost: a walk from each point to the next, and the degree of each new vertex. `report` is called
  // as report(point, vertex) for each point that has the coordinates of a vertex.
  template <class Report>
  void run(Report report) {
    const auto first = triangles_[0].vertex;
    const Index count = static_cast<Index>(points_.size());
    Index used = static_cast<Index>(triangles_.size()), hint = 0;
    for (Index v = 0; v < count; ++v) {
      if (v == first[0] || v == first[1] || v == first[2]) continue;
      if (used + 2 > triangles_.size())
        triangles_.resize(std::min(used + kTriangleBlock, triangles_.capacity()));
      p_ = points_[v];
      const SeenTriangle place = walk(hint);
      const Index vertex = twin(place);
      if (vertex != kNoIndex) {
        report(v, vertex);
        continue;
      }
      slots_[0] = used++;
      slots_[1] = used++;
      hint = replace_hole(v, place, see(v + 1 < count ? v + 1 : v));
    }
    triangles_.resize(used);
  }

 private:
  static constexpr std::uint32_t pack(Index t, unsigned i) { return t << 3 | i; }
  const Triangle& triangle(std::uint32_t link) const { return triangles_[link >> 3]; }

  // ---- What p sees.

  Lifted see(Index v) const {
    if (v == kGhostVertex) return {0, 0, ghost_sq_};
    return predicate_filter::lifted(points_[v], p_);
  }

  // On which side of edge i of triangle t p lies: positive on its left. `from` and `to` are its
  // ends.
  int side(const Triangle& t, unsigned i, Lifted from, Lifted to) const {
    const int sign = predicate_filter::orient2d_of_differences(from.x, from.y, to.x, to.y);
    return sign != 0 ? sign : exact_side(t, i);
  }

  int exact_side(const Triangle& t, unsigned i) const {
    return orient2d(points_[t.vertex[Triangulation2::next(i)]],
                    points_[t.vertex[Triangulation2::previous(i)]], p_);
  }

  // Whether triangle t behind e is in conflict with p. e begins at `start`; in and out are the
  // minors of the triangle's other sides, from there to its apex and on to the end of e.
  bool is_in_hole(const Triangle& t, const OpenEdge& e, Lifted start, Lifted apex, double in,
                  double out) const {
    const auto estimate =
        predicate_filter::incircle_of_minors(e.end, start, apex, -e.minor, in, out);
    if (estimate.determinant > estimate.bound) return true;
    if (estimate.determinant < -estimate.bound) return false;
    return is_in_conflict(t);
  }

  // Exactly: whether p lies inside the triangle's circumcircle; for a ghost, beyond the hull edge
  // or on it.
  bool is_in_conflict(const Triangle& t) const {
    const auto& v = t.vertex;
    for (unsigned i = 0; i < 3; ++i) {
      if (v[i] != kGhostVertex) continue;
      const int sign = exact_side(t, i);
      if (sign != 0) return sign > 0;
      return strictly_between(points_[v[Triangulation2::next(i)]], p_,
                              points_[v[Triangulation2::previous(i)]]);
    }
    return incircle(points_[v[0]], points_[v[1]], points_[v[2]], p_) > 0;
  }

  // ---- Location.

  // The triangle that p lies in or on, or the ghost that p lies strictly beyond, from triangle
  // `hint`. A visibility walk: from triangle to triangle over an edge that has p strictly on its
  // far side. In a Delaunay triangulation it never comes back to a triangle (Edelsbrunner, An
  // acyclicity theorem for cell complexes in d dimensions, 1990).
  SeenTriangle walk(Index hint) const {
    std::uint32_t link = pack(hint, 0);
    for (unsigned i = 0; i < 3; ++i)
      if (triangles_[hint].vertex[i] == kGhostVertex) link = triangles_[hint].link[i];
    const Triangle& t = triangle(link);
    const unsigned i = link & 3;
    Lifted a = see(t.vertex[Triangulation2::next(i)]),
           b = see(t.vertex[Triangulation2::previous(i)]);
    if (side(t, i, a, b) < 0) {
      link = t.link[i];
      std::swap(a, b);
    }
    return walk_over(link, a, b);
  }

  // The rest of the walk, over the edge from a to b, which has p on the side of the link.
  SeenTriangle walk_over(std::uint32_t link, Lifted a, Lifted b) const {
    double ab = edge_minor(a, b);
    for (;;) {
      const Triangle& t = triangle(link);
      const unsigned i = link & 3, next = Triangulation2::next(i),
                     previous = Triangulation2::previous(i);
      const Lifted c = see(t.vertex[i]);
      if (t.vertex[i] == kGhostVertex) return {link, a, b, c, ab, 0, 0};
      const double bc = edge_minor(b, c), ca = edge_minor(c, a);
      if (side(t, next, b, c) < 0) {
        link = t.link[next];
        a = c;
        ab = -bc;
      } else if (side(t, previous, c, a) < 0) {
        link = t.link[previous];
        b = c;
        ab = -ca;
      } else {
        return {link, a, b, c, ab, bc, ca};
      }
    }
  }

  // The corner of the triangle that has p's coordinates, or kNoIndex.
  Index twin(const SeenTriangle& place) const {
    if ((place.a.sq != 0) & (place.b.sq != 0) & (place.c.sq != 0)) return kNoIndex;
    for (const Index v : triangle(place.link).vertex)
      if (v != kGhostVertex && points_[v] == p_) return v;
    return kNoIndex;
  }

  // ---- Insertion.

  // Puts the edges of the first triangle of the hole on the stack.
  void open_hole(const SeenTriangle& root) {
    const auto& link = triangle(root.link).link;
    const unsigned i = root.link & 3;
    slots_[2] = root.link >> 3;
    stack_[0] = {root.a, root.ca, link[Triangulation2::previous(i)]};
    stack_[1] = {root.c, root.bc, link[Triangulation2::next(i)]};
    stack_[2] = {root.b, root.ab, link[i]};
  }

  // Replaces the triangles in conflict with p, of which `root` is one, by the star of p, vertex v.
  // Returns the triangle of the star that looks towards `next`, as far as floating point tells.
  //
  // No vertex lies inside the hole, so its triangles form a tree: each is met once, no mark is
  // needed, and walking the tree in order meets the rim in order. While an edge is still on the
  // stack, there are at most as many rim edges as triangles in the hole and one more. So slot k and
  // the next one are known when rim edge k is found, and what they held has been read: the star is
  // written at once.
  //
  // Not inlined: its loop needs all registers for itself.
  [[gnu::noinline]] Index replace_hole(Index v, const SeenTriangle& root, Lifted next) {
    Triangle* const triangles = triangles_.data();
    open_hole(root);
    std::size_t slot_count = 3, open = 2, k = 0;
    OpenEdge e = stack_[open];
    Lifted start = root.a;
    Index before = kNoIndex;
    Index looks_towards[2] = {slots_[0], slots_[0]};  // the last that does not and that does
    bool is_right = edge_minor(start, next) >= 0;     // `start`, of the way to `next`
    for (;;) {
      Triangle& t = triangles[e.link >> 3];
      const unsigned i = e.link & 3, next_i = Triangulation2::next(i),
                     previous_i = Triangulation2::previous(i);
      const Lifted apex = see(t.vertex[i]);
      const double in = edge_minor(start, apex), out = edge_minor(apex, e.end);
      if (is_in_hole(t, e, start, apex, in, out)) {
        slots_[slot_count++] = e.link >> 3;
        if (slot_count == slots_.size()) make_room();
        stack_[open++] = {e.end, out, t.link[previous_i]};
        e = {apex, in, t.link[next_i]};
        continue;
      }
      const Index here = slots_[k++];
      triangles[here] = {{v, t.vertex[previous_i], t.vertex[next_i]},
                         {e.link, pack(slots_[k], 2), pack(before, 1)}};
      t.link[i] = pack(here, 0);
      before = here;
      const bool end_is_right = edge_minor(e.end, next) >= 0;
      looks_towards[is_right & !end_is_right] = here;
      is_right = end_is_right;
      if (open == 0) break;
      start = e.end;
      e = stack_[--open];
    }
    triangles[before].link[1] = pack(slots_[0], 2);
    triangles[slots_[0]].link[2] = pack(before, 1);
    return looks_towards[1];
  }

  void make_room() {
    slots_.resize(2 * slots_.size());
    stack_.resize(2 * stack_.size());
  }

  LargeVector<Triangle>& triangles_;
  std::span<const Point2> points_;
  double ghost_sq_;  // how the ghost is seen; its size does not matter to a sign
  Point2 p_ = {};    // the point that goes in
  // Scratch space. The slots are the numbers that the triangles of p's star get: two new ones, then
  // those of the hole.
  std::vector<Index> slots_;
  std::vector<OpenEdge> stack_;
};

}  // namespace

void Delaunay2::insert_in_order(std::vector<Duplicate>& duplicates) {
  BulkInserter inserter(topology_.triangles_, std::span<const Point2>(points_));
  inserter.run([&](Index point, Index vertex) { duplicates.push_back({point, vertex}); });
}

}  // namespace wellspaced
