#include "wellspaced/algorithms/packing/interior_packing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wellspaced/algorithms/packing/triangle_packing.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using Edge = Delaunay2::Edge;
using PackedCorners = TrianglePacking::Corners;

// A triangle that awaits its turn, with its corners, since its number may be another's by then.
struct Waiting {
  Index triangle;
  PackedCorners corners;
};

// One that is badly shaped; the worst comes first.
struct BadTriangle {
  double cotangent;
  Waiting waiting;
};

bool is_less_bad(const BadTriangle& a, const BadTriangle& b) {
  if (a.cotangent != b.cotangent) return a.cotangent < b.cotangent;
  return a.waiting.corners > b.waiting.corners;
}

// The work loop: first triangles that may have room for a ball, the latest first, so that the work
// stays in one place and in cache; then the worst shaped one, which makes new triangles for both.
class InteriorPacking {
 public:
  InteriorPacking(TrianglePacking packing, const InteriorOptions& options)
      : packing_(std::move(packing)), options_(options) {
    const Point2 unit = circle_point(options.smallest_angle_deg / 360);
    const Point2 half = circle_point(options.smallest_angle_deg / 720);
    largest_cotangent_ = unit.x / unit.y;
    off_centre_height_ = kOffCentre * half.x / half.y / 2;
  }

  void run();
  PackedInterior result();

 private:
  // Off-centres are put a little nearer than where their triangle has just the angle wanted.
  static constexpr double kOffCentre = 0.95;
  // How near to others a point that cuts a bad triangle may come, in radii of the balls around.
  static constexpr double kClearance = 1.0 / 64;

  bool keep_going();
  void push_star(Index v);
  void push_all();
  void drain();
  void try_ball(const Waiting& waiting);
  bool has_room(const Circle& circle, const PackedCorners& corners, double& radius) const;
  bool is_alive(const Waiting& waiting) const {
    const auto& [a, b, c] = packing_.delaunay().topology().vertices(waiting.triangle);
    return a == waiting.corners[0] && b == waiting.corners[1] && c == waiting.corners[2];
  }
  void push_if_bad(Index t);
  void cut(const Waiting& waiting);
  Index put_ball(const Waiting& waiting, Point2 centre, double radius);
  Index put_ball_near(const Waiting& waiting, Point2 p);
  std::pair<Index, Index> shortest_edge(const PackedCorners& corners) const;
  Point2 towards(Index a, Index b, Point2 centre, double height) const;
  Point2 kissing(const PackedCorners& corners, Point2 centre, double radius) const;
  Point2 displaced(const Circle& circle);
  Point2 off_centre(const PackedCorners& corners, Point2 centre) const;
  double clearance(const PackedCorners& corners) const;

  TrianglePacking packing_;
  const InteriorOptions& options_;
  double largest_cotangent_, off_centre_height_;
  bool cuts_ = false;
  std::vector<Waiting> waiting_;
  std::vector<BadTriangle> bad_;
  std::size_t balls_packed_ = 0, steps_ = 0;
  Random random_{1};
  bool is_complete_ = true, was_cancelled_ = false;
};

bool InteriorPacking::keep_going() {
  constexpr std::size_t kReportEvery = 256;
  if (!is_complete_) return false;
  const std::size_t points = packing_.delaunay().points().size() - 4;  // but for the far ones
  if (points >= options_.max_points) is_complete_ = false;
  if (steps_++ % kReportEvery == 0 &&
      !report(options_.progress, "pack", points, options_.max_points))
    was_cancelled_ = true, is_complete_ = false;
  return is_complete_;
}

void InteriorPacking::push_all() {
  const Triangulation2& topology = packing_.delaunay().topology();
  for (Index t = 0; t < topology.size(); ++t) {
    if (!packing_.is_inside(t)) continue;
    if (cuts_)
      push_if_bad(t);
    else
      waiting_.push_back({t, topology.vertices(t)});
  }
}

