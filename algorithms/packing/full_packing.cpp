// Full maximality: no ball fits anywhere.
#include <algorithm>
#include <array>
#include <cmath>

#include "wellspaced/algorithms/packing/triangle_packing.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// A square cell of the quadtree.
struct QuadCell {
  Point2 centre;
  double half_side = 0;
  double half_diagonal() const { return std::sqrt(2.0) * half_side; }
};

// The quadtree over one triangle: looks for a place in it where a ball fits.
class RoomSearch {
 public:
  RoomSearch(TrianglePacking& packing, Index triangle, Random& random)
      : packing_(packing), triangle_(triangle), random_(random) {}

  // Returns the new vertex; kNoIndex if there is no room, to within the smallest cell.
  Index run();

 private:
  static constexpr double kSmallestCell = 0x1p-12;  // in radii

  bool misses(const QuadCell& cell) const;
  Index try_cell(const QuadCell& cell);
  bool is_full(const QuadCell& cell, double least_radius) const;
  bool covers(Index v, const QuadCell& cell, double least_radius) const;
  bool protects(Delaunay2::Edge e, const QuadCell& cell) const;
  void split(const QuadCell& cell);

  TrianglePacking& packing_;
  Index triangle_;
  Random& random_;
  std::vector<QuadCell> cells_;
};

// Whether the cell lies beyond an edge of the triangle.
bool RoomSearch::misses(const QuadCell& cell) const {
  const auto& corners = packing_.delaunay().topology().vertices(triangle_);
  for (unsigned i = 0; i < 3; ++i) {
    const Point2 a = packing_.point(corners[i]), b = packing_.point(corners[(i + 1) % 3]);
    const double turn = (b.x - a.x) * (cell.centre.y - a.y) - (b.y - a.y) * (cell.centre.x - a.x);
    if (turn < -cell.half_diagonal() * distance(a, b)) return true;
  }
  return false;
}

// Whether every point of the cell, where the radius is at least `least_radius`, is too near to v.
bool RoomSearch::covers(Index v, const QuadCell& cell, double least_radius) const {
  return distance(packing_.point(v), cell.centre) + cell.half_diagonal() <
         packing_.radius(v) + least_radius;
}

// Whether the cell lies inside the protective circle of the edge, if that has one.
bool RoomSearch::protects(Delaunay2::Edge e, const QuadCell& cell) const {
  const Triangulation2& topology = packing_.delaunay().topology();
  if (!topology.is_constrained(e)) return false;
  const Point2 a = packing_.point(topology.origin(e)), b = packing_.point(topology.destination(e));
  const Point2 middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
  return distance(middle, cell.centre) + cell.half_diagonal() < distance(a, b) / 2;
}

// Looks at the corners and edges of the triangle and of those beside it.
bool RoomSearch::is_full(const QuadCell& cell, double least_radius) const {
  const double must_be_far = 2 * least_radius - cell.half_diagonal();
  if (must_be_far > 0 && !packing_.stays_far(cell.centre, must_be_far)) return true;
  const Triangulation2& topology = packing_.delaunay().topology();
  for (unsigned i = 0; i < 3; ++i) {
    const Delaunay2::Edge e{triangle_, i}, m = topology.mirror(e);
    if (covers(topology.vertex(triangle_, i), cell, least_radius)) return true;
    if (protects(e, cell)) return true;
    if (topology.is_ghost(m.triangle) || topology.is_constrained(e)) continue;
    if (covers(topology.apex(m), cell, least_radius)) return true;
    for (const unsigned side : {Triangulation2::next(m.i), Triangulation2::previous(m.i)})
      if (protects({m.triangle, side}, cell)) return true;
  }
  return false;
}

void RoomSearch::split(const QuadCell& cell) {
  const double half = cell.half_side / 2;
  for (const double dx : {-half, half})
    for (const double dy : {-half, half})
      cells_.push_back({{cell.centre.x + dx, cell.centre.y + dy}, half});
}

// Adds a ball around the centre, or, for points in general position, somewhere near it.
Index RoomSearch::try_cell(const QuadCell& cell) {
  Point2 p = cell.centre;
  if (packing_.placement() == BallPlacement::kGeneric) {
    p.x += random_.uniform(-cell.half_side, cell.half_side) / 2;
    p.y += random_.uniform(-cell.half_side, cell.half_side) / 2;
  }
  if (packing_.walk(triangle_, p).triangle != triangle_) return kNoIndex;
  const double radius = packing_.radius_at(p);
  if (!packing_.stays_far(p, 2 * radius)) return kNoIndex;
  return packing_.add_ball(p, triangle_, radius);
}

Index RoomSearch::run() {
  const auto& [a, b, c] = packing_.delaunay().topology().vertices(triangle_);
  const Box2 box =
      Box2::around(std::array{packing_.point(a), packing_.point(b), packing_.point(c)});
  cells_.push_back({{box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2},
                    std::max(box.high.x - box.low.x, box.high.y - box.low.y) / 2});
  const double slope = std::min(packing_.slope(), 1.0);
  while (!cells_.empty()) {
    const QuadCell cell = cells_.back();
    cells_.pop_back();
    if (misses(cell)) continue;
    const double radius = packing_.radius_at(cell.centre);
    if (is_full(cell, radius - slope * cell.half_diagonal())) continue;
    if (const Index v = try_cell(cell); v != kNoIndex) return v;
    if (cell.half_side > kSmallestCell * radius) split(cell);
  }
  return kNoIndex;
}

}  // namespace

std::size_t fill_completely(TrianglePacking& packing, const std::function<bool()>& stop) {
  const Triangulation2& topology = packing.delaunay().topology();
  std::vector<std::pair<Index, TrianglePacking::Corners>> waiting;
  for (Index t = 0; t < topology.size(); ++t)
    if (packing.is_inside(t)) waiting.emplace_back(t, topology.vertices(t));
  Random random(2);
  std::size_t added = 0;
  while (!waiting.empty() && !stop()) {
    const auto [t, corners] = waiting.back();
    waiting.pop_back();
    if (topology.vertices(t) != corners) continue;
    const Index v = RoomSearch(packing, t, random).run();
    if (v == kNoIndex) continue;
    ++added;
    const Delaunay2::Edge first = packing.delaunay().edge_from(v);
    Delaunay2::Edge e = first;
    do {
      waiting.emplace_back(e.triangle, topology.vertices(e.triangle));
      e = topology.next_around_origin(e);
    } while (e != first);
  }
  return added;
}

}  // namespace wellspaced
