#include "wellspaced/algorithms/mesh/sight_cones.hpp"

#include <algorithm>

#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

unsigned corner_at(const std::array<Index, 3>& corners, Index node) {
  return corners[0] == node ? 0 : corners[1] == node ? 1 : 2;
}

}  // namespace

SightCones::SightCones(const Visibility& visibility)
    : visibility_(visibility),
      curves_(visibility.mesh().points.size(), 0),
      is_looked_along_(curves_.size(), 0),
      first_waiting_(visibility.mesh().triangles.size(), kNone) {
  const std::vector<std::array<Index, 3>>& triangles = visibility.mesh().triangles;
  for (Index t = 0; t < triangles.size(); ++t)
    for (unsigned i = 0; i < 3; ++i)
      if (visibility.links().neighbor(t, i) == kNoIndex) ++curves_[triangles[t][(i + 1) % 3]];
}

void SightCones::spread(Index p, const Enters& enters, const Sees& sees) {
  viewer_ = p;
  cones_.clear();
  look_around(enters, sees);
  while (!triangles_.empty()) {
    std::pop_heap(triangles_.begin(), triangles_.end(), std::greater<>());
    const Index t = triangles_.back().second;
    triangles_.pop_back();
    look_through(t, enters, sees);
  }
  for (const Index v : looked_along_) is_looked_along_[v] = 0;
  looked_along_.clear();
}

// On which side of the ray from the viewer through a node another one lies: 1 on its left.
int SightCones::side(Index through, Index v) const {
  const std::vector<Point2>& points = visibility_.mesh().points;
  return orient2d(points[viewer_], points[through], points[v]);
}

// The power of the viewer with respect to the circumcircle, up to rounding; an order to work in.
double SightCones::power(Index triangle) const {
  const TriangleMesh& mesh = visibility_.mesh();
  const Point2 p = mesh.points[viewer_];
  const auto from_viewer = [&](unsigned i) {
    const Point2 q = mesh.points[mesh.triangles[triangle][i]];
    return Point2{q.x - p.x, q.y - p.y};
  };
  const auto cross = [](Point2 u, Point2 v) { return u.x * v.y - u.y * v.x; };
  const auto square = [](Point2 u) { return u.x * u.x + u.y * u.y; };
  const Point2 a = from_viewer(0), b = from_viewer(1), c = from_viewer(2);
  const double bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double power = -(square(a) * bc + square(b) * ca + square(c) * ab) / (bc + ca + ab);
  return power == power ? power : 0;
}

void SightCones::look_around(const Enters& enters, const Sees& sees) {
  for (const Index t : visibility_.links().around(viewer_)) {
    const auto& corners = visibility_.mesh().triangles[t];
    const unsigned i = corner_at(corners, viewer_);
    const Index right = corners[(i + 1) % 3], left = corners[(i + 2) % 3];
    pass(t, i, {right, left}, enters);
    for (const Index v : {right, left}) {
      sees(v);
      look_along(v, enters, sees);
    }
  }
}

void SightCones::look_through(Index triangle, const Enters& enters, const Sees& sees) {
  std::uint32_t k = std::exchange(first_waiting_[triangle], kNone);
  while (k != kNone) {
    const Waiting waiting = cones_[k];
    k = waiting.next;
    look_past(triangle, waiting, enters, sees);
  }
}

// Through the two other edges of the triangle, to either side of the far corner or past it.
void SightCones::look_past(Index triangle, const Waiting& waiting, const Enters& enters,
                           const Sees& sees) {
  const auto& [right, left] = waiting.cone;
  const unsigned at_left = (waiting.apex + 1) % 3, at_right = (waiting.apex + 2) % 3;
  const Index far = visibility_.mesh().triangles[triangle][waiting.apex];
  const int of_right = side(right, far), of_left = left == right ? of_right : side(left, far);
  if (of_right > 0 && of_left < 0) {
    pass(triangle, at_left, {right, far}, enters);
    pass(triangle, at_right, {far, left}, enters);
    sees(far);
    if (curves_[far] > 1) look_along(far, enters, sees);
    return;
  }
  pass(triangle, of_right <= 0 ? at_right : at_left, waiting.cone, enters);
  if (of_right != 0 && of_left != 0) return;
  sees(far);
  look_along(far, enters, sees);
}

// On from a node of the boundary that is seen: walls may end at it on both sides of the line. Nodes
// of the line may follow one another; each is taken once.
void SightCones::look_along(Index first, const Enters& enters, const Sees& sees) {
  const std::size_t before = looked_along_.size();
  const auto reach = [&](Index v) {
    if (curves_[v] == 0 || is_looked_along_[v]) return;
    looked_along_.push_back(v);
    is_looked_along_[v] = 1;
  };
  reach(first);
  for (std::size_t k = before; k < looked_along_.size(); ++k) {
    const Index node = looked_along_[k];
    for (const Index t : visibility_.links().around(node)) {
      const auto& corners = visibility_.mesh().triangles[t];
      const unsigned i = corner_at(corners, node);
      const Index right = corners[(i + 1) % 3], left = corners[(i + 2) % 3];
      const int of_right = side(node, right), of_left = side(node, left);
      if (of_right > 0 || of_left < 0) continue;
      pass(t, i, {node, node}, enters);
      if (of_right == 0) sees(right), reach(right);
      if (of_left == 0) sees(left), reach(left);
    }
  }
}

// Leaves the cone to wait behind the edge opposite a corner.
void SightCones::pass(Index triangle, unsigned corner, Cone cone, const Enters& enters) {
  const std::vector<std::array<Index, 3>>& triangles = visibility_.mesh().triangles;
  const Index right = triangles[triangle][(corner + 1) % 3];
  const Index left = triangles[triangle][(corner + 2) % 3];
  const Index next = visibility_.links().neighbor(triangle, corner);
  if (next == kNoIndex || !enters(right, left)) return;
  const unsigned apex = (corner_at(triangles[next], left) + 2) % 3;
  if (joins(next, apex, cone)) return;
  if (first_waiting_[next] == kNone) {
    triangles_.emplace_back(power(next), next);
    std::push_heap(triangles_.begin(), triangles_.end(), std::greater<>());
  }
  cones_.push_back({cone, apex, first_waiting_[next]});
  first_waiting_[next] = static_cast<std::uint32_t>(cones_.size() - 1);
}

// Whether a cone beside it, or around it, waits at the same edge and takes it up.
bool SightCones::joins(Index triangle, unsigned apex, Cone cone) {
  for (std::uint32_t k = first_waiting_[triangle]; k != kNone; k = cones_[k].next) {
    if (cones_[k].apex != apex) continue;
    Cone& other = cones_[k].cone;
    const bool is_line = cone.right == cone.left;
    if (is_line && side(other.right, cone.left) >= 0 && side(other.left, cone.left) <= 0)
      return true;
    if (is_line || other.right == other.left) continue;
    if (other.left == cone.right) return other.left = cone.left, true;
    if (other.right == cone.left) return other.right = cone.right, true;
  }
  return false;
}

}  // namespace wellspaced
