#include "wellspaced/algorithms/coarsening/special_points.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/far_points.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

// The boundary edges and segments in both directions, sorted by their first node. Called walls: a
// walk around a face of the domain turns at them.
class Walls {
 public:
  explicit Walls(std::span<const Segment> segments) {
    for (const Segment& s : segments) {
      arcs_.push_back({s.a, s.b, s.marker});
      arcs_.push_back({s.b, s.a, s.marker});
    }
    sort(arcs_, [](const Segment& a, const Segment& b) {
      return std::pair{a.a, a.b} < std::pair{b.a, b.b};
    });
  }

  const std::vector<Segment>& arcs() const { return arcs_; }
  /// The arcs that leave v.
  std::span<const Segment> from(Index v) const {
    const auto less = [](const Segment& arc, Index node) { return arc.a < node; };
    const auto first = std::lower_bound(arcs_.begin(), arcs_.end(), v, less);
    const auto last = std::find_if(first, arcs_.end(), [=](const Segment& s) { return s.a != v; });
    return {first, last};
  }
  /// The number of the arc from a to b, or that of arcs when there is none.
  std::size_t find(Index a, Index b) const {
    for (const Segment& arc : from(a))
      if (arc.b == b) return static_cast<std::size_t>(&arc - arcs_.data());
    return arcs_.size();
  }

 private:
  std::vector<Segment> arcs_;
};

constexpr double kCosine30Degrees = 0.86602540378443864676;
constexpr double kCosine60Degrees = 0.5;

// The part of its diameter by which the outline of a loop may be off.
constexpr double kOutline = 0.15;

bool turns_sharply(Point2 before, Point2 at, Point2 after, double cosine_of_corner) {
  const double in = distance(before, at), out = distance(at, after);
  const double cosine = (at.x - before.x) / in * ((after.x - at.x) / out) +
                        (at.y - before.y) / in * ((after.y - at.y) / out);
  return cosine < cosine_of_corner;
}

bool is_corner(std::span<const Point2> points, std::span<const Segment> walls,
               double cosine_of_corner) {
  if (walls.size() != 2 || walls[0].marker != walls[1].marker) return true;
  return turns_sharply(points[walls[0].b], points[walls[0].a], points[walls[1].b],
                       cosine_of_corner);
}

// The wall that follows u -> v around the face on its left, as the next node.
Index next_around_face(const CornerTable& table, const Walls& walls, Index u, Index v) {
  const auto fan = table.at(v);
  Index turned = u;
  for (std::size_t step = 0; step < fan.size(); ++step) {
    const auto corner =
        std::ranges::find_if(fan, [=](const auto& c) { return c.previous == turned; });
    if (corner == fan.end()) return kNoIndex;
    turned = corner->next;
    if (walls.find(v, turned) != walls.arcs().size()) return turned;
  }
  return kNoIndex;
}

// The closed walks around the faces of the domain, holes and slits included; those that run along
// both sides of all their walls are left out.
std::vector<std::vector<Index>> face_loops(const CornerTable& table, const Walls& walls) {
  const auto& arcs = walls.arcs();
  std::vector<std::vector<Index>> loops;
  std::vector<std::size_t> loop_of(arcs.size(), arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (loop_of[i] != arcs.size() || !table.has_edge(arcs[i].a, arcs[i].b)) continue;
    std::vector<std::size_t> walk;
    for (std::size_t k = i; k != arcs.size() && loop_of[k] == arcs.size();) {
      loop_of[k] = i;
      walk.push_back(k);
      const Index w = next_around_face(table, walls, arcs[k].a, arcs[k].b);
      k = w == kNoIndex ? arcs.size() : walls.find(arcs[k].b, w);
    }
    const bool encloses = std::ranges::any_of(
        walk, [&](std::size_t k) { return loop_of[walls.find(arcs[k].b, arcs[k].a)] != i; });
    if (!encloses) continue;
    loops.emplace_back();
    for (const std::size_t k : walk) loops.back().push_back(arcs[k].a);
  }
  return loops;
}

// Closed curves of segments away from all triangles.
void append_loose_loops(const CornerTable& table, std::span<const BoundaryCurve> curves,
                        std::vector<std::vector<Index>>& loops) {
  for (const BoundaryCurve& curve : curves)
    if (curve.closed && curve.kind == BoundaryCurve::Kind::kInner &&
        !table.has_edge(curve.node(0), curve.node(1)))
      loops.push_back(curve.nodes);
}

// Whether a loop has what it encloses on its left: by its area, in units of its extent so that no
// product overflows.
bool is_counter_clockwise(std::span<const Point2> loop) {
  const Box2 box = Box2::around(loop);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  double area = 0;
  Point2 a = loop.back();
  for (const Point2 b : loop) {
    area += (a.x - box.low.x) / width * ((b.y - box.low.y) / height) -
            (b.x - box.low.x) / width * ((a.y - box.low.y) / height);
    a = b;
  }
  return area > 0;
}

