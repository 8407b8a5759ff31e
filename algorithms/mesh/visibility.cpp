#include "wellspaced/algorithms/mesh/visibility.hpp"

#include <array>
#include <utility>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

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
  if (is_among(q, corners)) return true;
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

}  // namespace wellspaced
