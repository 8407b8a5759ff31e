// How Delaunay2::build inserts its points: one after the other, each near the one before it.
//
// It is fast because everything is seen from the point p that goes in: a vertex as its difference
// from p and the square of that, an edge (u, v) as the minor ux vy - uy vx. The minor is
// orient2d(u, v, p), by which the walk to p steers, and both triangles at the edge need it for
// incircle. So a step over an edge costs one new vertex and two new minors, in the walk as in the
// search for the triangles that p ends. The ghost is seen as (0, 0, s), the point at infinity of
// the paraboloid: with it incircle says whether p lies beyond the hull edge.
//
// Many points are inserted by region: each round is cut where the curve enters the next of a few
// regions of the plane, and in a large round the regions are filled at the same time. A region owns
// the triangles all of whose real vertices lie in it; a triangle with vertices of several regions
// is a border triangle. While regions are filled, a fence keeps border triangles as they are: a
// point whose way or whose hole leads into one is deferred until all regions are done. Neighbours
// have a real vertex in common, so no region ever comes across a triangle of another. Hence no
// thread reads what another writes, and regions that are filled one after the other give the same
// result, to the number of each triangle.
#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/lifted_filter.hpp"
#include "wellspaced/kernel/parallel.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using predicate_filter::edge_minor;
using predicate_filter::Lifted;

// Most stars have fewer edges than this.
constexpr std::size_t kUsualStar = 64;

// A round of fewer points is not worth dividing.
constexpr Index kRoundWorthDividing = Index{1} << 14;
// So many places are known in each region where a walk may start.
constexpr Index kStarts = 256;
// Whoever listens is asked after so many points.
constexpr Index kAskEvery = Index{1} << 13;

// What different threads write lies this far apart: processors fetch memory in lines.
constexpr std::size_t kCacheLine = 64;

constexpr Index kGhostVertex = Triangulation2::kGhost;
// Marks a link that leads into a border triangle. No edge is constrained yet, so the bit is free.
constexpr std::uint32_t kFence = 4;

constexpr std::uint32_t packed_link(Index t, unsigned i) { return t << 3 | i; }

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

// Makes points[v] vertex v. One a thread. Triangle is Triangulation2's.
template <class Triangle>
class alignas(kCacheLine) PointInserter {
 public:
  enum class Outcome { kInserted, kTwin, kFenced };

  // Requires: `triangles` begins with the Delaunay triangulation of three of the points.
  PointInserter(LargeVector<Triangle>& triangles, std::span<const Point2> points)
      : triangles_(triangles),
        points_(points),
        slots_(kUsualStar),
        stack_(kUsualStar),
        removed_(kUsualStar) {
    const auto& v = triangles[0].vertex;
    ghost_sq_ = predicate_filter::lifted(points[v[0]], points[v[1]]).sq;
  }

  // The next walk starts at triangle `hint`; kNoIndex: there is no way.
  void start_at(Index hint) { hint_ = hint; }

  // The triangle that point v lies in or on, or the ghost that it lies strictly beyond.
  Index locate(Index v) {
    p_ = points_[v];
    return hint_ = walk(hint_).link >> 3;
  }

  // kInserted: point v is a vertex, with the triangles first_new and first_new + 1 beside those
  // that it changed; the search for `next` will start near it. kTwin: it has the coordinates of
  // vertex twin(). kFenced: the fence was met. In both cases nothing is changed.
  // Cost: the walk from the last point, and the degree of the new vertex.
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

// Makes all points vertices, round by round, as long as `progress` does not say stop.
template <class Triangle, class Duplicate>
class BulkInsertion {
 public:
  // Requires: the triangles are the Delaunay triangulation of three of the points, unconstrained.
  BulkInsertion(LargeVector<Triangle>& triangles, std::span<const Point2> points,
                const Delaunay2::Options& options, std::vector<Duplicate>& duplicates)
      : triangles_(triangles),
        points_(points),
        progress_(options.progress),
        duplicates_(duplicates),
        first_(triangles[0].vertex),
        used_(static_cast<Index>(triangles.size())),
        inserters_(std::max(options.threads, 1u), Inserter(triangles, points)) {
    triangles.resize(2 * points.size());
  }

