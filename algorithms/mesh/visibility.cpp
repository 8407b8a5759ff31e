#include "wellspaced/algorithms/mesh/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

constexpr unsigned corner_after(unsigned i) { return (i + 1) % 3; }
constexpr unsigned corner_before(unsigned i) { return (i + 2) % 3; }

int sign_of_step(double from, double to) { return (from < to) - (to < from); }

// Whether p, on the line from a to b, lies on b's side of a. Requires: a != b.
bool is_ahead(Point2 p, Point2 a, Point2 b) {
  return a.x != b.x ? sign_of_step(a.x, p.x) == sign_of_step(a.x, b.x)
                    : sign_of_step(a.y, p.y) == sign_of_step(a.y, b.y);
}

// Distances that are larger by rounding alone are not larger.
constexpr double kDiscMargin = 1 + 0x1p-40;

// In which of `count` sectors, counter-clockwise, the direction from p to q lies: by its place on
// the diamond |x| + |y| = 1, up to rounding. Requires: p != q.
int sector(Point2 p, Point2 q, int count) {
  double dx = q.x - p.x, dy = q.y - p.y;
  if (!std::isfinite(std::fabs(dx) + std::fabs(dy))) {
    dx = q.x / 4 - p.x / 4;
    dy = q.y / 4 - p.y / 4;
  }
  const double up = dy / (std::fabs(dx) + std::fabs(dy));
  const double place = dx < 0 ? 2 - up : dy < 0 ? 4 + up : up;  // 0 to 4
  return std::clamp(static_cast<int>(place / 4 * count), 0, count - 1);
}

}  // namespace

Visibility::Visibility(const TriangleMesh& mesh)
    : mesh_(mesh), links_(mesh.triangles, static_cast<Index>(mesh.points.size())) {}

bool Visibility::sees(Index p, Index q) const {
  const Line line{mesh_.points[p], q, mesh_.points[q]};
  return arrives(line, {p, kNoIndex, 0});
}

bool Visibility::sees(Point2 x, Index at, Index q) const {
  const auto& corners = mesh_.triangles[at];
  for (const Index v : corners)
    if (mesh_.points[v] == x) return sees(v, q);
  if (std::find(corners.begin(), corners.end(), q) != corners.end()) return true;
  const Line line{x, q, mesh_.points[q]};
  return arrives(line, leave_triangle(line, at));
}

// Every step moves on along the line. At the tip of a slit that lies on it the line may follow
// either lip: one is put off. The bound is for invalid meshes.
bool Visibility::arrives(Line line, Place place) const {
  std::vector<Index> put_off;
  std::size_t steps = 2 * (mesh_.triangles.size() + mesh_.points.size() + 1);
  while (steps-- > 0) {
    if (place.node == line.to) return true;
    if (place.node == kNoIndex && place.triangle == kNoIndex) {
      if (put_off.empty()) return false;
      place = {put_off.back(), kNoIndex, 0};
      put_off.pop_back();
    } else if (place.node == kNoIndex) {
      place = cross_edge(line, place);
    } else {
      line.from = mesh_.points[place.node];
      place = line.from == line.end ? Place{} : leave_node(line, place.node, put_off);
    }
  }
  return false;
}

// From a node along an edge to the next one, or through the triangle whose wedge holds the line.
Visibility::Place Visibility::leave_node(const Line& line, Index v,
                                         std::vector<Index>& put_off) const {
  Index next = kNoIndex;
  for (const Index t : links_.around(v)) {
    const auto& corners = mesh_.triangles[t];
    const unsigned i = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
    const Index a = corners[corner_after(i)], b = corners[corner_before(i)];
    if (a == line.to || b == line.to) return {line.to, kNoIndex, 0};
    const int side_a = orient2d(line.from, line.end, mesh_.points[a]);
    const int side_b = orient2d(line.from, line.end, mesh_.points[b]);
    if (side_a < 0 && side_b > 0) return {kNoIndex, t, i};
    for (const auto& [node, side] : {std::pair{a, side_a}, std::pair{b, side_b}}) {
      if (side != 0 || node == next || !is_ahead(mesh_.points[node], line.from, line.end)) continue;
      if (next != kNoIndex) put_off.push_back(next);
      next = node;
    }
  }
  return {next, kNoIndex, 0};
}

// From a point in a triangle, no corner of it.
Visibility::Place Visibility::leave_triangle(const Line& line, Index t) const {
  const auto& corners = mesh_.triangles[t];
  std::array<int, 3> side;
  for (unsigned i = 0; i < 3; ++i) {
    const Point2 p = mesh_.points[corners[i]];
    side[i] = orient2d(line.from, line.end, p);
    if (side[i] == 0 && is_ahead(p, line.from, line.end)) return {corners[i], kNoIndex, 0};
  }
  for (unsigned i = 0; i < 3; ++i)
    if (side[corner_after(i)] < 0 && side[corner_before(i)] > 0) return {kNoIndex, t, i};
  return {};
}

