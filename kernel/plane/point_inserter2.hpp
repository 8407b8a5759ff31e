// Inserts points into a triangulation of the plane, each near the one before it.
//
// It is fast because everything is seen from the point p that goes in: a vertex as its difference
// from p and the square of that, an edge (u, v) as the minor ux vy - uy vx. The minor is
// orient2d(u, v, p), by which the walk to p steers, and both triangles at the edge need it for
// incircle. So a step over an edge costs one new vertex and two new minors, in the walk as in the
// search for the triangles that p ends. The ghost is seen as (0, 0, s), the point at infinity of
// the paraboloid: with it incircle says whether p lies beyond the hull edge.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/lifted_filter.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/parallel.hpp"
#include "wellspaced/kernel/plane/triangulation2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {

/// Makes points[v] vertex v. Used by Delaunay2::build, one a thread, so that each lies on cache
/// lines of its own. Triangle is Triangulation2's.
template <class Triangle>
class alignas(kCacheLine) PointInserter2 {
 public:
  enum class Outcome { kInserted, kTwin, kFenced };

  /// Marks a link that must not be followed (the fence). No edge is constrained yet, so the bit is
  /// free.
  static constexpr std::uint32_t kFence = 4;

  static constexpr std::uint32_t packed_link(Index t, unsigned i) { return t << 3 | i; }

  /// Requires: `triangles` begins with the Delaunay triangulation of three of the points.
  PointInserter2(LargeVector<Triangle>& triangles, std::span<const Point2> points)
      : triangles_(triangles),
        points_(points),
        slots_(kUsualStar),
        stack_(kUsualStar),
        removed_(kUsualStar) {
    const auto& v = triangles[0].vertex;
    ghost_sq_ = predicate_filter::lifted(points[v[0]], points[v[1]]).sq;
  }

  /// The next walk starts at triangle `hint`; kNoIndex: there is no way.
  void start_at(Index hint) { hint_ = hint; }

  /// The triangle that point v lies in or on, or the ghost that it lies strictly beyond.
  Index locate(Index v) {
    p_ = points_[v];
    return hint_ = walk(hint_).link >> 3;
  }

  /// kInserted: point v is a vertex, with the triangles first_new and first_new + 1 beside those
  /// that it changed; the search for `next` will start near it. kTwin: it has the coordinates of
  /// vertex twin(). kFenced: the fence was met. In both cases nothing is changed.
  /// Cost: the walk from the last point, and the degree of the new vertex.
  Outcome insert(Index v, Index first_new, Index next) {
    if (hint_ == kNoIndex) return Outcome::kFenced;
    p_ = points_[v];
    const SeenTriangle place = walk(hint_);
    if (place.link & kFence) return Outcome::kFenced;
    twin_ = twin_of_p(place);
    if (twin_ != kNoIndex) return Outcome::kTwin;
    slots_[0] = first_new;
    slots_[1] = first_new + 1;
    const Index towards_next = replace_hole(v, place, see(next));
    if (towards_next == kNoIndex) return Outcome::kFenced;
    hint_ = towards_next;
    return Outcome::kInserted;
  }

  Index twin() const { return twin_; }

 private:
  using Lifted = predicate_filter::Lifted;

  // Most stars have fewer edges than this.
  static constexpr std::size_t kUsualStar = 64;
  static constexpr Index kGhostVertex = Triangulation2::kGhost;

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

  const Triangle& triangle(std::uint32_t link) const { return triangles_[link >> 3]; }

  static double edge_minor(const Lifted& a, const Lifted& b) {
    return predicate_filter::edge_minor(a, b);
  }

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
  // `hint`; or what is known when the way leads over the fence: a link with its mark. A visibility
  // walk: from triangle to triangle over an edge that has p strictly on its far side. In a Delaunay
  // triangulation it never comes back to a triangle (Edelsbrunner, An acyclicity theorem for cell
  // complexes in d dimensions, 1990).
  SeenTriangle walk(Index hint) const {
    std::uint32_t link = packed_link(hint, 0);
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
      if (link & kFence) return {link, a, b, {}, ab, 0, 0};
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
  Index twin_of_p(const SeenTriangle& place) const {
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
    removed_[2] = triangle(root.link);
    stack_[0] = {root.a, root.ca, link[Triangulation2::previous(i)]};
    stack_[1] = {root.c, root.bc, link[Triangulation2::next(i)]};
    stack_[2] = {root.b, root.ab, link[i]};
  }

  // Replaces the triangles in conflict with p, of which `root` is one, by the star of p, vertex v.
  // Returns the triangle of the star that looks towards `next`, as far as floating point tells; or
  // kNoIndex, with nothing changed, if one of the triangles is behind the fence.
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
        if (e.link & kFence) return restore_hole(slot_count);
        removed_[slot_count] = t;
        slots_[slot_count++] = e.link >> 3;
        if (slot_count == slots_.size()) make_room();
        stack_[open++] = {e.end, out, t.link[previous_i]};
        e = {apex, in, t.link[next_i]};
        continue;
      }
      const Index here = slots_[k++];
      triangles[here] = {{v, t.vertex[previous_i], t.vertex[next_i]},
                         {e.link, packed_link(slots_[k], 2), packed_link(before, 1)}};
      t.link[i] = packed_link(here, 0);
      before = here;
      const bool end_is_right = edge_minor(e.end, next) >= 0;
      looks_towards[is_right & !end_is_right] = here;
      is_right = end_is_right;
      if (open == 0) break;
      start = e.end;
      e = stack_[--open];
    }
    triangles[before].link[1] = packed_link(slots_[0], 2);
    triangles[slots_[0]].link[2] = packed_link(before, 1);
    return looks_towards[1];
  }

  void make_room() {
    slots_.resize(2 * slots_.size());
    stack_.resize(2 * stack_.size());
    removed_.resize(2 * removed_.size());
  }

  // Puts back the triangles of the hole, and the links to them. Returns kNoIndex.
  Index restore_hole(std::size_t slot_count) {
    for (std::size_t k = 2; k < slot_count; ++k) {
      triangles_[slots_[k]] = removed_[k];
      for (unsigned i = 0; i < 3; ++i) {
        const std::uint32_t outside = removed_[k].link[i];
        triangles_[outside >> 3].link[outside & 3] = packed_link(slots_[k], i);
      }
    }
    return kNoIndex;
  }

  LargeVector<Triangle>& triangles_;
  std::span<const Point2> points_;
  Index hint_ = 0;
  Index twin_ = kNoIndex;
  double ghost_sq_;  // how the ghost is seen; its size does not matter to a sign
  Point2 p_ = {};    // the point that goes in
  // Scratch space. The slots are the numbers that the triangles of p's star get: two new ones, then
  // those of the hole, whose triangles were `removed`.
  std::vector<Index> slots_;
  std::vector<OpenEdge> stack_;
  std::vector<Triangle> removed_;
};

}  // namespace wellspaced
