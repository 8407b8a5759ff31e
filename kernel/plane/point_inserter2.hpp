// Inserts points into a triangulation of the plane, each near the one before it.
//
// It is fast because everything is seen from the point p that goes in: a vertex as its difference
// from p and the square of that, an edge (u, v) as the minor ux vy - uy vx. The minor is
// orient2d(u, v, p), by which the walk to p steers, and both triangles at the edge need it for
// incircle. So a step over an edge costs one new vertex and two new minors, in the walk as in the
// search for the triangles that p ends. The ghost is seen as (0, 0, s), the point at infinity of
// the paraboloid: with it incircle says whether p lies beyond the hull edge.
//
// Two edges are looked over at a time, by the same instructions. So most answers are there before
// anything branches on them; no processor can guess those branches.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

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
  PointInserter2(std::span<Triangle> triangles, std::span<const Point2> points)
      : triangles_(triangles.data()),
        points_(points.data()),
        slots_(kUsualStar),
        stack_(kUsualStar) {
    const auto& v = triangles[0].vertex;
    p_ = coordinates(v[1]);
    ghost_sq_ = predicate_filter::squared_length(difference(v[0]));
  }

  /// The next walk starts at triangle `hint`; kNoIndex: there is no way.
  void start_at(Index hint) { hint_ = hint; }

  /// The triangle that point v lies in or on, or the ghost that it lies strictly beyond.
  Index locate(Index v) {
    p_ = coordinates(v);
    return hint_ = walk(hint_).link >> 3;
  }

  /// kInserted: point v is a vertex, with the triangles first_new and first_new + 1 beside those
  /// that it changed; the search for `next` will start near it. kTwin: it has the coordinates of
  /// vertex twin(). kFenced: the fence was met. In both cases nothing is changed.
  /// Cost: the walk from the last point, and the degree of the new vertex.
  Outcome insert(Index v, Index first_new, Index next) {
    if (hint_ == kNoIndex) return Outcome::kFenced;
    p_ = coordinates(v);
    const SeenTriangle place = walk(hint_);
    if (place.link & kFence) return Outcome::kFenced;
    twin_ = twin_of_p(place);
    if (twin_ != kNoIndex) return Outcome::kTwin;
    slots_[0].number = first_new;
    slots_[1].number = first_new + 1;
    const Index towards_next = replace_hole(v, place, difference(next));
    if (towards_next == kNoIndex) return Outcome::kFenced;
    hint_ = towards_next;
    return Outcome::kInserted;
  }

  Index twin() const { return twin_; }

 private:
  using Two = predicate_filter::Two;
  using LiftedPair = predicate_filter::LiftedPair;

  // Most stars have fewer edges than this.
  static constexpr std::size_t kUsualStar = 64;
  static constexpr Index kGhostVertex = Triangulation2::kGhost;

  // A vertex as p sees it.
  struct Corner {
    Two xy;
    double sq;
    Index vertex;
  };

  // A triangle as p sees it: the link to one of its edges, which runs from a to b, the corner c
  // opposite, and the minors of its sides.
  struct SeenTriangle {
    std::uint32_t link;
    Corner a, b, c;
    double ab, bc, ca;
  };

  // A side of a triangle of the hole: the link to its outside and what lies there, as far as that
  // is not known from the side: the apex of the triangle behind, and the minors of the edges from
  // the start of the side to the apex and on to its end.
  struct Side {
    std::uint32_t link;
    bool is_in_hole;
    Corner apex;
    double in, out;
  };

  // A side that is left for later. It starts where the one before it ends.
  struct OpenSide {
    Side side;
    Corner end;
  };

  // A triangle of the hole as it is met over one of its edges. The other two, which lead from the
  // rim so far over `middle` to `end`, have these minors and outsides.
  struct InnerTriangle {
    Corner middle, end;
    Two minors;
    std::array<std::uint32_t, 2> links;
  };

  // The number of a triangle of p's star, and the triangle of the hole that had it before.
  struct Slot {
    Index number;
    Triangle removed;
  };

  const Triangle& triangle(std::uint32_t link) const { return triangles_[link >> 3]; }

  // ---- What p sees.

  Point2 p() const { return {p_[0], p_[1]}; }

  Two coordinates(Index v) const { return Two{points_[v].x, points_[v].y}; }

  Two difference(Index v) const { return v == kGhostVertex ? Two{0, 0} : coordinates(v) - p_; }

  Corner see(Index v) const {
    const Two xy = difference(v);
    return {xy, v == kGhostVertex ? ghost_sq_ : predicate_filter::squared_length(xy), v};
  }

  // On which side of edge i of triangle t p lies: positive on its left.
  [[gnu::cold, gnu::noinline]] int exact_side(const Triangle& t, unsigned i) const {
    return orient2d(points_[t.vertex[Triangulation2::next(i)]],
                    points_[t.vertex[Triangulation2::previous(i)]], p());
  }

  // Whether p lies strictly beyond edge i of triangle t, as `minor` estimates.
  bool is_beyond(double minor, double bound, const Triangle& t, unsigned i) const {
    if (!(std::fabs(minor) > bound)) [[unlikely]]
      return exact_side(t, i) < 0;
    return minor < 0;
  }

  // Whether triangle t is in conflict with p, as `determinant` estimates.
  bool is_in_hole(double determinant, double bound, const Triangle& t) const {
    if (!(std::fabs(determinant) > bound)) [[unlikely]]
      return is_in_conflict(t);
    return determinant > 0;
  }

  // Exactly: whether p lies inside the triangle's circumcircle; for a ghost, beyond the hull edge
  // or on it.
  [[gnu::cold, gnu::noinline]] bool is_in_conflict(const Triangle& t) const {
    const auto& v = t.vertex;
    for (unsigned i = 0; i < 3; ++i) {
      if (v[i] != kGhostVertex) continue;
      const int sign = exact_side(t, i);
      if (sign != 0) return sign > 0;
      return strictly_between(points_[v[Triangulation2::next(i)]], p(),
                              points_[v[Triangulation2::previous(i)]]);
    }
    return incircle(points_[v[0]], points_[v[1]], points_[v[2]], p()) > 0;
  }

  static LiftedPair pair_of(const Corner& a, const Corner& b) {
    return {predicate_filter::firsts(a.xy, b.xy), predicate_filter::seconds(a.xy, b.xy),
            Two{a.sq, b.sq}};
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
    Corner a = see(t.vertex[Triangulation2::next(i)]),
           b = see(t.vertex[Triangulation2::previous(i)]);
    double ab = predicate_filter::edge_minor(a.xy, b.xy);
    const double bound = predicate_filter::edge_minor_bound(a.sq, b.sq);
    if (is_beyond(ab, bound, t, i)) {
      link = t.link[i];
      std::swap(a, b);
      ab = -ab;
    }
    return walk_over(link, a, b, ab);
  }

  // The rest of the walk, over the edge from a to b, which has p on the side of the link.
  SeenTriangle walk_over(std::uint32_t link, Corner a, Corner b, double ab) const {
    for (;;) {
      if (link & kFence) return {link, a, b, Corner(), ab, 0, 0};
      const Triangle& t = triangle(link);
      const unsigned i = link & 3, next = Triangulation2::next(i),
                     previous = Triangulation2::previous(i);
      const Corner c = see(t.vertex[i]);
      if (t.vertex[i] == kGhostVertex) return {link, a, b, c, ab, 0, 0};
      const LiftedPair from = pair_of(b, c), to = pair_of(c, a);
      const Two minors = predicate_filter::edge_minors(from, to);
      const Two bounds = predicate_filter::edge_minor_bound(from.sq, to.sq);
      if (is_beyond(minors[0], bounds[0], t, next)) {
        link = t.link[next];
        a = c;
        ab = -minors[0];
      } else if (is_beyond(minors[1], bounds[1], t, previous)) {
        link = t.link[previous];
        b = c;
        ab = -minors[1];
      } else {
        return {link, a, b, c, ab, minors[0], minors[1]};
      }
    }
  }

  // The corner of the triangle that has p's coordinates, or kNoIndex.
  Index twin_of_p(const SeenTriangle& place) const {
    if ((place.a.sq != 0) & (place.b.sq != 0) & (place.c.sq != 0)) return kNoIndex;
    for (const Index v : triangle(place.link).vertex)
      if (v != kGhostVertex && points_[v] == p()) return v;
    return kNoIndex;
  }

  // ---- Insertion.

  // The star of p, vertex v, as far as it is written. What only the loop of replace_hole calls is
  // always inlined there, for structs in registers.
  struct Star {
    Triangle* triangles;
    Index v;
    Two next;          // the next point
    Corner start;      // where the rim goes on
    const Slot* slot;  // for the next triangle
    Index before = kNoIndex;
    // Whether `start` lies to the right of the way to the next point.
    bool is_right = predicate_filter::edge_minor(start.xy, next) >= 0;
    // The last triangle that does not and that does look towards the next point.
    std::array<Index, 2> looking = {slot->number, slot->number};

    // Adds the triangle inside the edge of the rim from `start` to `end`.
    [[gnu::always_inline]] void add(std::uint32_t link, const Corner& end) {
      const Index here = slot->number;
      ++slot;
      triangles[here] = {{v, start.vertex, end.vertex},
                         {link, packed_link(slot->number, 2), packed_link(before, 1)}};
      triangles[link >> 3].link[link & 3] = packed_link(here, 0);
      before = here;
      const bool end_is_right = predicate_filter::edge_minor(end.xy, next) >= 0;
      looking[is_right & !end_is_right] = here;
      is_right = end_is_right;
      start = end;
    }

    void close(Index first) {
      triangles[before].link[1] = packed_link(first, 2);
      triangles[first].link[2] = packed_link(before, 1);
    }
  };

  // What lies outside the two sides of a triangle of the hole that lead from `start` over
  // inner.middle to inner.end.
  [[gnu::always_inline]] std::array<Side, 2> look_behind(const Corner& start,
                                                         const InnerTriangle& inner) const {
    const auto [first, second] = inner.links;
    const Triangle &t = triangles_[first >> 3], &u = triangles_[second >> 3];
    const Index a = t.vertex[first & 3], b = u.vertex[second & 3];
    const Two a_xy = difference(a), b_xy = difference(b);
    LiftedPair apex = predicate_filter::lifted(a_xy, b_xy);
    if (a == kGhostVertex) [[unlikely]]
      apex.sq[0] = ghost_sq_;
    if (b == kGhostVertex) [[unlikely]]
      apex.sq[1] = ghost_sq_;
    const LiftedPair from = pair_of(start, inner.middle), to = pair_of(inner.middle, inner.end);
    const Two in = predicate_filter::edge_minors(from, apex);
    const Two out = predicate_filter::edge_minors(apex, to);
    const auto [determinants, bounds] =
        predicate_filter::incircles_of_minors(to, from, apex, -inner.minors, in, out);
    return {
        Side{
            first, is_in_hole(determinants[0], bounds[0], t), {a_xy, apex.sq[0], a}, in[0], out[0]},
        Side{second,
             is_in_hole(determinants[1], bounds[1], u),
             {b_xy, apex.sq[1], b},
             in[1],
             out[1]}};
  }

  // The triangle outside a side that ends at `end`. It is in the hole, so its number and what it is
  // go into the slot.
  [[gnu::always_inline]] InnerTriangle take_out(const Side& side, const Corner& end,
                                                Slot& slot) const {
    const Triangle& t = triangle(side.link);
    const unsigned i = side.link & 3;
    slot = {side.link >> 3, t};
    return {side.apex,
            end,
            Two{side.in, side.out},
            {t.link[Triangulation2::next(i)], t.link[Triangulation2::previous(i)]}};
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
  [[gnu::noinline]] Index replace_hole(Index v, const SeenTriangle& root, Two next) {
    Slot* slots = slots_.data();
    OpenSide* stack = stack_.data();
    std::size_t room = slots_.size(), slot_count = 3, open = 1;
    Star star{triangles_, v, next, root.a, slots};
    const unsigned i = root.link & 3, previous = Triangulation2::previous(i);
    const std::uint32_t last = triangle(root.link).link[previous];
    stack[0] = {look_behind(root.c, {root.a, root.c, Two{root.ca, root.ca}, {last, last}})[0],
                root.a};
    InnerTriangle inner = take_out(
        {packed_link(root.link >> 3, previous), true, root.b, root.ab, root.bc}, root.c, slots[2]);
    for (;;) {
      OpenSide into;  // the side over which the next triangle of the hole is met
      const auto [first, second] = look_behind(star.start, inner);
      if (first.is_in_hole) {
        stack[open++] = {second, inner.end};
        into = {first, inner.middle};
      } else {
        star.add(first.link, inner.middle);
        if (second.is_in_hole) {
          into = {second, inner.end};
        } else {
          star.add(second.link, inner.end);
          while (open > 0 && !stack[open - 1].side.is_in_hole) {
            --open;
            star.add(stack[open].side.link, stack[open].end);
          }
          if (open == 0) break;
          into = stack[--open];
        }
      }
      if (into.side.link & kFence) return restore_hole(slot_count);
      inner = take_out(into.side, into.end, slots[slot_count++]);
      if (slot_count == room) [[unlikely]] {
        const auto written = star.slot - slots;
        make_room();
        slots = slots_.data();
        star.slot = slots + written;
        stack = stack_.data();
        room = slots_.size();
      }
    }
    star.close(slots[0].number);
    return star.looking[1];
  }

  void make_room() {
    slots_.resize(2 * slots_.size());
    stack_.resize(2 * stack_.size());
  }

  // Puts back the triangles of the hole, and the links to them. Returns kNoIndex.
  [[gnu::cold, gnu::noinline]] Index restore_hole(std::size_t slot_count) {
    for (std::size_t k = 2; k < slot_count; ++k) {
      const auto& [number, removed] = slots_[k];
      triangles_[number] = removed;
      for (unsigned i = 0; i < 3; ++i) {
        const std::uint32_t outside = removed.link[i];
        triangles_[outside >> 3].link[outside & 3] = packed_link(number, i);
      }
    }
    return kNoIndex;
  }

  Triangle* triangles_;
  const Point2* points_;
  Index hint_ = 0;
  Index twin_ = kNoIndex;
  double ghost_sq_;  // how the ghost is seen; its size does not matter to a sign
  Two p_ = {};       // the point that goes in
  // Scratch space. The slots are the numbers that the triangles of p's star get: two new ones, then
  // those of the hole, whose triangles were `removed`.
  std::vector<Slot> slots_;
  std::vector<OpenSide> stack_;
};

}  // namespace wellspaced
