#include "wellspaced/kernel/plane/delaunay2.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/large_pages.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {

int Delaunay2::turn(Index a, Index b, Index c) const {
  return orient2d(points_[a], points_[b], points_[c]);
}

// ---- Location ------------------------------------------------------------------------------

// The place of a point on the closed side of all edges of triangle t, from its side of each.
static Delaunay2::Location place_in_triangle(Index t, const int (&side)[3]) {
  using Place = Delaunay2::Place;
  const unsigned zeros = (side[0] == 0) + (side[1] == 0) + (side[2] == 0);
  if (zeros == 0) return {Place::kFace, {t, 0}};
  const unsigned edge = side[0] == 0 ? 0 : side[1] == 0 ? 1 : 2;
  if (zeros == 1) return {Place::kEdge, {t, edge}};
  const unsigned corner = side[0] != 0 ? 0 : side[1] != 0 ? 1 : 2;
  return {Place::kVertex, {t, Triangulation2::previous(corner)}};
}

int Delaunay2::side_of_edge(Edge e, Point2 p) const {
  return orient2d(points_[topology_.origin(e)], points_[topology_.destination(e)], p);
}

// A visibility walk: from triangle to triangle over an edge that has p strictly on its far side.
// In a Delaunay triangulation it cannot run in circles; with constraints it could, so its length
// is bounded, and what it does not find is looked up.
Delaunay2::Location Delaunay2::locate(Point2 p, Index hint) const {
  assert(dimension_ == 2);
  Index t = hint < topology_.size() ? hint : 0;
  if (topology_.is_ghost(t)) t = topology_.neighbor(t, topology_.corner_of(t, kGhost));
  unsigned entry = 3;  // the edge over which t was entered; none yet
  for (Index steps = 0; steps < topology_.size(); ++steps) {
    int side[3] = {1, 1, 1};
    unsigned exit = 3;
    for (unsigned i = 0; i < 3 && exit == 3; ++i)
      if (i != entry && (side[i] = side_of_edge({t, i}, p)) < 0) exit = i;
    if (exit == 3) return place_in_triangle(t, side);
    const Edge entered = topology_.mirror({t, exit});
    if (topology_.apex(entered) == kGhost) return {Place::kOutside, entered};
    t = entered.triangle;
    entry = entered.i;
  }
  return locate_exhaustively(p);
}

Delaunay2::Location Delaunay2::locate_exhaustively(Point2 p) const {
  for (Index t = 0; t < topology_.size(); ++t) {
    if (topology_.is_ghost(t)) {
      const Edge hull{t, topology_.corner_of(t, kGhost)};
      if (side_of_edge(hull, p) > 0) return {Place::kOutside, hull};
      continue;
    }
    const int side[3] = {side_of_edge({t, 0}, p), side_of_edge({t, 1}, p), side_of_edge({t, 2}, p)};
    if (side[0] >= 0 && side[1] >= 0 && side[2] >= 0) return place_in_triangle(t, side);
  }
  return {};  // not reached: the triangles cover the hull, and hull edges see all points outside
}

// ---- Insertion -----------------------------------------------------------------------------

// The open half plane beyond the hull edge, and the open edge itself.
bool Delaunay2::ghost_in_conflict(Index t, Point2 p) const {
  const Edge hull{t, topology_.corner_of(t, kGhost)};
  const int side = side_of_edge(hull, p);
  if (side != 0) return side > 0;
  return strictly_between(points_[topology_.origin(hull)], p, points_[topology_.destination(hull)]);
}

inline bool Delaunay2::in_conflict(Index t, Point2 p) const {
  if (topology_.is_ghost(t)) return ghost_in_conflict(t, p);
  const auto& v = topology_.vertices(t);
  return incircle(points_[v[0]], points_[v[1]], points_[v[2]], p) > 0;
}

bool Delaunay2::is_locally_delaunay(Edge e) const {
  const Edge m = topology_.mirror(e);
  const Index far = topology_.apex(m);
  if (topology_.is_constrained(e) || far == kGhost) return true;
  return topology_.is_ghost(e.triangle) || !in_conflict(e.triangle, points_[far]);
}

// Collects the triangles in conflict with p that are connected to `root`, which is one of them,
// without a constrained edge between; and the rim around them, counter-clockwise.
//
// No vertex lies inside the hole, so its triangles form a tree: each is met once, no mark is
// needed, and walking the tree in order meets the rim in order. A stack entry is the link over an
// edge, out of the hole as known so far.
void Delaunay2::find_cavity(Edge root, Point2 p, Cavity& cavity) const {
  const auto& triangles = topology_.triangles_;
  cavity.hole.assign(1, root.triangle);
  cavity.rim.clear();
  const auto& links = triangles[root.triangle].link;
  cavity.stack.assign({links[2], links[1], links[0]});
  while (!cavity.stack.empty()) {
    const std::uint32_t link = cavity.stack.back();
    cavity.stack.pop_back();
    const Index t = link >> 3;
    const unsigned i = link & 3;
    const auto& triangle = triangles[t];
    if (!(link & Triangulation2::kConstrained) && in_conflict(t, p)) {
      cavity.hole.push_back(t);
      cavity.stack.push_back(triangle.link[Triangulation2::previous(i)]);
      cavity.stack.push_back(triangle.link[Triangulation2::next(i)]);
    } else {
      cavity.rim.push_back({triangle.vertex[Triangulation2::previous(i)], link});
    }
  }
}

// ---- Building ------------------------------------------------------------------------------