  // `ends` and `regions` as in InsertionRuns. Returns false if it was stopped; then the triangles
  // are of no use.
  bool run(std::span<const Index> ends, unsigned regions) {
    Index begin = 0;
    for (std::size_t first = 0; first < ends.size() && !stopped_; first += regions) {
      const Index end = ends[first + regions - 1];
      if (regions > 1 && end - begin >= kRoundWorthDividing)
        insert_by_region(begin, ends.first(first), ends.subspan(first, regions));
      else
        insert_all(begin, end);
      begin = end;
    }
    triangles_.resize(used_);
    return !stopped_;
  }

 private:
  using Inserter = PointInserter<Triangle>;
  using Outcome = typename Inserter::Outcome;

  struct alignas(kCacheLine) Region {
    std::uint8_t number;
    Index begin, end;       // the points to insert
    Index first_new, next;  // the numbers of their triangles, two a point, and the next of these
    // Triangles near the middle of each of kStarts stretches of the points; kNoIndex where the
    // region does not own it.
    std::vector<Index> starts = {};
    std::vector<Index> deferred = {};
    std::vector<Duplicate> duplicates = {};
  };

  bool is_first(Index v) const { return v == first_[0] || v == first_[1] || v == first_[2]; }

  // Whether to go on at point v. Only the caller's thread asks whoever listens.
  bool go_on(unsigned worker, Index v) {
    if (v % kAskEvery != 0) return true;
    if (worker == 0 && !stopped_) stopped_ = !report(progress_, "triangulate", v, points_.size());
    return !stopped_;
  }

  // One point after the other.
  void insert_all(Index begin, Index end) {
    const Index last = static_cast<Index>(points_.size()) - 1;
    for (Index v = begin; v < end && go_on(0, v); ++v)
      if (!is_first(v) && insert(v, used_, std::min(v + 1, last))) used_ += 2;
  }

  // Returns false if it is a duplicate. Requires: no fence.
  bool insert(Index v, Index first_new, Index next) {
    const Outcome outcome = inserters_[0].insert(v, first_new, next);
    if (outcome == Outcome::kTwin) duplicates_.push_back({v, inserters_[0].twin()});
    return outcome == Outcome::kInserted;
  }

  // ---- By region.

  void insert_by_region(Index begin, std::span<const Index> earlier_ends,
                        std::span<const Index> ends) {
    note_regions(earlier_ends, static_cast<unsigned>(ends.size()));
    const std::vector<Index> border = border_triangles();
    std::vector<Region> regions = make_regions(begin, ends);
    set_fence(border, kFence);
    run_parallel(static_cast<unsigned>(inserters_.size()), regions.size(),
                 [&](unsigned worker, std::size_t r) { fill(regions[r], worker); });
    set_fence(border, 0);
    if (!stopped_) join(regions);
  }

  // Writes down the regions of the vertices of earlier rounds.
  void note_regions(std::span<const Index> ends, unsigned regions) {
    Index begin = 0;
    region_of_vertex_.resize(ends.empty() ? 0 : ends.back());
    for (std::size_t run = 0; run < ends.size(); begin = ends[run++])
      std::fill(region_of_vertex_.begin() + begin, region_of_vertex_.begin() + ends[run],
                static_cast<std::uint8_t>(run % regions));
  }

  // The region that owns a triangle, or kBorder.
  std::uint8_t owner(const Triangle& t) const {
    std::uint8_t region = kBorder;
    for (const Index v : t.vertex) {
      if (v == kGhostVertex) continue;
      if (v >= region_of_vertex_.size()) return kBorder;  // the first triangle came out of turn
      if (region == kBorder) region = region_of_vertex_[v];
      if (region != region_of_vertex_[v]) return kBorder;
    }
    return region;
  }

  std::vector<Region> make_regions(Index begin, std::span<const Index> ends) {
    std::vector<Region> regions;
    for (std::uint8_t r = 0; r < ends.size(); begin = ends[r++]) {
      Region& region = regions.emplace_back(Region{r, begin, ends[r], used_, used_});
      for (Index k = 0; k < kStarts; ++k) region.starts.push_back(start_in(region, k));
      used_ += 2 * (region.end - begin);
    }
    return regions;
  }

  static Index stretch_length(const Region& region) {
    return (region.end - region.begin) / kStarts + 1;
  }

  Index start_in(const Region& region, Index stretch) {
    const Index length = stretch_length(region);
    const Index middle = region.begin + stretch * length + length / 2;
    if (middle >= region.end) return kNoIndex;
    const Index t = inserters_[0].locate(middle);
    return owner(triangles_[t]) == region.number ? t : kNoIndex;
  }

