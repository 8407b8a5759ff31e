#include "wellspaced/algorithms/audit/domain.hpp"

#include <algorithm>
#include <array>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/exact_tests.hpp"
#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/algorithms/audit/rounding_box.hpp"
#include "wellspaced/algorithms/audit/stars.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

// The nodes sorted by place, to find those at a given one.
class NodesByPlace {
 public:
  explicit NodesByPlace(std::span<const Point2> points) : points_(points), nodes_(points.size()) {
    for (Index v = 0; v < nodes_.size(); ++v) nodes_[v] = v;
    sort(nodes_, [&](Index v, Index w) { return before(points[v], points[w]); });
  }

  std::span<const Index> at(Point2 p) const {
    const auto first = std::partition_point(nodes_.begin(), nodes_.end(),
                                            [&](Index v) { return before(points_[v], p); });
    auto last = first;
    while (last != nodes_.end() && points_[*last] == p) ++last;
    return {first, last};
  }

 private:
  std::span<const Point2> points_;
  std::vector<Index> nodes_;
};

// Follows the segments of the domain through the mesh. meter: of points and steps.
class ChainWalk {
 public:
  ChainWalk(const TriangleMesh& mesh, const HalfEdges& half_edges, double units,
            ProgressMeter& meter)
      : mesh_(mesh),
        half_edges_(half_edges),
        by_place_(mesh.points),
        stars_(mesh.triangles, mesh.points.size()),
        on_domain_(half_edges.twin.size(), 0),
        off_line_(mesh.points.size(), 0),
        units_(units),
        meter_(meter) {}

  bool stopped() const { return meter_.stopped(); }

  bool has_node_at(Point2 p) {
    meter_.step();
    return !by_place_.at(p).empty();
  }

  // Whether mesh edges lead from a to b along the segment; marks them.
  bool follow(Point2 a, Point2 b) {
    Point2 at = a;
    for (std::size_t steps = 0; at != b && meter_.step(); ++steps) {
      const Index next = next_node(a, b, at);
      if (next == kNoIndex || steps > mesh_.points.size()) return false;
      const Point2 to = mesh_.points[next];
      mark_edges(at, to);
      if (to != b && orient2d(a, b, to) != 0) off_line_[next] = 1;
      at = to;
    }
    return true;
  }

  bool is_on_domain(Index h) const { return on_domain_[h] != 0; }
  bool is_off_line(Index v) const { return off_line_[v] != 0; }

 private:
  // Calls visit(neighbour, half-edge between, in either direction) for the nodes at `place`.
  template <class Visit>
  void for_each_neighbor(Point2 place, Visit visit) const {
    for (const Index v : by_place_.at(place)) stars_.for_each_neighbor(v, visit);
  }

  // The nearest neighbour of the nodes at `at` that lies on the segment a, b further on.
  Index next_node(Point2 a, Point2 b, Point2 at) const {
    Index nearest = kNoIndex;
    for_each_neighbor(at, [&](Index w, Index) {
      const Point2 p = mesh_.points[w];
      if (nearest != kNoIndex && distance(at, p) >= distance(at, mesh_.points[nearest])) return;
      if (p == b ||
          (passes_near(a, b, p, units_) && angle_sign(at, p, b) > 0 && angle_sign(b, p, at) > 0))
        nearest = w;
    });
    return nearest;
  }

  // All edges between two places: on a slit there are two.
  void mark_edges(Point2 from, Point2 to) {
    for_each_neighbor(from, [&](Index w, Index h) {
      if (mesh_.points[w] != to) return;
      on_domain_[h] = 1;
      if (half_edges_.twin[h] != kNoIndex) on_domain_[half_edges_.twin[h]] = 1;
    });
  }

  const TriangleMesh& mesh_;
  const HalfEdges& half_edges_;
  NodesByPlace by_place_;
  Stars stars_;
  std::vector<std::uint8_t> on_domain_, off_line_;
  double units_;
  ProgressMeter& meter_;
};

void audit_points(const Pslg& domain, ChainWalk& walk, Report& report) {
  Check& check = report.add_required_check("domain_points_are_nodes", Item::kDomainPoint);
  for (Index i = 0; i < domain.points.size() && !walk.stopped(); ++i)
    if (!walk.has_node_at(domain.points[i])) check.violate({i});
}

