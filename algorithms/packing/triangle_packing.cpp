#include "wellspaced/algorithms/packing/triangle_packing.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "wellspaced/algorithms/packing/point_on_segment.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr std::uint64_t kPiecesAQuestion = 1024;

// Whether p lies inside the circle with diameter ab.
bool in_diametral_circle(Point2 a, Point2 b, Point2 p) {
  return (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) < 0;
}

bool names_less(const BoundaryPiece& p, const BoundaryPiece& q) {
  return p.a < q.a || (p.a == q.a && p.b < q.b);
}

// The corners of a square three times as large as the box of the points.
std::array<Point2, 4> far_corners(std::span<const Point2> points) {
  const Box2 box = Box2::around(points);
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const Point2 low{box.low.x - size, box.low.y - size}, high{box.high.x + size, box.high.y + size};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

}  // namespace

// ---- The start -----------------------------------------------------------------------------

Result<TrianglePacking> TrianglePacking::start(const PackedBoundary& boundary,
                                               const InteriorOptions& options) {
  std::vector<Point2> points = boundary.points;
  for (const Point2 p : far_corners(boundary.points)) points.push_back(p);
  ProgressMeter meter(options.progress, "start", 0, kPiecesAQuestion);
  const Progress go_on = [&](auto, auto, auto) { return meter.step(kPiecesAQuestion); };
  Result<Delaunay2> delaunay = Delaunay2::build(points, {go_on});
  if (!delaunay) return delaunay.error();
  TrianglePacking packing(std::move(*delaunay), boundary, options);
  if (Status status = packing.insert_pieces(meter); !status) return status.error();
  packing.index_pieces();
  for (const Point2 p : boundary.points) {
    if (!meter.step()) return cancelled();
    packing.radius_.push_back(options.radius(p));
  }
  packing.radius_.resize(points.size());
  packing.find_zones();
  return packing;
}

Status TrianglePacking::insert_pieces(ProgressMeter& meter) {
  for (const BoundaryPiece& piece : boundary_->pieces) {
    if (!meter.step()) return cancelled();
    const auto chain = delaunay_.insert_constraint(piece.a, piece.b);
    if (!chain) return chain.error();
    if (chain->size() != 2)
      return Error{ErrorCode::kInvalidGeometry,
                   {"a point lies on the piece of boundary ", piece.a, "-", piece.b},
                   {piece.a, piece.b}};
  }
  return Ok{};
}

void TrianglePacking::index_pieces() {
  pieces_ = boundary_->pieces;
  segment_of_.assign(delaunay_.points().size(), kNoIndex);
  for (BoundaryPiece& piece : pieces_) {
    if (piece.a > piece.b) std::swap(piece.a, piece.b);
    if (piece.segment == kNoIndex) continue;
    const Segment& whole = boundary_->segments[piece.segment];
    for (const Index v : {piece.a, piece.b})
      if (v != whole.a && v != whole.b) segment_of_[v] = piece.segment;
  }
  sort(pieces_, names_less);
}