void InteriorPacking::push_star(Index v) {
  const Triangulation2& topology = packing_.delaunay().topology();
  const Edge first = packing_.delaunay().edge_from(v);
  Edge e = first;
  do {
    if (packing_.is_inside(e.triangle)) {
      waiting_.push_back({e.triangle, topology.vertices(e.triangle)});
      push_if_bad(e.triangle);
    }
    e = topology.next_around_origin(e);
  } while (e != first);
}

void InteriorPacking::run() {
  push_all();
  drain();
  cuts_ = options_.smallest_angle_deg > 0;
  push_all();
  for (;;) {
    drain();
    while (cuts_ && waiting_.empty() && !bad_.empty() && keep_going()) {
      std::pop_heap(bad_.begin(), bad_.end(), is_less_bad);
      const Waiting worst = bad_.back().waiting;
      bad_.pop_back();
      if (is_alive(worst)) cut(worst);
    }
    if (!waiting_.empty() && is_complete_) continue;
    if (!is_complete_ || options_.maximality == Maximality::kDelaunay) return;
    const Index before = static_cast<Index>(packing_.delaunay().points().size());
    balls_packed_ += fill_completely(packing_, [this] { return !keep_going(); });
    const Index after = static_cast<Index>(packing_.delaunay().points().size());
    if (after == before) return;
    for (Index v = before; v < after; ++v) push_star(v);
  }
}

// ---- Balls ---------------------------------------------------------------------------------

void InteriorPacking::drain() {
  while (!waiting_.empty() && keep_going()) {
    const Waiting next = waiting_.back();
    waiting_.pop_back();
    if (is_alive(next)) try_ball(next);
  }
}

// Whether a ball around the centre leaves those of the corners alone. Where the slope of the radius
// tells, it need not be asked for.
bool InteriorPacking::has_room(const Circle& circle, const PackedCorners& corners,
                               double& radius) const {
  const double distance = std::sqrt(circle.radius_sq);
  double largest = 0;
  for (const Index v : corners) largest = std::max(largest, packing_.radius(v));
  if (largest >= distance) return false;
  if (2 * largest - options_.slope * distance > distance) return false;
  radius = packing_.radius_at(circle.centre);
  return radius + largest <= distance;
}

void InteriorPacking::try_ball(const Waiting& waiting) {
  const Circle circle = packing_.circle_of(waiting.corners);
  double radius = 0;
  if (!std::isfinite(circle.radius_sq) || !has_room(circle, waiting.corners, radius)) return;
  Index v = kNoIndex;
  if (options_.placement == BallPlacement::kKissing)
    v = put_ball_near(waiting, kissing(waiting.corners, circle.centre, radius));
  if (options_.placement == BallPlacement::kGeneric) v = put_ball_near(waiting, displaced(circle));
  if (v == kNoIndex) v = put_ball(waiting, circle.centre, radius);
  if (v == kNoIndex) return;
  ++balls_packed_;
  push_star(v);
}

Index InteriorPacking::put_ball(const Waiting& waiting, Point2 centre, double radius) {
  const Index t = packing_.walk(waiting.triangle, centre).triangle;
  if (t == kNoIndex) return t;
  if (!packing_.stays_far(centre, 2 * radius)) return kNoIndex;
  return packing_.add_ball(centre, t, radius);
}

// The same beside a circumcentre, where the radius is another.
Index InteriorPacking::put_ball_near(const Waiting& waiting, Point2 p) {
  return put_ball(waiting, p, packing_.radius_at(p));
}

// A point near the middle of the circle.
Point2 InteriorPacking::displaced(const Circle& circle) {
  constexpr double kShare = 1.0 / 64;  // of the circle's radius
  const double reach = kShare * std::sqrt(circle.radius_sq);
  const double x = random_.uniform(-reach, reach);
  return {circle.centre.x + x, circle.centre.y + random_.uniform(-reach, reach)};
}

