#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/check_points.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

using Corners3 = std::vector<Index>;

// ---- The input -----------------------------------------------------------------------------

// Whether the points that name holes and regions are finite.
Status check_seeds(const Pls& domain) {
  const auto is_good = [](const Point3& p) { return is_finite(p); };
  for (Index f = 0; f < domain.facets.size(); ++f)
    if (!all_of(domain.facets[f].holes, is_good))
      return Error{ErrorCode::kInvalidGeometry, {"a hole of facet ", f, " is not finite"}, {f}};
  const bool is_fine =
      all_of(domain.holes, is_good) &&
      all_of(domain.regions, [](const Pls::Region& region) { return is_finite(region.seed); });
  if (is_fine) return Ok{};
  return Error{ErrorCode::kInvalidGeometry, "the point of a hole or region is not finite", {}};
}

Status check_names(const Pls& domain) {
  const auto is_point = [n = domain.points.size()](Index v) { return v < n; };
  for (Index f = 0; f < domain.facets.size(); ++f)
    for (const Corners3& polygon : domain.facets[f].polygons)
      if (!all_of(polygon, is_point))
        return Error{
            ErrorCode::kInvalidGeometry, {"facet ", f, " names a point that there is not"}, {f}};
  for (Index s = 0; s < domain.segments.size(); ++s)
    if (!is_point(domain.segments[s].a) || !is_point(domain.segments[s].b))
      return Error{
          ErrorCode::kInvalidGeometry, {"segment ", s, " names a point that there is not"}, {s}};
  return Ok{};
}

