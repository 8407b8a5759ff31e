#include "wellspaced/algorithms/generate/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/plane/circumcircle.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// Inserts circumcentres into the constrained triangulation of a domain's boundary.
//
// A triangle awaits its turn on the stack with its corners, since its number may have been given to
// another one by then. New triangles come on top: the work stays in one place, and so in cache.
class Refinement {
 public:
  Refinement(Delaunay2 delaunay, const Pslg& boundary, const SpacingFunction& spacing)
      : delaunay_(std::move(delaunay)), boundary_(boundary), spacing_(spacing) {}

  Status run(std::size_t max_points, const Progress& progress);
  TriangleMesh mesh() const;

 private:
  using Edge = Delaunay2::Edge;
  using Corners = std::array<Index, 3>;
  struct Candidate {
    Index triangle;
    Corners corners;
  };

  std::vector<bool> outside() const;
  void refine(const Candidate& candidate);
  bool is_too_large(const Circle& circle, const Corners& corners) const;
  Index walk(Index t, Point2 target) const;
  void push(Index t);
  void push_star(Index v);
  Point2 point(Index v) const { return delaunay_.points()[v]; }

  Delaunay2 delaunay_;
  const Pslg& boundary_;
  const SpacingFunction& spacing_;
  std::vector<Candidate> stack_;
};

// Marks the triangles that are reached from the hull or from a hole without crossing a constraint.
std::vector<bool> Refinement::outside() const {
  const Triangulation2& topology = delaunay_.topology();
  std::vector<bool> reached(topology.size());
  std::vector<Index> stack;
  const auto reach = [&](Index t) {
    if (reached[t]) return;
    reached[t] = true;
    stack.push_back(t);
  };
  for (Index t = 0; t < topology.size(); ++t)
    if (topology.is_ghost(t)) reach(t);
  for (const Point2 hole : boundary_.holes) reach(delaunay_.locate(hole).edge.triangle);
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (unsigned i = 0; i < 3; ++i)
      if (!topology.is_constrained({t, i})) reach(topology.neighbor(t, i));
  }
  return reached;
}

void Refinement::push(Index t) { stack_.push_back({t, delaunay_.topology().vertices(t)}); }

void Refinement::push_star(Index v) {
  const Edge first = delaunay_.edge_from(v);
  Edge e = first;
  do {
    push(e.triangle);
    e = delaunay_.topology().next_around_origin(e);
  } while (!(e == first));
}

bool Refinement::is_too_large(const Circle& circle, const Corners& corners) const {
  constexpr double kLeastRadius = 0.7;  // in spacings; keeps the repair of small angles finite
  const double spacing = spacing_(circle.centre);
  if (circle.radius_sq > spacing * spacing) return true;
  if (circle.radius_sq < kLeastRadius * kLeastRadius * spacing * spacing) return false;
  const auto& [a, b, c] = corners;
  const double smallest = std::max({corner_cotangent(point(a), point(b), point(c)),
                                    corner_cotangent(point(b), point(c), point(a)),
                                    corner_cotangent(point(c), point(a), point(b))});
  return smallest > kCotangentOf25Degrees;
}

// The triangle that holds `target` in its interior or on an edge free of constraints, if a walk
// from triangle t that crosses no constraint gets there, else kNoIndex.
Index Refinement::walk(Index t, Point2 target) const {
  const Triangulation2& topology = delaunay_.topology();
  for (Index step = 0; step < topology.size(); ++step) {
    Edge ahead;
    for (unsigned i = 0; i < 3 && ahead.triangle == kNoIndex; ++i) {
      const Edge e{t, i};
      const int side = orient2d(point(topology.origin(e)), point(topology.destination(e)), target);
      if (side <= 0 && topology.is_constrained(e)) return kNoIndex;
      if (side < 0) ahead = e;
    }
    if (ahead.triangle == kNoIndex) return t;
    t = topology.neighbor(t, ahead.i);
  }
  return kNoIndex;
}

void Refinement::refine(const Candidate& candidate) {
  const Corners& corners = candidate.corners;
  if (delaunay_.topology().vertices(candidate.triangle) != corners) return;
  const Circle circle = circumcircle(point(corners[0]), point(corners[1]), point(corners[2]));
  if (!std::isfinite(circle.radius_sq) || !is_too_large(circle, corners)) return;
  const Index near = walk(candidate.triangle, circle.centre);
  if (near == kNoIndex) return;
  const Index next = static_cast<Index>(delaunay_.points().size());
  const auto inserted = delaunay_.insert(circle.centre, near);
  if (inserted && *inserted == next) push_star(next);
}

Status Refinement::run(std::size_t max_points, const Progress& progress) {
  constexpr std::size_t kReportEvery = 1024;
  const std::vector<bool> is_outside = outside();
  for (Index t = 0; t < is_outside.size(); ++t)
    if (!is_outside[t]) push(t);
  for (std::size_t step = 0; !stack_.empty(); ++step) {
    const std::size_t points = delaunay_.points().size();
    if (points > max_points)
      return Error{ErrorCode::kLimit, "the mesh would have more nodes than the limit", {}};
    if (step % kReportEvery == 0 && !report(progress, "refine", points, max_points))
      return Error{ErrorCode::kCancelled, "cancelled", {}};
    const Candidate candidate = stack_.back();
    stack_.pop_back();
    refine(candidate);
  }
  return Ok{};
}

TriangleMesh Refinement::mesh() const {
  TriangleMesh result;
  const std::vector<bool> is_outside = outside();
  for (Index t = 0; t < is_outside.size(); ++t)
    if (!is_outside[t]) result.triangles.push_back(delaunay_.topology().vertices(t));
  result.points = delaunay_.points();
  result.segments = boundary_.segments;
  return result;
}

}  // namespace

Result<TriangleMesh> refine_by_spacing(const Pslg& boundary, const SpacingFunction& spacing,
                                       std::size_t max_points, const Progress& progress) {
  auto delaunay = Delaunay2::build(boundary.points);
  if (!delaunay) return delaunay.error();
  for (const Segment& segment : boundary.segments)
    if (auto chain = delaunay->insert_constraint(segment.a, segment.b); !chain)
      return chain.error();
  Refinement refinement(std::move(*delaunay), boundary, spacing);
  if (Status done = refinement.run(max_points, progress); !done) return done.error();
  return refinement.mesh();
}

}  // namespace wellspaced