// The point on the way from the middle of the shortest edge to the circumcentre from which the ends
// are as far as balls of this radius need, and a hair more.
Point2 InteriorPacking::kissing(const PackedCorners& corners, Point2 centre, double radius) const {
  const auto [a, b] = shortest_edge(corners);
  const double reach = (radius + std::max(packing_.radius(a), packing_.radius(b))) * (1 + 1e-9);
  const double half = distance(packing_.point(a), packing_.point(b)) / 2;
  return towards(a, b, centre, std::sqrt(std::max(0.0, reach * reach - half * half)));
}

// ---- Bad triangles -------------------------------------------------------------------------

void InteriorPacking::push_if_bad(Index t) {
  if (!cuts_) return;
  const PackedCorners& corners = packing_.delaunay().topology().vertices(t);
  const Point2 a = packing_.point(corners[0]), b = packing_.point(corners[1]),
               c = packing_.point(corners[2]);
  const double largest =
      std::max({corner_cotangent(a, b, c), corner_cotangent(b, c, a), corner_cotangent(c, a, b)});
  const bool is_large = packing_.doubled_area(t) > 2 * packing_.zone(t).max_area;
  if (!(largest > largest_cotangent_) && !is_large) return;
  bad_.push_back({largest, {t, corners}});
  std::push_heap(bad_.begin(), bad_.end(), is_less_bad);
}

double InteriorPacking::clearance(const PackedCorners& corners) const {
  double least = packing_.radius(corners[0]);
  for (const Index v : corners) least = std::min(least, packing_.radius(v));
  return kClearance * least;
}

std::pair<Index, Index> InteriorPacking::shortest_edge(const PackedCorners& corners) const {
  unsigned shortest = 0;
  double length = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const double side = distance(packing_.point(corners[i]), packing_.point(corners[(i + 1) % 3]));
    if (i == 0 || side < length) shortest = i, length = side;
  }
  return {corners[shortest], corners[(shortest + 1) % 3]};
}

// The point at `height` on the way from the middle of the edge to the circumcentre; that itself, if
// it is nearer.
Point2 InteriorPacking::towards(Index a, Index b, Point2 centre, double height) const {
  const Point2 p = packing_.point(a), q = packing_.point(b);
  const Point2 middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
  const double whole = distance(middle, centre);
  if (!(whole > height)) return centre;
  return {middle.x + (centre.x - middle.x) * (height / whole),
          middle.y + (centre.y - middle.y) * (height / whole)};
}

// The point from which the shortest edge is seen at about the angle wanted.
Point2 InteriorPacking::off_centre(const PackedCorners& corners, Point2 centre) const {
  const auto [a, b] = shortest_edge(corners);
  return towards(a, b, centre, off_centre_height_ * distance(packing_.point(a), packing_.point(b)));
}

void InteriorPacking::cut(const Waiting& waiting) {
  const Circle circle = packing_.circle_of(waiting.corners);
  if (!std::isfinite(circle.radius_sq)) return;
  const Point2 target = off_centre(waiting.corners, circle.centre);
  const double least = clearance(waiting.corners);
  auto [t, wall] = packing_.walk(waiting.triangle, target);
  Index v = kNoIndex;
  if (t != kNoIndex) v = packing_.add_point(target, t, least, wall);
  if (v == kNoIndex && wall.triangle != kNoIndex) v = packing_.split(wall, least);
  if (v == kNoIndex) return;
  push_star(v);
  if (is_alive(waiting)) push_if_bad(waiting.triangle);
}

PackedInterior InteriorPacking::result() {
  PackedInterior result = packing_.result();
  result.balls_packed = balls_packed_;
  result.is_complete = is_complete_;
  result.was_cancelled = was_cancelled_;
  return result;
}

}  // namespace

Result<PackedInterior> pack_interior(const PackedBoundary& boundary,
                                     const InteriorOptions& options) {
  Result<TrianglePacking> packing = TrianglePacking::start(boundary, options);
  if (!packing) return packing.error();
  InteriorPacking work(std::move(*packing), options);
  work.run();
  return work.result();
}

}  // namespace wellspaced
