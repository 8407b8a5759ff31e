#include "wellspaced/algorithms/mesh/sight_search.hpp"

#include <algorithm>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// Distances that are larger by rounding alone are not larger.
constexpr double kDiscMargin = 1 + 0x1p-40;

}  // namespace

SightSearch::SightSearch(const Visibility& visibility)
    : visibility_(visibility),
      cones_(visibility),
      node_stamp_(visibility.mesh().points.size(), 0),
      triangle_stamp_(visibility.mesh().triangles.size(), 0) {}

std::span<const Index> SightSearch::run(Index p, double radius) {
  start(p, radius);
  if (!(radius > 0) || flood()) return nodes_;
  start(p, radius);
  cones_.spread(
      p, [&](Index a, Index b) { return edge_meets_disc(a, b); }, [&](Index v) { visit(v); });
  return nodes_;
}

void SightSearch::start(Index p, double radius) {
  if (++stamp_ == 0) {  // all of 2^32 stamps are used up: start again
    std::fill(node_stamp_.begin(), node_stamp_.end(), 0);
    std::fill(triangle_stamp_.begin(), triangle_stamp_.end(), 0);
    stamp_ = 1;
  }
  viewer_ = p;
  radius_ = radius;
  nodes_.clear();
  triangles_.clear();
  visit(p);
}

// Visits the triangles that are joined to the viewer within the disc, which sees all of their nodes
// there unless a line of sight is broken, and comes back into the domain through a wall. Returns
// false at the first that it may come through.
bool SightSearch::flood() {
  const TriangleMesh& mesh = visibility_.mesh();
  enter_around(viewer_);
  for (std::size_t next = 0; next < triangles_.size(); ++next) {
    const Index t = triangles_[next];
    const auto& corners = mesh.triangles[t];
    for (const Index v : corners)
      if (visit(v)) enter_around(v);
    for (unsigned i = 0; i < 3; ++i) {
      const Index neighbor = visibility_.links().neighbor(t, i);
      if (neighbor != kNoIndex && triangle_stamp_[neighbor] == stamp_) continue;
      const Index a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
      if (!edge_meets_disc(a, b)) continue;
      if (neighbor != kNoIndex)
        enter(neighbor);
      else if (may_hide(a, b))
        return false;
    }
  }
  return true;
}

// Whether a wall is seen from behind, or is the other lip of a slit on which the viewer lies.
bool SightSearch::may_hide(Index a, Index b) const {
  const std::vector<Point2>& points = visibility_.mesh().points;
  const Point2 p = points[a], q = points[b], viewer = points[viewer_];
  const int side = orient2d(p, q, viewer);
  if (side != 0 || a == viewer_ || b == viewer_) return side < 0;
  const auto [low_x, high_x] = std::minmax(p.x, q.x);
  const auto [low_y, high_y] = std::minmax(p.y, q.y);
  return low_x <= viewer.x && viewer.x <= high_x && low_y <= viewer.y && viewer.y <= high_y;
}

// Fans of triangles may meet in a node alone.
void SightSearch::enter_around(Index node) {
  for (const Index t : visibility_.links().around(node)) enter(t);
}

void SightSearch::enter(Index triangle) {
  if (triangle_stamp_[triangle] == stamp_) return;
  triangle_stamp_[triangle] = stamp_;
  triangles_.push_back(triangle);
}

// Whether the node is new, and within the radius.
bool SightSearch::visit(Index node) {
  if (node_stamp_[node] == stamp_) return false;
  node_stamp_[node] = stamp_;
  const std::vector<Point2>& points = visibility_.mesh().points;
  if (distance(points[viewer_], points[node]) > radius_) return false;
  nodes_.push_back(node);
  return true;
}

// In units of the radius, so that no product underflows; what overflows counts as meeting.
bool SightSearch::edge_meets_disc(Index a, Index b) const {
  const std::vector<Point2>& points = visibility_.mesh().points;
  const Point2 p = points[a], q = points[b], centre = points[viewer_];
  const double ax = (p.x - centre.x) / radius_, ay = (p.y - centre.y) / radius_;
  const double bx = (q.x - centre.x) / radius_, by = (q.y - centre.y) / radius_;
  const double ux = bx - ax, uy = by - ay;
  if (ax * ax + ay * ay <= kDiscMargin || bx * bx + by * by <= kDiscMargin) return true;
  if (ax * ux + ay * uy > 0 || bx * ux + by * uy < 0) return false;
  const double area = ax * by - ay * bx;
  return !(area * area > kDiscMargin * (ux * ux + uy * uy));
}

}  // namespace wellspaced