void pin_far_points(std::span<const Point2> points, std::span<const Index> loop,
                    std::vector<std::uint8_t>& pinned) {
  std::vector<Point2> outline;
  std::vector<std::size_t> chosen;
  std::vector<Index> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    outline.push_back(points[loop[i]]);
    if (!pinned[loop[i]] || std::ranges::count(corners, loop[i]) != 0) continue;
    corners.push_back(loop[i]);
    chosen.push_back(i);
    if (chosen.size() == 3) return;
  }
  const std::size_t count = is_counter_clockwise(outline) ? 4 : 3;
  for (const std::size_t i : add_far_points(outline, std::move(chosen), count)) pinned[loop[i]] = 1;
}

// The place between two on a loop that is farthest from the line between them, if it is farther
// than `off`; b may have gone around.
std::optional<std::size_t> farthest_between(std::span<const Point2> loop, std::size_t a,
                                            std::size_t b, double off) {
  std::optional<std::size_t> place;
  for (std::size_t i = a + 1; i < b; ++i) {
    const double d =
        distance_to_segment(loop[i % loop.size()], loop[a % loop.size()], loop[b % loop.size()]);
    if (d > off) off = d, place = i;
  }
  return place;
}

// Pins points until the polygon of those pinned is nowhere far from the loop.
void pin_outline(std::span<const Point2> points, std::span<const Index> nodes,
                 std::vector<std::uint8_t>& pinned) {
  std::vector<Point2> loop;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    loop.push_back(points[nodes[i]]);
    if (pinned[nodes[i]]) chosen.push_back(i);
  }
  const std::vector<std::size_t> far = add_far_points(loop, {}, 2);
  if (far.size() < 2) return;
  const double off = kOutline * distance(loop[far[0]], loop[far[1]]);
  if (chosen.size() < 2) chosen = add_far_points(loop, std::move(chosen), 2);
  std::ranges::sort(chosen);
  for (const std::size_t i : chosen) pinned[nodes[i]] = 1;

  std::vector<std::pair<std::size_t, std::size_t>> arcs;  // the end may have gone around
  for (std::size_t k = 0; k + 1 < chosen.size(); ++k) arcs.emplace_back(chosen[k], chosen[k + 1]);
  arcs.emplace_back(chosen.back(), chosen.front() + loop.size());
  while (!arcs.empty()) {
    const auto [a, b] = arcs.back();
    arcs.pop_back();
    const auto place = farthest_between(loop, a, b, off);
    if (!place) continue;
    pinned[nodes[*place % loop.size()]] = 1;
    arcs.emplace_back(a, *place);
    arcs.emplace_back(*place, b);
  }
}

std::vector<std::vector<Index>> all_loops(const Skeleton& skeleton, const Walls& walls) {
  auto loops = face_loops(skeleton.corners, walls);
  append_loose_loops(skeleton.corners, skeleton.boundary.curves, loops);
  return loops;
}

std::vector<std::uint8_t> pinned_corners(const TriangleMesh& mesh, const Boundary& boundary,
                                         const Walls& walls, double cosine_of_corner) {
  std::vector<std::uint8_t> pinned(mesh.points.size(), 0);
  for (const Index v : boundary.nodes)
    pinned[v] = is_corner(mesh.points, walls.from(v), cosine_of_corner);
  return pinned;
}

std::vector<Index> all_pinned(std::span<const std::uint8_t> pinned) {
  std::vector<Index> special;
  for (Index v = 0; v < pinned.size(); ++v)
    if (pinned[v]) special.push_back(v);
  return special;
}

}  // namespace

std::vector<Index> automatic_special_points(const TriangleMesh& mesh, const Skeleton& skeleton) {
  const Walls walls(boundary_segments(skeleton.boundary));
  auto pinned = pinned_corners(mesh, skeleton.boundary, walls, kCosine30Degrees);
  for (const auto& loop : all_loops(skeleton, walls)) pin_far_points(mesh.points, loop, pinned);
  return all_pinned(pinned);
}

std::vector<Index> outline_special_points(const TriangleMesh& mesh, const Skeleton& skeleton) {
  const Walls walls(boundary_segments(skeleton.boundary));
  auto pinned = pinned_corners(mesh, skeleton.boundary, walls, kCosine60Degrees);
  for (const auto& loop : all_loops(skeleton, walls)) {
    pin_outline(mesh.points, loop, pinned);
    pin_far_points(mesh.points, loop, pinned);
  }
  return all_pinned(pinned);
}

std::vector<Index> completed_special_points(const TriangleMesh& mesh, const Skeleton& skeleton,
                                            std::span<const Index> given) {
  std::vector<std::uint8_t> pinned(mesh.points.size(), 0);
  for (const Index v : given) pinned[v] = 1;
  const Walls walls(boundary_segments(skeleton.boundary));
  for (const auto& loop : all_loops(skeleton, walls)) pin_far_points(mesh.points, loop, pinned);
  return all_pinned(pinned);
}

std::vector<double> special_point_distances(const TriangleMesh& mesh) {
  std::vector<Point2> special;
  for (const Index v : mesh.fixed) special.push_back(mesh.points[v]);
  return nearest_neighbor_spacing(special);
}

}  // namespace wellspaced
