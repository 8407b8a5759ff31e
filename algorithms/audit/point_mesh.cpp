#include "wellspaced/algorithms/audit/point_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/box_tree.hpp"
#include "wellspaced/algorithms/audit/places.hpp"
#include "wellspaced/algorithms/audit/rounding_box.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced::audit {
namespace {

// For each place the lowest number of a point there, or kNoIndex.
std::vector<Index> numbers_of(std::span<const Point2> places, std::span<const Point2> points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order, [&](Index i, Index j) { return before(points[i], points[j]); });
  std::vector<Index> numbers;
  for (const Point2 p : places) {
    const auto at = std::partition_point(order.begin(), order.end(),
                                         [&](Index i) { return before(points[i], p); });
    numbers.push_back(at != order.end() && points[*at] == p ? *at : kNoIndex);
  }
  return numbers;
}

// The points on the open segment from a to b, but for the rounding that the audit of domains
// allows, in their order along it.
std::vector<Index> points_along(Point2 a, Point2 b, std::span<const Point2> points,
                                const BoxTree<2>& tree) {
  constexpr double kUnits = 2;
  const auto along = [&](Point2 p) {
    return (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
  };
  Box<2> around = box_of(a, b);
  const double x = rounding_between(a.x, b.x, kUnits), y = rounding_between(a.y, b.y, kUnits);
  around.grow({{around.low[0] - x, around.low[1] - y}, {around.high[0] + x, around.high[1] + y}});
  std::vector<std::pair<double, Index>> found;
  tree.search([&](const auto& box) { return touch(box, around); },
              [&](Index v) {
                const double t = along(points[v]);
                if (t > 0 && t < along(b) && points[v] != b && touch(box_of(points[v]), around) &&
                    passes_near(a, b, points[v], kUnits))
                  found.push_back({t, v});
                return true;
              });
  sort(found);
  std::vector<Index> result;
  for (const auto& [t, v] : found) result.push_back(v);
  return result;
}

Result<Pslg> joined(std::span<const Point2> points, const Pslg& domain) {
  const std::vector<Index> numbers = numbers_of(domain.points, points);
  Error missing{ErrorCode::kInvalidGeometry, "points of the domain are not among the points", {}};
  for (Index i = 0; i < numbers.size(); ++i)
    if (numbers[i] == kNoIndex) missing.ids.push_back(i);
  if (!missing.ids.empty()) return missing;
  Pslg graph;
  graph.points.assign(points.begin(), points.end());
  graph.holes = domain.holes;
  std::vector<Box<2>> boxes;
  for (const Point2 p : points) boxes.push_back(box_of(p));
  const BoxTree<2> tree(boxes);
  for (const Segment& s : domain.segments) {
    Index last = numbers[s.a];
    for (const Index v : points_along(domain.points[s.a], domain.points[s.b], points, tree)) {
      graph.segments.push_back({last, v, s.marker});
      last = v;
    }
    graph.segments.push_back({last, numbers[s.b], s.marker});
  }
  return graph;
}

}  // namespace

Result<TriangleMesh> mesh_of_points(std::span<const Point2> points, const Pslg* domain,
                                    const Progress& progress) {
  Pslg graph;
  graph.points.assign(points.begin(), points.end());
  TriangulateOptions options;
  options.holes = HoleRule::kNone;
  options.progress = progress;
  if (domain != nullptr) {
    auto with_segments = joined(points, *domain);
    if (!with_segments) return with_segments.error();
    graph = std::move(*with_segments);
    options.holes = domain->holes.empty() ? HoleRule::kParity : HoleRule::kSeeds;
    options.crossings = CrossingRule::kRefuse;
  }
  const auto triangulation = triangulate(graph, options);
  if (!triangulation) return triangulation.error();
  TriangleMesh mesh;
  mesh.points = std::move(graph.points);
  mesh.triangles = triangulation->triangles();
  mesh.segments = triangulation->segments;
  return mesh;
}

Result<TetMesh> mesh_of_points(std::span<const Point3> points, const Progress& progress) {
  const auto delaunay = Delaunay3::build(points, {.progress = progress});
  if (!delaunay) return delaunay.error();
  TetMesh mesh;
  mesh.points.assign(points.begin(), points.end());
  const Triangulation3& topology = delaunay->topology();
  for (Index t = 0; t < topology.size(); ++t)
    if (!topology.is_ghost(t)) mesh.tets.push_back(topology.vertices(t));
  return mesh;
}

}  // namespace wellspaced::audit