Result<Delaunay2> Delaunay2::build(std::span<const Point2> points, const Options& options) {
  if (Status status = check_points(points); !status) return status.error();
  Delaunay2 result;
  // Fresh memory costs time, so the points are sorted where they will be copied to.
  reserve_large(result.points_, points.size());
  result.points_.resize(points.size());
  InsertionRuns runs = insertion_runs(points, region_count(points.size()),
                                      std::as_writable_bytes(std::span(result.points_)));
  if (!result.build_from(points, runs, options))
    return Error{ErrorCode::kCancelled, "the triangulation was cancelled", {}};
  return result;
}

Result<Delaunay2> Delaunay2::build(std::span<const Point2> points,
                                   std::span<const Index> along_curve) {
  assert(along_curve.size() == points.size());
  if (Status status = check_points(points); !status) return status.error();
  Delaunay2 result;
  InsertionRuns runs{1, insertion_order(along_curve), {static_cast<Index>(points.size())}};
  result.build_from(points, runs, {});
  return result;
}

// Triangulates points[order[0]], points[order[1]], ... Returns false if it was told to stop.
bool Delaunay2::build_from(std::span<const Point2> points, InsertionRuns& runs,
                           const Options& options) {
  std::vector<Index>& order = runs.order;
  points_.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) points_[i] = points[order[i]];
  std::vector<Duplicate> duplicates;
  if (start()) {
    if (!insert_in_order(runs, options, duplicates)) return false;
  } else {
    duplicates = sort_out_duplicates();
  }
  if (!report(options.progress, "triangulate", points.size(), points.size())) return false;
  number_as_input(points, order, duplicates);
  return true;
}

// Makes the first triangle, of the first points in general position. Returns false if there are
// none; dimension_ is set either way.
bool Delaunay2::start() {
  const Index n = static_cast<Index>(points_.size());
  Index b = 1, c = 2;
  while (b < n && points_[b] == points_[0]) ++b;
  dimension_ = n == 0 ? -1 : b >= n ? 0 : 1;
  if (dimension_ < 1) return false;
  c = b + 1;
  while (c < n && turn(0, b, c) == 0) ++c;
  if (c >= n) return false;
  dimension_ = 2;
  topology_.triangles_.reserve(2 * static_cast<std::size_t>(n));
  turn(0, b, c) > 0 ? topology_.reset(0, b, c) : topology_.reset(0, c, b);
  return true;
}

// Duplicates of points that span no triangle.
std::vector<Delaunay2::Duplicate> Delaunay2::sort_out_duplicates() const {
  std::vector<Index> sorted(points_.size());
  for (Index i = 0; i < sorted.size(); ++i) sorted[i] = i;
  sort(sorted, [&](Index a, Index b) {
    if (points_[a] == points_[b]) return a < b;
    return points_[a] < points_[b];
  });
  std::vector<Duplicate> duplicates;
  for (std::size_t i = 1, first = 0; i < sorted.size(); ++i) {
    if (points_[sorted[i]] == points_[sorted[first]])
      duplicates.push_back({sorted[i], sorted[first]});
    else
      first = i;
  }
  return duplicates;
}

// From numbers in insertion order to the caller's: vertex v becomes order[v], or the lowest number
// among its duplicates.
void Delaunay2::number_as_input(std::span<const Point2> points, std::vector<Index>& order,
                                const std::vector<Duplicate>& duplicates) {
  if (!duplicates.empty()) {
    const std::vector<Index> input_number = order;
    for (const auto& [point, vertex] : duplicates)
      order[vertex] = std::min(order[vertex], input_number[point]);
    for (const auto& [point, vertex] : duplicates) order[point] = order[vertex];
    allocate_representatives();
    for (std::size_t i = 0; i < order.size(); ++i) representative_[input_number[i]] = order[i];
    duplicate_count_ += duplicates.size();
  }
  // Fresh memory costs time, and that of the sorted points is needed no more.
  struct Vertex {
    Index number, triangle;
  };
  static_assert(sizeof(Vertex) <= sizeof(Point2) && alignof(Vertex) <= alignof(Point2));
  const std::span vertices(reinterpret_cast<Vertex*>(points_.data()), points_.size());
  for (std::size_t i = 0; i < order.size(); ++i) vertices[i] = {order[i], kNoIndex};
  for (Index t = topology_.size(); t-- > 0;) {
    for (Index& v : topology_.triangles_[t].vertex) {
      if (v == kGhost) continue;
      vertices[v].triangle = t;
      v = vertices[v].number;
    }
  }
  // Only here the numbers jump about: in insertion order, neighbours are near each other.
  triangle_of_ = std::move(order);
  triangle_of_.assign(points_.size(), kNoIndex);
  for (const auto& [number, triangle] : vertices)
    if (triangle != kNoIndex) triangle_of_[number] = triangle;
  points_.assign(points.begin(), points.end());
}

void Delaunay2::allocate_representatives() {
  if (!representative_.empty()) return;
  representative_.resize(points_.size());
  for (Index i = 0; i < representative_.size(); ++i) representative_[i] = i;
}

void Delaunay2::refresh_triangle_of(Index t) {
  for (const Index v : topology_.vertices(t))
    if (v != kGhost) triangle_of_[v] = t;
}

Delaunay2::Edge Delaunay2::edge_from(Index v) const {
  const Index t = triangle_of_.empty() ? kNoIndex : triangle_of_[v];
  if (t == kNoIndex) return {};
  return {t, Triangulation2::previous(topology_.corner_of(t, v))};
}

Delaunay2::Edge Delaunay2::find_edge(Index a, Index b) const {
  const Edge first = edge_from(a);
  if (first.triangle == kNoIndex) return {};
  Edge e = first;
  do {
    if (topology_.destination(e) == b) return e;
    e = topology_.next_around_origin(e);
  } while (e != first);
  return {};
}

}  // namespace wellspaced