  std::vector<Index> border_triangles() const {
    std::vector<Index> border;
    for (Index t = 0; t < used_; ++t)
      if (owner(triangles_[t]) == kBorder) border.push_back(t);
    return border;
  }

  // Marks the links into border triangles, or takes the marks away.
  void set_fence(std::span<const Index> border, std::uint32_t mark) {
    for (const Index t : border) {
      for (const std::uint32_t link : triangles_[t].link) {
        std::uint32_t& mirror = triangles_[link >> 3].link[link & 3];
        mirror = (mirror & ~kFence) | mark;
      }
    }
  }

  // After each point that is deferred the walk starts afresh: a straight way from the last vertex
  // may lead over the fence again and again.
  void fill(Region& region, unsigned worker) {
    Inserter& inserter = inserters_[worker];
    bool is_lost = true;
    for (Index v = region.begin; v < region.end && go_on(worker, v); ++v) {
      if (is_first(v)) continue;
      if (is_lost) inserter.start_at(region.starts[(v - region.begin) / stretch_length(region)]);
      const Outcome outcome = inserter.insert(v, region.next, std::min(v + 1, region.end - 1));
      if (outcome == Outcome::kInserted) region.next += 2;
      if (outcome == Outcome::kTwin) region.duplicates.push_back({v, inserter.twin()});
      if (outcome == Outcome::kFenced) region.deferred.push_back(v);
      is_lost = outcome == Outcome::kFenced;
    }
  }

  // Makes one triangulation of what the regions left.
  void join(std::span<const Region> regions) {
    std::vector<Index> deferred, gaps;  // the first number of every pair that was not used
    for (const Region& region : regions) {
      deferred.insert(deferred.end(), region.deferred.begin(), region.deferred.end());
      duplicates_.insert(duplicates_.end(), region.duplicates.begin(), region.duplicates.end());
      for (Index t = region.next; t < region.first_new + 2 * (region.end - region.begin); t += 2)
        gaps.push_back(t);
    }
    inserters_[0].start_at(0);
    std::size_t filled = 0;
    for (std::size_t k = 0; k < deferred.size(); ++k) {
      const Index next = deferred[std::min(k + 1, deferred.size() - 1)];
      if (insert(deferred[k], gaps[filled], next)) ++filled;
    }
    close(std::span(gaps).subspan(filled));
    inserters_[0].start_at(0);
  }

  // Moves the last pairs of triangles into the gaps, which ascend.
  void close(std::span<const Index> gaps) {
    for (; !gaps.empty(); gaps = gaps.subspan(1)) {
      for (; !gaps.empty() && gaps.back() == used_ - 2; used_ -= 2)
        gaps = gaps.first(gaps.size() - 1);
      if (gaps.empty()) return;
      used_ -= 2;
      move(used_, gaps.front());
      move(used_ + 1, gaps.front() + 1);
    }
  }

  void move(Index from, Index to) {
    triangles_[to] = triangles_[from];
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t link = triangles_[to].link[i];
      triangles_[link >> 3].link[link & 3] = packed_link(to, i);
    }
  }

  // No region owns a border triangle.
  static constexpr std::uint8_t kBorder = 255;

  LargeVector<Triangle>& triangles_;
  std::span<const Point2> points_;
  const Progress& progress_;
  std::atomic<bool> stopped_ = false;
  std::vector<Duplicate>& duplicates_;
  std::array<Index, 3> first_;       // the corners of the first triangle
  Index used_;                       // so many triangles are there
  std::vector<Inserter> inserters_;  // one a thread
  std::vector<std::uint8_t> region_of_vertex_;
};

}  // namespace

unsigned Delaunay2::region_count(std::size_t points) {
  constexpr std::size_t kOne = 1;
  return points < kOne << 15 ? 1 : points < kOne << 22 ? 2 : points < kOne << 24 ? 4 : 8;
}

bool Delaunay2::insert_in_order(const InsertionRuns& runs, const Options& options,
                                std::vector<Duplicate>& duplicates) {
  const Options useful{options.progress, std::min(options.threads, runs.regions)};
  BulkInsertion insertion(topology_.triangles_, std::span<const Point2>(points_), useful,
                          duplicates);
  return insertion.run(runs.ends, runs.regions);
}

}  // namespace wellspaced