// Over the edge into the next triangle: out of it by another edge, or to its far corner.
Visibility::Place Visibility::cross_edge(const Line& line, Place place) const {
  const Index from = mesh_.triangles[place.triangle][corner_before(place.corner)];
  const Index t = links_.neighbor(place.triangle, place.corner);
  if (t == kNoIndex) return {};
  const auto& corners = mesh_.triangles[t];
  // In t the edge crossed runs from `from`, on the left of the line, to the corner on its right.
  const unsigned left = corners[0] == from ? 0 : corners[1] == from ? 1 : 2;
  const unsigned apex = corner_before(left);
  const int side = orient2d(line.from, line.end, mesh_.points[corners[apex]]);
  if (side == 0) return {corners[apex], kNoIndex, 0};
  return {kNoIndex, t, side > 0 ? left : corner_after(left)};
}

SightSearch::SightSearch(const Visibility& visibility)
    : visibility_(visibility),
      node_stamp_(visibility.mesh().points.size(), 0),
      triangle_stamp_(visibility.mesh().triangles.size(), 0) {}

std::span<const Index> SightSearch::run(Index p, double radius) {
  if (++stamp_ == 0) {  // all of 2^32 stamps are used up: start again
    std::fill(node_stamp_.begin(), node_stamp_.end(), 0);
    std::fill(triangle_stamp_.begin(), triangle_stamp_.end(), 0);
    stamp_ = 1;
  }
  flood(p, radius);
  // A line of sight that is broken comes back into the domain through a wall seen from behind.
  if (backs_.empty()) return nodes_;
  const std::vector<Point2>& points = visibility_.mesh().points;
  cast_shadows(points[p]);
  std::erase_if(nodes_, [&](Index q) {
    return may_be_hidden(points[q], points[p]) && !visibility_.sees(p, q);
  });
  return nodes_;
}

// Visits the triangles that are joined to p within the disc. What p sees there is among them, and
// so are the walls that a line of sight from p to a node visited comes back in by.
void SightSearch::flood(Index p, double radius) {
  const TriangleMesh& mesh = visibility_.mesh();
  const Point2 centre = mesh.points[p];
  nodes_.clear();
  triangles_.clear();
  backs_.clear();
  visit_node(p, p, radius);
  if (!(radius > 0)) return;
  for (std::size_t next = 0; next < triangles_.size(); ++next) {
    const Index t = triangles_[next];
    const auto& corners = mesh.triangles[t];
    for (const Index v : corners) visit_node(v, p, radius);
    for (unsigned i = 0; i < 3; ++i) {
      const Index neighbor = visibility_.links().neighbor(t, i);
      const bool done = neighbor != kNoIndex && triangle_stamp_[neighbor] == stamp_;
      const Index a = corners[corner_after(i)], b = corners[corner_before(i)];
      if (done || !edge_meets_disc(a, b, centre, radius)) continue;
      if (neighbor != kNoIndex) {
        enter(neighbor);
      } else if (orient2d(mesh.points[a], mesh.points[b], centre) < 0) {
        backs_.push_back({a, b});
      }
    }
  }
}

void SightSearch::enter(Index triangle) {
  if (triangle_stamp_[triangle] == stamp_) return;
  triangle_stamp_[triangle] = stamp_;
  triangles_.push_back(triangle);
}

void SightSearch::visit_node(Index node, Index p, double radius) {
  if (node_stamp_[node] == stamp_) return;
  node_stamp_[node] = stamp_;
  const std::vector<Point2>& points = visibility_.mesh().points;
  if (distance(points[p], points[node]) > radius) return;
  nodes_.push_back(node);
  for (const Index t : visibility_.links().around(node)) enter(t);
}

// A wall seen from behind hides no more than the sectors from its end to its beginning, from its
// nearest point on. Neighbouring sectors are taken along for the rounding of directions.
void SightSearch::cast_shadows(Point2 p) {
  shadow_.fill(std::numeric_limits<double>::infinity());
  for (const auto& [from, to] : backs_) {
    const Point2 a = visibility_.mesh().points[from], b = visibility_.mesh().points[to];
    const double begins = (1 - 0x1p-20) * distance_to_segment(p, a, b);
    const int last = (sector(p, a, kSectors) + 1) % kSectors;
    for (int k = (sector(p, b, kSectors) + kSectors - 1) % kSectors;; k = (k + 1) % kSectors) {
      shadow_[k] = std::min(shadow_[k], begins);
      if (k == last) break;
    }
  }
}

bool SightSearch::may_be_hidden(Point2 q, Point2 p) const {
  return q == p || distance(p, q) >= shadow_[sector(p, q, kSectors)];
}

// In units of the radius, so that no product underflows; what overflows counts as meeting.
bool SightSearch::edge_meets_disc(Index a, Index b, Point2 centre, double radius) const {
  const Point2 p = visibility_.mesh().points[a], q = visibility_.mesh().points[b];
  const double ax = (p.x - centre.x) / radius, ay = (p.y - centre.y) / radius;
  const double bx = (q.x - centre.x) / radius, by = (q.y - centre.y) / radius;
  const double ux = bx - ax, uy = by - ay;
  if (ax * ax + ay * ay <= kDiscMargin || bx * bx + by * by <= kDiscMargin) return true;
  if (ax * ux + ay * uy > 0 || bx * ux + by * uy < 0) return false;
  const double area = ax * by - ay * bx;
  return !(area * area > kDiscMargin * (ux * ux + uy * uy));
}

}  // namespace wellspaced