// For each point the lowest with its coordinates.
std::vector<Index> lowest_twins(const std::vector<Point3>& points) {
  std::vector<Index> order(points.size()), twin(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  sort(order,
       [&](Index a, Index b) { return points[a] == points[b] ? a < b : points[a] < points[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && points[order[i]] == points[order[i - 1]];
    twin[order[i]] = is_same ? twin[order[i - 1]] : order[i];
  }
  return twin;
}

// The same domain with one name for each place; polygons lose corners that repeat the one before.
Pls welded(Pls domain, const std::vector<Index>& twin) {
  for (Pls::Facet& facet : domain.facets) {
    for (Corners3& polygon : facet.polygons) {
      for (Index& v : polygon) v = twin[v];
      polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
      while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    }
    std::erase_if(facet.polygons, [](const Corners3& polygon) { return polygon.empty(); });
  }
  for (Segment& s : domain.segments) s = {twin[s.a], twin[s.b], s.marker};
  std::erase_if(domain.segments, [](const Segment& s) { return s.a == s.b; });
  return domain;
}

// ---- One facet in its plane ----------------------------------------------------------------

Point3 normal_of(const std::vector<Point3>& points, const Corners3& polygon) {
  Point3 sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + cross(points[polygon[i - 1]] - points[polygon[0]],
                      points[polygon[i]] - points[polygon[0]]);
  return sum;
}

// The plane of the polygon with the largest area, with an axis along its longest edge.
PlaneFrame frame_of(const std::vector<Point3>& points, const Pls::Facet& facet) {
  Point3 normal{};
  const Corners3* largest = &facet.polygons[0];
  for (const Corners3& polygon : facet.polygons) {
    const Point3 candidate = normal_of(points, polygon);
    if (!(length(candidate) > length(normal))) continue;
    normal = candidate;
    largest = &polygon;
  }
  Point3 along{};
  for (std::size_t i = 0; i < largest->size(); ++i) {
    const Point3 edge = points[(*largest)[(i + 1) % largest->size()]] - points[(*largest)[i]];
    if (length(edge) > length(along)) along = edge;
  }
  const Point3 n = (1 / length(normal)) * normal;
  along = along - dot(along, n) * n;
  const Point3 u = (1 / length(along)) * along;
  return {points[largest->front()], u, cross(n, u)};
}

// A facet's graph: its points by the coordinates in its frame.
Pslg graph_of(const std::vector<Point3>& points, const Pls::Facet& facet,
              const PolyhedralComplex::Facet& flat) {
  Pslg graph;
  for (const Index v : flat.points) graph.points.push_back(flat.frame.coordinates(points[v]));
  const auto local = [&](Index v) {
    return static_cast<Index>(std::lower_bound(flat.points.begin(), flat.points.end(), v) -
                              flat.points.begin());
  };
  for (const Corners3& polygon : facet.polygons)
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 1; ++i)
      graph.segments.push_back({local(polygon[i]), local(polygon[(i + 1) % polygon.size()])});
  for (const Point3 hole : facet.holes) graph.holes.push_back(flat.frame.coordinates(hole));
  return graph;
}

double doubled_area(const Delaunay2& delaunay, Index t) {
  const auto& [a, b, c] = delaunay.topology().vertices(t);
  const Point2 p = delaunay.points()[a], q = delaunay.points()[b], r = delaunay.points()[c];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

double extent_of_points(const std::vector<Point2>& points) {
  const Box2 box = Box2::around(points);
  return distance(box.low, box.high);
}

// Facets that were merged are a union of polygons. Where that leaves holes, as at the end of a
// tube, its outline tells: what is an even number of its edges deep. `graph` receives points in
// them.
Status find_holes_of_union(const Pls::Facet& facet, const PolyhedralComplex::Facet& flat,
                           const std::vector<Point3>& points, double flatness, Pslg& graph) {
  Pls::Facet outline = facet;
  std::erase_if(outline.polygons, [](const Corners3& polygon) { return polygon.size() < 3; });
  const Pslg bounds = graph_of(points, outline, flat);
  const auto closed = triangulate(bounds, {HoleRule::kParity, CrossingRule::kRefuse, {}});
  if (!closed) return closed.error();
  const double extent = extent_of_points(bounds.points);
  for (Index t = 0; t < closed->delaunay.topology().size(); ++t) {
    if (closed->in_domain[t] || closed->delaunay.topology().is_ghost(t)) continue;
    if (!(doubled_area(closed->delaunay, t) > flatness * flatness * extent * extent)) continue;
    const auto& [a, b, c] = closed->delaunay.topology().vertices(t);
    const auto& p = closed->delaunay.points();
    graph.holes.push_back({(p[a].x + p[b].x + p[c].x) / 3, (p[a].y + p[b].y + p[c].y) / 3});
  }
  return Ok{};
}

// Whether the triangles that cover the facet cover the hull of its points, but for flat ones.
bool covers_hull(const PlanarTriangulation& graph, double flatness) {
  const Triangulation2& topology = graph.delaunay.topology();
  const double extent = extent_of_points(graph.delaunay.points());
  for (Index t = 0; t < topology.size(); ++t)
    if (!graph.in_domain[t] && !topology.is_ghost(t) &&
        doubled_area(graph.delaunay, t) > flatness * extent * extent)
      return false;
  return true;
}

Error facet_error(Index facet, const std::string& what) {
  return {ErrorCode::kInvalidGeometry, {"facet ", facet, " ", what}, {facet}};
}

// Whether a facet is one of the domain, or a union of several.
enum class Origin { kGiven, kMerged };

// The facet but for the numbers of its segments, which `edges` receives.
Result<PolyhedralComplex::Facet> flatten(const Pls& domain, Index number, Index source,
                                         Origin origin, double flatness,
                                         std::vector<Segment>& edges) {
  const Pls::Facet& facet = domain.facets[number];
  PolyhedralComplex::Facet flat;
  flat.source = source;
  flat.marker = facet.marker;
  flat.frame = frame_of(domain.points, facet);
  for (const Corners3& polygon : facet.polygons)
    flat.points.insert(flat.points.end(), polygon.begin(), polygon.end());
  sort_unique(flat.points);
  Pslg graph = graph_of(domain.points, facet, flat);
  if (origin == Origin::kMerged)
    if (Status s = find_holes_of_union(facet, flat, domain.points, flatness, graph); !s)
      return facet_error(source, concat({"is no polygon: ", s.error().message}));
  const auto closed = triangulate(graph, {HoleRule::kSeeds, CrossingRule::kRefuse, {}});
  if (!closed) return facet_error(source, concat({"is no polygon: ", closed.error().message}));
  if (closed->delaunay.duplicate_count() > 0)
    return facet_error(source, "has corners that coincide in its plane");
  for (auto triangle : closed->triangles()) {
    for (Index& v : triangle) v = flat.points[v];
    flat.triangles.push_back(triangle);
  }
  if (flat.triangles.empty()) return facet_error(source, "encloses nothing");
  flat.is_convex = covers_hull(*closed, flatness);
  for (const Segment& s : closed->segments) edges.push_back({flat.points[s.a], flat.points[s.b]});
  return flat;
}

// ---- All together --------------------------------------------------------------------------

bool joins_less(const Segment& s, const Segment& t) {
  return s.a < t.a || (s.a == t.a && s.b < t.b);
}

// Each segment once, lower end first, with the largest of its markers.
std::vector<Segment> distinct_segments(std::vector<Segment> segments) {
  for (Segment& s : segments)
    if (s.a > s.b) std::swap(s.a, s.b);
  sort(segments, [](const Segment& s, const Segment& t) {
    return joins_less(s, t) || (!joins_less(t, s) && s.marker > t.marker);
  });
  const auto is_same = [](const Segment& s, const Segment& t) { return s.a == t.a && s.b == t.b; };
  segments.erase(std::unique(segments.begin(), segments.end(), is_same), segments.end());
  return segments;
}

void number_segments(const std::vector<std::vector<Segment>>& edges, PolyhedralComplex& complex) {
  for (std::size_t f = 0; f < edges.size(); ++f) {
    for (const Segment& edge : edges[f]) {
      const Segment sought{std::min(edge.a, edge.b), std::max(edge.a, edge.b)};
      const auto found =
          std::lower_bound(complex.segments.begin(), complex.segments.end(), sought, joins_less);
      complex.facets[f].segments.push_back(static_cast<Index>(found - complex.segments.begin()));
    }
    sort_unique(complex.facets[f].segments);
  }
}

void mark_vertices(const std::vector<Index>& twin, const std::vector<Index>& freed,
                   PolyhedralComplex& complex) {
  complex.is_vertex.assign(twin.size(), 1);
  std::size_t coincident = 0;
  for (Index v = 0; v < twin.size(); ++v)
    if (twin[v] != v) complex.is_vertex[v] = 0, ++coincident;
  for (const Index v : freed) complex.is_vertex[v] = 0;
  if (coincident > 0) complex.notes.push_back(concat({coincident, " points coincide with others"}));
  if (!freed.empty())
    complex.notes.push_back(
        concat({freed.size(), " points inside flat parts of the surface are dropped"}));
}

}  // namespace

Result<PolyhedralComplex> build_complex(const Pls& input, double flatness,
                                        const Progress& progress) {
  if (Status finite = check_points(input.points); !finite) return finite.error();
  if (Status named = check_names(input); !named) return named.error();
  if (Status finite = check_seeds(input); !finite) return finite.error();
  const std::vector<Index> twin = lowest_twins(input.points);
  const auto merged = merge_coplanar_facets(welded(input, twin), flatness);
  if (!merged) return merged.error();

  PolyhedralComplex complex;
  complex.points = input.points;
  std::vector<Index> source(merged->domain.facets.size(), kNoIndex);
  std::vector<Origin> origin(source.size(), Origin::kGiven);
  for (Index f = 0; f < merged->merged_into.size(); ++f) {
    const Index into = merged->merged_into[f];
    if (source[into] != kNoIndex) origin[into] = Origin::kMerged;
    source[into] = std::min(source[into], f);
  }
  constexpr std::size_t kFacetsAQuestion = 64;
  std::vector<std::vector<Segment>> edges(source.size());
  std::vector<Segment> segments = merged->domain.segments;
  for (std::size_t f = 0; f < source.size(); ++f) {
    if (f % kFacetsAQuestion == 0 && !report(progress, "flatten", f, source.size()))
      return cancelled();
    auto facet =
        flatten(merged->domain, static_cast<Index>(f), source[f], origin[f], flatness, edges[f]);
    if (!facet) return facet.error();
    complex.facets.push_back(std::move(*facet));
    segments.insert(segments.end(), edges[f].begin(), edges[f].end());
  }
  complex.segments = distinct_segments(std::move(segments));
  number_segments(edges, complex);
  mark_vertices(twin, merged->freed_points, complex);
  return complex;
}

}  // namespace wellspaced
