#include "wellspaced/algorithms/packing/space/room_search3.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/circumsphere.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

constexpr double kSmallestCell = 0x1p-8;       // in radii
constexpr std::size_t kMostTetsAround = 4000;  // more would only make the proof easier
constexpr std::size_t kMostCells = 1 << 20;    // of one tet: so many only for a wild size function

double gap_sq(Point3 p, Point3 q) { return dot(p - q, p - q); }

// Whether the ball of this radius around p lies inside a sphere.
bool lies_within(Point3 p, double radius, const Sphere& sphere) {
  const double room = sphere.radius - radius;
  return room > 0 && gap_sq(p, sphere.centre) < room * room;
}

bool spheres_meet(const Sphere& a, const Sphere& b) {
  const double reach = a.radius + b.radius;
  return gap_sq(a.centre, b.centre) < reach * reach;
}

}  // namespace

double RoomSearch3::Plane::height(Point3 p) const { return dot(outwards, p - on); }

RoomSearch3::RoomSearch3(const Packing3& packing) : packing_(packing) {
  packing_.slope = std::min(packing_.slope, 1.0);
}

// ---- What is around ------------------------------------------------------------------------

// No place in a tet is further than the circumradius from the nearest corner.
bool RoomSearch3::corners_cover(const std::array<Index, 4>& corners) const {
  const auto& [a, b, c, d] = corners;
  const std::vector<double>& radius = packing_.radius;
  const double least = std::min({radius[a], radius[b], radius[c], radius[d]});
  const Sphere sphere = unchecked_circumsphere(point(a), point(b), point(c), point(d));
  return sphere.radius * (1 + packing_.slope) < 2 * least;
}

// Returns the cube around the tet.
RoomSearch3::Cell RoomSearch3::look_at(const std::array<Index, 4>& corners) {
  Box3 box{point(corners[0]), point(corners[0])};
  for (unsigned i = 0; i < 4; ++i) {
    const Point3 p = point(corners[i]);
    corners_[i] = {p, packing_.radius[corners[i]]};
    box.cover({p, p});
    const auto& [j, k, l] = Triangulation3::kFacetCorners[i];
    const Point3 a = point(corners[j]);
    const Point3 normal = cross(point(corners[k]) - a, point(corners[l]) - a);
    faces_[i] = {a, (1 / length(normal)) * normal};
  }
  const Point3 size = box.size();
  return {0.5 * (box.low + box.high), 0.5 * std::max({size.x, size.y, size.z})};
}

// Gathers tets whose circumspheres meet the smallest ball around the middle of the box that holds
// the tet: they are joined by faces, as those are whose circumspheres hold one point.
void RoomSearch3::look_around(Index t, Point3 middle) {
  const Triangulation3& topology = packing_.delaunay.topology();
  double reach = 0, most = 0;
  for (const Sphere& ball : corners_) reach = std::max(reach, length(ball.centre - middle));
  for (const Sphere& ball : corners_) most = std::max(most, ball.radius);
  most += 2 * packing_.slope * reach;
  run_of_.resize(std::max<std::size_t>(run_of_.size(), topology.size()));
  ++runs_;
  tets_.assign(1, t);
  run_of_[t] = runs_;
  balls_.clear();
  guards_.clear();
  vertices_.clear();
  for (std::size_t i = 0; i < tets_.size() && i < kMostTetsAround; ++i) {
    gather(topology.vertices(tets_[i]), {middle, reach});
    for (unsigned k = 0; k < 4; ++k) {
      const Index u = topology.neighbor(tets_[i], k);
      if (topology.is_ghost(u) || run_of_[u] == runs_) continue;
      run_of_[u] = runs_;
      const auto& [a, b, c, d] = topology.vertices(u);
      const Sphere sphere = unchecked_circumsphere(point(a), point(b), point(c), point(d));
      if (spheres_meet(sphere, {middle, reach})) tets_.push_back(u);
    }
  }
  sort_unique(vertices_);
  for (const Index v : vertices_) {
    const Sphere ball{point(v), packing_.radius[v]};
    if (spheres_meet(ball, {middle, reach + most})) balls_.push_back(ball);
  }
}

// Notes the corners of a tet, and the protective spheres that meet `around`.
void RoomSearch3::gather(const std::array<Index, 4>& corners, const Sphere& around) {
  vertices_.insert(vertices_.end(), corners.begin(), corners.end());
  packing_.surface.any_sphere(corners, [&](const ProtectiveSphere& sphere) {
    const Sphere guard{sphere.centre, std::sqrt(sphere.radius_sq)};
    if (spheres_meet(guard, around)) guards_.push_back(guard);
    return false;
  });
}

// ---- The octree ----------------------------------------------------------------------------

// How far p is beyond the faces of the tet; negative inside.
double RoomSearch3::farthest_out(Point3 p) const {
  return std::max(
      {faces_[0].height(p), faces_[1].height(p), faces_[2].height(p), faces_[3].height(p)});
}

// What the radius at p is at least, by those at the corners.
double RoomSearch3::least_radius(Point3 p) const {
  double least = 0;
  for (const Sphere& ball : corners_)
    least = std::max(least, ball.radius - packing_.slope * length(p - ball.centre));
  return least;
}

// Whether a ball or a protective sphere leaves no place in the cell, where radii are at least
// `least`.
bool RoomSearch3::is_full(const Cell& cell, double least) const {
  const double reach = cell.reach();
  const auto is_too_near = [&](const Sphere& ball) {
    return lies_within(cell.centre, reach, {ball.centre, ball.radius + least});
  };
  return any_of(corners_, is_too_near) || any_of(balls_, is_too_near) ||
         any_of(guards_,
                [&](const Sphere& guard) { return lies_within(cell.centre, reach, guard); });
}

void RoomSearch3::split(const Cell& cell) {
  const double half = cell.half / 2;
  for (int i = 0; i < 8; ++i)
    cells_.push_back(
        {{cell.centre.x + (i & 1 ? half : -half), cell.centre.y + (i & 2 ? half : -half),
          cell.centre.z + (i & 4 ? half : -half)},
         half});
}

bool RoomSearch3::run(Index t, const Offer& offer) {
  const std::array<Index, 4> corners = packing_.delaunay.topology().vertices(t);
  if (corners_cover(corners)) return false;
  const Cell box = look_at(corners);
  look_around(t, box.centre);
  cells_.assign(1, box);
  for (std::size_t count = 0; !cells_.empty() && count < kMostCells; ++count) {
    const Cell cell = cells_.back();
    cells_.pop_back();
    const double out = farthest_out(cell.centre), growth = packing_.slope * cell.reach();
    if (out > cell.reach() || is_full(cell, least_radius(cell.centre) - growth)) continue;
    const double radius = packing_.radius_at(cell.centre);
    if (is_full(cell, radius - growth)) continue;
    const bool has_room = out < 0 && !is_full({cell.centre, 0}, radius);
    if (has_room && offer(cell.centre, radius)) return true;
    if (cell.half > kSmallestCell * radius) split(cell);
  }
  return false;
}

}  // namespace wellspaced
