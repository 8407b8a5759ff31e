#include "wellspaced/algorithms/coarsening/special_points.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "wellspaced/algorithms/coarsening/boundary_curves.hpp"
#include "wellspaced/algorithms/coarsening/far_points.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"

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
    std::sort(arcs_.begin(), arcs_.end(), [](const Segment& a, const Segment& b) {
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

bool turns_sharply(Point2 before, Point2 at, Point2 after) {
  const double in = distance(before, at), out = distance(at, after);
  const double cosine = (at.x - before.x) / in * ((after.x - at.x) / out) +
                        (at.y - before.y) / in * ((after.y - at.y) / out);
  return cosine < kCosine30Degrees;
}

bool is_corner(std::span<const Point2> points, std::span<const Segment> walls) {
  if (walls.size() != 2 || walls[0].marker != walls[1].marker) return true;
  return turns_sharply(points[walls[0].b], points[walls[0].a], points[walls[1].b]);
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

}  // namespace

std::vector<Index> automatic_special_points(const TriangleMesh& mesh, const Skeleton& skeleton) {
  const Boundary& boundary = skeleton.boundary;
  const Walls walls(boundary_segments(boundary));
  std::vector<std::uint8_t> pinned(mesh.points.size(), 0);
  for (const Index v : boundary.nodes) pinned[v] = is_corner(mesh.points, walls.from(v));

  auto loops = face_loops(skeleton.corners, walls);
  append_loose_loops(skeleton.corners, boundary.curves, loops);
  for (const auto& loop : loops) pin_far_points(mesh.points, loop, pinned);

  std::vector<Index> special;
  for (const Index v : boundary.nodes)
    if (pinned[v]) special.push_back(v);
  return special;
}

std::vector<double> special_point_distances(const TriangleMesh& mesh) {
  std::vector<Point2> special;
  for (const Index v : mesh.fixed) special.push_back(mesh.points[v]);
  return nearest_neighbor_spacing(special);
}

}  // namespace wellspaced