const BoundaryPiece* TrianglePacking::initial_piece(Index a, Index b) const {
  const BoundaryPiece wanted{std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(pieces_.begin(), pieces_.end(), wanted, names_less);
  const bool is_it = found != pieces_.end() && found->a == wanted.a && found->b == wanted.b;
  return is_it ? &*found : nullptr;
}

// The segment whose piece runs from a to b; kNoIndex for a chord.
Index TrianglePacking::segment_of(Index a, Index b) const {
  if (const BoundaryPiece* piece = initial_piece(a, b)) return piece->segment;
  return segment_of_[std::max(a, b)];  // the later one was put there by a split
}

bool TrianglePacking::is_chord(Edge e) const {
  const Triangulation2& topology = delaunay_.topology();
  return segment_of(topology.origin(e), topology.destination(e)) == kNoIndex;
}

// Each region that segments enclose is a zone; what it is, is asked at its largest triangle.
void TrianglePacking::find_zones() {
  const Triangulation2& topology = delaunay_.topology();
  zone_of_.assign(topology.size(), kNoIndex);
  for (Index t = 0; t < topology.size(); ++t) {
    if (zone_of_[t] != kNoIndex) continue;
    const Index zone = static_cast<Index>(zones_.size());
    const Index largest = flood(t, zone);
    zones_.push_back({.is_inside = false});
    if (largest == kNoIndex) continue;
    const auto& [a, b, c] = topology.vertices(largest);
    const Point2 p = point(a), q = point(b), r = point(c);
    zones_.back() = options_->zone_at({p.x / 3 + q.x / 3 + r.x / 3, p.y / 3 + q.y / 3 + r.y / 3});
  }
}

// Gives `zone` to what can be reached from triangle `first` without crossing a segment. Returns the
// triangle of the largest area among them; none if the hull is reached.
Index TrianglePacking::flood(Index first, Index zone) {
  const Triangulation2& topology = delaunay_.topology();
  std::vector<Index> front{first};
  zone_of_[first] = zone;
  Index largest = first;
  bool reaches_hull = false;
  while (!front.empty()) {
    const Index t = front.back();
    front.pop_back();
    reaches_hull = reaches_hull || topology.is_ghost(t);
    if (!reaches_hull && doubled_area(t) > doubled_area(largest)) largest = t;
    for (unsigned i = 0; i < 3; ++i) {
      const Index u = topology.neighbor(t, i);
      if (zone_of_[u] != kNoIndex) continue;
      if (topology.is_constrained({t, i}) && !is_chord({t, i})) continue;
      zone_of_[u] = zone;
      front.push_back(u);
    }
  }
  return reaches_hull ? kNoIndex : largest;
}

double TrianglePacking::doubled_area(Index t) const {
  const auto& [a, b, c] = delaunay_.topology().vertices(t);
  const Point2 p = point(a), q = point(b), r = point(c);
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

// ---- Walking -------------------------------------------------------------------------------

TrianglePacking::Walk TrianglePacking::walk(Index t, Point2 p) const {
  const Triangulation2& topology = delaunay_.topology();
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
  unsigned entry = 3;
  for (Index step = 0; step < topology.size(); ++step) {
    Edge ahead;
    for (unsigned i = 0; i < 3; ++i) {
      if (i == entry) continue;
      const Edge e{t, i};
      const int side = orient2d(point(topology.origin(e)), point(topology.destination(e)), p);
      if (side <= 0 && topology.is_constrained(e)) return {kNoIndex, e};
      if (side < 0) ahead = e;
    }
    if (ahead.triangle == kNoIndex) return {t, {}};
    const Edge entered = topology.mirror(ahead);
    t = entered.triangle;
    entry = entered.i;
  }
  return {};
}

// ---- Adding points -------------------------------------------------------------------------

// Adds p, in triangle t, if it is at least clearance(v) from each vertex v that it would be joined
// to and in no protective circle, else names the piece whose circle it is in.
template <class Clearance>
Index TrianglePacking::add(Point2 p, Index t, Clearance clearance, Edge& wall) {
  const auto is_free = [&](std::span<const Triangulation2::RimEdge> rim) {
    for (const auto& [origin, outside] : rim)
      if (distance(p, point(origin)) < clearance(origin)) return false;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Edge outside{rim[i].outside >> 3, rim[i].outside & 3};
      if (!delaunay_.topology().is_constrained(outside)) continue;
      const Index next = rim[i + 1 < rim.size() ? i + 1 : 0].origin;
      if (!in_diametral_circle(point(rim[i].origin), point(next), p)) continue;
      wall = outside;
      return false;
    }
    return true;
  };
  const Index zone = zone_of_[t];
  const Index v = delaunay_.insert_if(p, t, is_free);
  if (v != kNoIndex) adopt_star(v, zone);
  return v;
}

Index TrianglePacking::add_ball(Point2 p, Index t, double radius) {
  Edge wall;
  const Index v = add(
      p, t, [&](Index w) { return radius + radius_[w]; }, wall);
  if (v != kNoIndex) remember(radius, kNoIndex);
  return v;
}

Index TrianglePacking::add_point(Point2 p, Index t, double clearance, Edge& wall) {
  const Index v = add(
      p, t, [&](Index) { return clearance; }, wall);
  if (v != kNoIndex) remember(options_->radius(p), kNoIndex);
  return v;
}

// What is known of the newest vertex.
void TrianglePacking::remember(double radius, Index segment) {
  radius_.push_back(radius);
  segment_of_.push_back(segment);
}

// The new triangles around a vertex inside a zone.
void TrianglePacking::adopt_star(Index v, Index zone) {
  const Triangulation2& topology = delaunay_.topology();
  zone_of_.resize(topology.size());
  const Edge first = delaunay_.edge_from(v);
  Edge e = first;
  do {
    zone_of_[e.triangle] = zone;
    e = topology.next_around_origin(e);
  } while (e != first);
}

bool TrianglePacking::is_sharp(Index v) const {
  return std::binary_search(boundary_->sharp.begin(), boundary_->sharp.end(), v);
}

// Where to split the piece from a to b, as a fraction of the whole segment: in the middle, or, next
// to a sharp corner, at the power of two from it that is nearest to the middle.
double TrianglePacking::split_fraction(const Segment& segment, Index a, Index b) const {
  const Point2 start = point(segment.a);
  const double whole = distance(start, point(segment.b));
  const double from = distance(start, point(a)), to = distance(start, point(b));
  const double middle = (from + to) / (2 * whole);
  const bool at_start = (a == segment.a || b == segment.a) && is_sharp(segment.a);
  const bool at_end = (a == segment.b || b == segment.b) && is_sharp(segment.b);
  if (at_start == at_end) return middle;
  const double half = std::fabs(to - from) / 2;
  double shell = std::ldexp(1, std::ilogb(half));  // half is in [shell, 2 shell)
  if (half > 1.5 * shell) shell *= 2;              // so shell is in (2/3, 4/3] half
  return at_start ? shell / whole : 1 - shell / whole;
}

Index TrianglePacking::split(Edge wall, double clearance) {
  const Triangulation2& topology = delaunay_.topology();
  const Index a = topology.origin(wall), b = topology.destination(wall);
  const BoundaryPiece* piece = initial_piece(a, b);
  if (piece != nullptr && piece->is_fixed) return kNoIndex;
  const Index whole = segment_of(a, b);
  const Segment& segment = boundary_->segments[whole];
  const Point2 p =
      point_on_segment(point(segment.a), point(segment.b), split_fraction(segment, a, b));
  if (std::min(distance(p, point(a)), distance(p, point(b))) < clearance) return kNoIndex;
  const Index left = zone_of_[wall.triangle];
  const Index right = zone_of_[topology.mirror(wall).triangle];
  const Result<Index> v = delaunay_.split_edge(wall, p);
  if (!v) return kNoIndex;
  remember(options_->radius(p), whole);
  adopt_split(*v, b, left, right);
  return *v;
}

// The new triangles around vertex v on a piece that ends in b, which has left_zone on its left.
void TrianglePacking::adopt_split(Index v, Index b, Index left_zone, Index right_zone) {
  const Triangulation2& topology = delaunay_.topology();
  zone_of_.resize(topology.size());
  const Edge first = delaunay_.find_edge(v, b);
  Index zone = left_zone;
  Edge e = first;
  do {
    zone_of_[e.triangle] = zone;
    e = topology.next_around_origin(e);
    if (topology.is_constrained(e)) zone = right_zone;
  } while (e != first);
}

bool TrianglePacking::spans_sharp_corner(Index p, Index q) const {
  const Index s = segment_of_[p], t = segment_of_[q];
  if (s == kNoIndex || t == kNoIndex || s == t) return false;
  const Segment &f = boundary_->segments[s], &g = boundary_->segments[t];
  const Index apex = f.a == g.a || f.a == g.b ? f.a : f.b == g.a || f.b == g.b ? f.b : kNoIndex;
  if (apex == kNoIndex || !is_sharp(apex)) return false;
  const double to_p = distance(point(apex), point(p)), to_q = distance(point(apex), point(q));
  return std::fabs(to_p - to_q) <= 0.001 * to_p;
}

// ---- The result ----------------------------------------------------------------------------

// The chords have served their purpose; none of their circles holds a point, so nothing flips.
void TrianglePacking::release_chords() {
  for (const BoundaryPiece& piece : pieces_)
    if (piece.segment == kNoIndex)
      delaunay_.remove_constraint(delaunay_.find_edge(piece.a, piece.b));
}

// The pieces at triangles inside, by segment and along it.
void TrianglePacking::collect_segments(std::span<const Index> number,
                                       std::vector<Segment>& segments) const {
  struct Found {
    Index segment;
    double along;
    Index a, b;
  };
  const Triangulation2& topology = delaunay_.topology();
  std::vector<Found> found;
  for (Index t = 0; t < topology.size(); ++t)
    for (unsigned i = 0; i < 3; ++i) {
      const Edge e{t, i}, m = topology.mirror(e);
      if (!topology.is_constrained(e) || !is_inside(t)) continue;
      if (is_inside(m.triangle) && m.triangle < t) continue;  // found from there
      Index a = topology.origin(e), b = topology.destination(e);
      const Index s = segment_of(a, b);
      const Point2 start = point(boundary_->segments[s].a);
      if (distance(start, point(b)) < distance(start, point(a))) std::swap(a, b);
      found.push_back({s, distance(start, point(a)), a, b});
    }
  sort(found, [](const Found& f, const Found& g) {
    return std::tie(f.segment, f.along) < std::tie(g.segment, g.along);
  });
  for (const Found& f : found)
    segments.push_back({number[f.a], number[f.b], boundary_->segments[f.segment].marker});
}

PackedInterior TrianglePacking::result() {
  release_chords();
  const Triangulation2& topology = delaunay_.topology();
  PackedInterior result;
  std::vector<Index> number(delaunay_.points().size(), kNoIndex);
  for (Index t = 0; t < topology.size(); ++t) {
    if (!is_inside(t)) continue;
    result.mesh.triangles.push_back(topology.vertices(t));
    result.attributes.push_back(zone(t).attribute);
    for (const Index v : topology.vertices(t)) number[v] = 0;
  }
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    number[v] = static_cast<Index>(result.mesh.points.size());
    result.mesh.points.push_back(point(v));
    result.radius.push_back(radius_[v]);
    result.boundary_point.push_back(v < boundary_->points.size() ? v : kNoIndex);
  }
  for (Corners& corners : result.mesh.triangles)
    for (Index& v : corners) v = number[v];
  collect_segments(number, result.mesh.segments);
  return result;
}

}  // namespace wellspaced