void audit_segments(const TriangleMesh& mesh, const Pslg& domain, ChainWalk& walk, Report& report) {
  Check& check = report.add_required_check("domain_segments_are_edges", Item::kDomainSegment);
  for (Index s = 0; s < domain.segments.size() && !walk.stopped(); ++s) {
    const Point2 a = domain.points[domain.segments[s].a], b = domain.points[domain.segments[s].b];
    if (!walk.follow(a, b)) check.violate({s});
  }
  Check& exact = report.add_check("domain_segments_exact", Item::kNode);
  for (Index v = 0; v < mesh.points.size(); ++v)
    if (walk.is_off_line(v)) exact.violate({v});
}

void audit_boundary(const TriangleMesh& mesh, const HalfEdges& half_edges, const ChainWalk& walk,
                    Report& report) {
  Check& check = report.add_required_check("boundary_on_domain", Item::kEdge);
  for (Index h = 0; h < half_edges.twin.size(); ++h)
    if (half_edges.twin[h] == kNoIndex && !walk.is_on_domain(h))
      check.violate({origin(mesh.triangles, h), target(mesh.triangles, h)});
}

// Whether a triangle, of either orientation, contains p or has it on an edge.
bool contains(const TriangleMesh& mesh, const std::array<Index, 3>& t, Point2 p) {
  const Point2 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
  const int sides[] = {orient2d(a, b, p), orient2d(b, c, p), orient2d(c, a, p)};
  return *std::min_element(sides, sides + 3) >= 0 || *std::max_element(sides, sides + 3) <= 0;
}

}  // namespace

void audit_holes(const TriangleMesh& mesh, std::span<const Point2> holes, const Progress& progress,
                 Report& report) {
  std::vector<Box<2>> boxes;
  for (const Point2 p : holes) boxes.push_back(box_of(p));
  const BoxTree<2> tree(boxes);
  Check& check = report.add_required_check("holes_are_open", Item::kTriangle);
  ProgressMeter meter(progress, "audit", mesh.triangles.size());
  for (Index t = 0; t < mesh.triangles.size() && meter.step(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Box<2> box = box_of(mesh.points[a], mesh.points[b], mesh.points[c]);
    bool filled = false;
    tree.search([&](const Box<2>& other) { return touch(box, other); },
                [&](Index i) {
                  filled = touch(box, boxes[i]) && contains(mesh, mesh.triangles[t], holes[i]);
                  return !filled;
                });
    if (filled) check.violate({t});
  }
}

bool has_convex_boundary(const TriangleMesh& mesh, const HalfEdges& half_edges) {
  const auto rim = std::find(half_edges.twin.begin(), half_edges.twin.end(), kNoIndex);
  const auto rims = std::count(half_edges.twin.begin(), half_edges.twin.end(), kNoIndex);
  if (rims == 0) return false;
  const Index start = static_cast<Index>(rim - half_edges.twin.begin());
  Index h = start;
  std::ptrdiff_t length = 0;
  do {
    const Index next = half_edges.next_on_boundary(h);
    const Point2 a = mesh.points[origin(mesh.triangles, h)];
    const Point2 b = mesh.points[target(mesh.triangles, h)];
    const Point2 c = mesh.points[target(mesh.triangles, next)];
    const int turn = orient2d(a, b, c);
    if (turn < 0 || (turn == 0 && angle_sign(b, a, c) > 0)) return false;
    h = next;
    ++length;
  } while (h != start);
  return length == rims;
}

void audit_domain(const TriangleMesh& mesh, const HalfEdges& half_edges, const DomainToMeet& given,
                  Report& report) {
  const Pslg& domain = given.domain;
  ProgressParts parts(given.progress, "audit", 2);
  const Progress progress = parts.part(0);
  ProgressMeter meter(progress, "audit", domain.points.size() + domain.segments.size());
  ChainWalk walk(mesh, half_edges, given.allowance, meter);
  audit_points(domain, walk, report);
  audit_segments(mesh, domain, walk, report);
  const bool is_hull = domain.holes.empty() && has_convex_boundary(mesh, half_edges);
  if (!domain.segments.empty() && !is_hull) audit_boundary(mesh, half_edges, walk, report);
  if (!domain.holes.empty()) audit_holes(mesh, domain.holes, parts.part(1), report);
}

}  // namespace wellspaced::audit
