#include "wellspaced/algorithms/packing/pack_domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "wellspaced/algorithms/packing/boundary_packing.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

std::string counted(std::size_t count, const std::string& thing) {
  return concat({count, " ", thing, count == 1 ? "" : "s"});
}

// ---- Is it a domain? -----------------------------------------------------------------------

Status check_options(const PackingOptions& options) {
  if (!(options.beta >= 2) || !std::isfinite(options.beta))
    return Error{ErrorCode::kUsage, "beta must be at least 2", {}};
  if (!(options.smallest_angle_deg >= 0 && options.smallest_angle_deg <= 34))
    return Error{ErrorCode::kUsage, "the smallest angle may be 0 to 34 degrees", {}};
  return Ok{};
}

// The points at which just one segment ends.
std::vector<Index> loose_ends(const PlanarTriangulation& graph) {
  std::vector<Index> degree(graph.delaunay.points().size()), loose;
  for (const Segment& s : graph.segments) ++degree[s.a], ++degree[s.b];
  for (Index v = 0; v < degree.size(); ++v)
    if (degree[v] == 1) loose.push_back(v);
  return loose;
}

Error nothing_enclosed(const PlanarTriangulation& graph) {
  Error error{ErrorCode::kInvalidGeometry, "the segments enclose no region", loose_ends(graph)};
  if (!error.ids.empty())
    append(error.message,
           {": ", counted(error.ids.size(), "loose end"), ", the first at point ", error.ids[0]});
  return error;
}

Error too_sharp(const std::vector<Corner>& corners, const PlanarTriangulation& graph) {
  const auto sharpest =
      std::max_element(corners.begin(), corners.end(),
                       [](const Corner& c, const Corner& d) { return c.cosine < d.cosine; });
  const auto& points = graph.delaunay.points();
  const double angle = arccotangent_deg(
      corner_cotangent(points[sharpest->apex], points[sharpest->right], points[sharpest->left]));
  std::string rounded = std::to_string(angle);
  rounded.resize(rounded.find('.') + 3);
  Error error{ErrorCode::kInvalidGeometry,
              {counted(corners.size(), "corner"), " below 60 degrees, the sharpest at point ",
               sharpest->apex, " with ", rounded, "; allow small angles to mesh it"},
              {}};
  for (const Corner& corner : corners) error.ids.push_back(corner.apex);
  return error;
}

// The domain closed under intersection, and proven to be one.
Result<PlanarTriangulation> closed_domain(const Pslg& domain, const PackingOptions& options,
                                          const Progress& progress) {
  auto graph = triangulate(domain, {options.holes, options.crossings, progress});
  if (!graph) return graph.error();
  if (graph->delaunay.dimension() < 2)
    return Error{ErrorCode::kInvalidGeometry,
                 "the domain has no area: all of its points lie on one line",
                 {}};
  if (none_of(graph->in_domain, [](auto in) { return in; })) return nothing_enclosed(*graph);
  return graph;
}

// The edges of the hull, for a domain that is all of it.
void enclose_hull(Pslg& domain, const PlanarTriangulation& graph) {
  const std::vector<Index> hull = graph.delaunay.hull();
  for (std::size_t i = 0; i < hull.size(); ++i)
    domain.segments.push_back({hull[i], hull[(i + 1) % hull.size()], 0});
}

void describe_repetitions(const Pslg& domain, const PlanarTriangulation& graph,
                          std::vector<std::string>& notes) {
  const std::size_t duplicates = graph.delaunay.duplicate_count();
  if (duplicates > 0)
    notes.push_back(concat({counted(duplicates, "point"), " coincide with others"}));
  std::vector<std::pair<Index, Index>> ends;
  for (const Segment& s : domain.segments)
    ends.push_back(
        std::minmax(graph.delaunay.representative(s.a), graph.delaunay.representative(s.b)));
  sort(ends);
  const auto first_repeated = std::unique(ends.begin(), ends.end());
  const auto repeated = static_cast<std::size_t>(ends.end() - first_repeated);
  if (repeated > 0) notes.push_back(concat({counted(repeated, "segment"), " repeat others"}));
}

// Counts the pieces of a split segment each.
std::size_t segments_outside(const PlanarTriangulation& graph) {
  const Triangulation2& topology = graph.delaunay.topology();
  std::size_t outside = 0;
  for (Index t = 0; t < topology.size(); ++t)
    for (unsigned i = 0; i < 3; ++i)
      outside += topology.is_constrained({t, i}) && t < topology.neighbor(t, i) &&
                 !graph.in_domain[t] && !graph.in_domain[topology.neighbor(t, i)];
  return outside;
}

std::string left_out(std::size_t count, const std::string& thing) {
  return concat(
      {counted(count, thing), " outside the domain ", count == 1 ? "is" : "are", " left out"});
}

// The points and segments of the domain that are no part of the mesh.
void describe_outside(const Pslg& domain, const PlanarTriangulation& graph, PackedMesh& packed) {
  std::vector<std::uint8_t> is_node(graph.delaunay.points().size());
  for (const Index p : packed.domain_point)
    if (p != kNoIndex) is_node[p] = 1;
  Index first = kNoIndex;
  std::size_t outside = 0;
  for (Index p = 0; p < domain.points.size(); ++p) {
    if (is_node[graph.delaunay.representative(p)]) continue;
    if (outside++ == 0) first = p;
  }
  if (outside > 0)
    packed.notes.push_back(
        concat({left_out(outside, "point"), ", the first: point ", first, " (counted from 0)"}));
  if (const std::size_t loose = segments_outside(graph); loose > 0)
    packed.notes.push_back(left_out(loose, "segment"));
}

// ---- Regions -------------------------------------------------------------------------------

// Which region's seed can be reached from each triangle without crossing a segment; the first.
std::vector<Index> regions_of_triangles(const PlanarTriangulation& graph, const Pslg& domain) {
  const Triangulation2& topology = graph.delaunay.topology();
  std::vector<Index> region(topology.size(), kNoIndex), front;
  for (Index r = 0; r < domain.regions.size(); ++r) {
    const Index first = graph.delaunay.locate(domain.regions[r].seed).edge.triangle;
    if (region[first] != kNoIndex) continue;
    region[first] = r;
    front.assign(1, first);
    while (!front.empty()) {
      const Index t = front.back();
      front.pop_back();
      for (unsigned i = 0; i < 3; ++i) {
        const Index u = topology.neighbor(t, i);
        if (region[u] != kNoIndex || topology.is_constrained({t, i})) continue;
        region[u] = r;
        front.push_back(u);
      }
    }
  }
  return region;
}

std::function<Zone(Point2)> zones_of(const PlanarTriangulation& graph, const Pslg& domain) {
  return [&graph, &domain, region = regions_of_triangles(graph, domain)](Point2 p) {
    const Delaunay2::Location place = graph.delaunay.locate(p);
    const Index t = place.edge.triangle;
    Zone zone;
    zone.is_inside = place.place != Delaunay2::Place::kOutside && graph.in_domain[t] != 0;
    if (region[t] == kNoIndex) return zone;
    zone.attribute = domain.regions[region[t]].attribute;
    if (domain.regions[region[t]].max_area > 0) zone.max_area = domain.regions[region[t]].max_area;
    return zone;
  };
}

// ---- The result ----------------------------------------------------------------------------

std::vector<Index> badly_shaped(const TriangleMesh& mesh, double angle_deg) {
  const Point2 unit = circle_point(angle_deg / 360);
  const double limit = unit.x / unit.y;
  std::vector<Index> bad;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Point2 a = mesh.points[i], b = mesh.points[j], c = mesh.points[k];
    const double largest =
        std::max({corner_cotangent(a, b, c), corner_cotangent(b, c, a), corner_cotangent(c, a, b)});
    if (largest > limit) bad.push_back(t);
  }
  return bad;
}

void mark_points(const Pslg& domain, PackedMesh& packed) {
  if (domain.point_markers.empty()) return;
  std::vector<int>& markers = packed.mesh.point_markers;
  markers.assign(packed.mesh.points.size(), 0);
  for (const Segment& s : packed.mesh.segments) markers[s.a] = markers[s.b] = s.marker;
  for (Index v = 0; v < markers.size(); ++v)
    if (packed.domain_point[v] < domain.point_markers.size())
      markers[v] = domain.point_markers[packed.domain_point[v]];
}

PackedMesh finish(PackedInterior interior, const Pslg& domain, std::size_t domain_points) {
  PackedMesh packed;
  packed.mesh = std::move(interior.mesh);
  packed.radius = std::move(interior.radius);
  packed.domain_point = std::move(interior.boundary_point);
  for (Index& v : packed.domain_point)
    if (v >= domain_points) v = kNoIndex;
  if (!domain.regions.empty()) packed.attributes = std::move(interior.attributes);
  packed.balls_packed = interior.balls_packed;
  packed.is_complete = interior.is_complete;
  packed.was_cancelled = interior.was_cancelled;
  mark_points(domain, packed);
  return packed;
}

// The distance of each point's nearest neighbour, which its shortest Delaunay edge leads to.
std::vector<double> shortest_delaunay_edges(const std::vector<Point2>& points,
                                            const Progress& progress) {
  const auto delaunay = Delaunay2::build(points, {.progress = progress});
  if (!delaunay || delaunay->dimension() < 2) return nearest_neighbor_spacing(points, progress);
  const Triangulation2& topology = delaunay->topology();
  std::vector<double> shortest(points.size(), std::numeric_limits<double>::infinity());
  for (Index t = 0; t < topology.size(); ++t)
    for (unsigned i = 0; i < 3 && !topology.is_ghost(t); ++i) {
      const Index a = topology.origin({t, i}), b = topology.destination({t, i});
      const double length = distance(points[a], points[b]);
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
  return shortest;
}

// ---- Scale ---------------------------------------------------------------------------------

// The power of two that makes the extent about 1, where coordinates are so large or small that the
// cubes in circumcircle() might not be doubles; else 1.
double scale_for(const std::vector<Point2>& points) {
  if (points.empty()) return 1;
  const Box2 box = Box2::around(points);
  const double extent = distance(box.low, box.high);
  if (!(extent > 0) || !std::isfinite(extent)) return 1;
  const int exponent = std::ilogb(extent);
  return std::abs(exponent) <= 200 ? 1 : std::ldexp(1, std::clamp(-exponent, -1000, 1000));
}

void scale_points(std::vector<Point2>& points, double scale) {
  for (Point2& p : points) p = {scale * p.x, scale * p.y};
}

bool is_counterclockwise(const TriangleMesh& mesh) {
  return all_of(mesh.triangles, [&](const auto& t) {
    return orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) > 0;
  });
}

Pslg scaled_domain(Pslg domain, double scale) {
  scale_points(domain.points, scale);
  scale_points(domain.holes, scale);
  for (Pslg::Region& region : domain.regions) {
    region.seed = {scale * region.seed.x, scale * region.seed.y};
    region.max_area *= scale * scale;
  }
  return domain;
}

// ---- The steps -----------------------------------------------------------------------------

// lfs / beta, or half the size where that is less. Requires: both outlive it.
BallRadius ball_radius(const LocalFeatureSize& lfs, const PackingOptions& options) {
  return [&options, cursor = LocalFeatureSize::Cursor(lfs)](Point2 p) mutable {
    if (!options.size) return cursor.at(p) / options.beta;
    const double most = options.size(p) / 2;
    return std::min(most, cursor.at(p, options.beta * most) / options.beta);
  };
}

InteriorOptions interior_options(const PackingOptions& options) {
  InteriorOptions interior;
  if (!options.size) interior.slope = 1 / options.beta;
  interior.smallest_angle_deg = options.smallest_angle_deg;
  interior.maximality = options.maximality;
  interior.placement = options.placement;
  interior.max_points = options.max_points;
  interior.progress = options.progress;
  return interior;
}

// Packs a domain of usual scale.
Result<PackedMesh> pack_scaled_domain(const Pslg& input, const PackingOptions& options) {
  constexpr std::uint64_t kPreparationStepsAQuestion = 1024;
  ProgressMeter meter(options.progress, "prepare", 0, kPreparationStepsAQuestion);
  const Progress go_on = [&](auto, auto, auto) { return meter.step(kPreparationStepsAQuestion); };
  Result<PlanarTriangulation> graph = closed_domain(input, options, go_on);
  if (!graph) return graph.error();
  Pslg domain = input;
  std::size_t hull_edges_added = 0;
  if (options.holes == HoleRule::kNone) {
    const std::size_t before = graph->segments.size();
    enclose_hull(domain, *graph);
    graph = closed_domain(domain, options, go_on);
    if (!graph) return graph.error();
    hull_edges_added = graph->segments.size() - before;
  }
  const std::vector<Corner> corners = sharp_corners(*graph);
  if (!corners.empty() && options.sharp_corners == SharpCorners::kRefuse)
    return too_sharp(corners, *graph);

  const auto whole = LocalFeatureSize::build(domain, {options.holes, CrossingRule::kSplit, go_on});
  if (!whole) return whole.error();
  BoundaryPacking boundary(*graph, options);
  boundary.cut_corners(corners, *whole);
  const auto lfs =
      LocalFeatureSize::build(boundary.lopped(), {HoleRule::kNone, CrossingRule::kSplit, go_on});
  if (!lfs) return lfs.error();
  InteriorOptions interior = interior_options(options);
  interior.radius = ball_radius(*lfs, options);
  if (Status packed = boundary.pack(interior.radius, meter); !packed) return packed.error();
  interior.zone_at = zones_of(*graph, domain);
  if (!boundary.is_complete()) interior.max_points = 0;
  auto packed_interior = pack_interior(boundary.boundary(), interior);
  if (!packed_interior) return packed_interior.error();

  PackedMesh packed = finish(std::move(*packed_interior), domain, graph->delaunay.points().size());
  packed.sharp_corners = corners;
  packed.without_guarantee = badly_shaped(packed.mesh, options.smallest_angle_deg);
  describe_repetitions(input, *graph, packed.notes);
  describe_outside(input, *graph, packed);
  if (hull_edges_added > 0 && !input.segments.empty())
    packed.notes.push_back(concat({"the mesh fills the convex hull; ",
                                   counted(hull_edges_added, "edge"), " of it on no segment"}));
  return packed;
}

}  // namespace

Result<PackedMesh> pack_domain(const Pslg& domain, const PackingOptions& options) {
  if (Status valid = check_options(options); !valid) return valid.error();
  const double scale = scale_for(domain.points);
  if (scale == 1) return pack_scaled_domain(domain, options);
  PackingOptions scaled_options = options;
  if (options.size)
    scaled_options.size = [&](Point2 p) {
      return scale * options.size({p.x / scale, p.y / scale});
    };
  auto packed = pack_scaled_domain(scaled_domain(domain, scale), scaled_options);
  if (!packed) return packed.error();
  scale_points(packed->mesh.points, 1 / scale);
  for (double& radius : packed->radius) radius /= scale;
  if (!is_counterclockwise(packed->mesh))
    return Error{ErrorCode::kInvalidGeometry,
                 "the domain is too small: its triangles are flat once their corners are rounded "
                 "to subnormal doubles; scale it up",
                 {}};
  return packed;
}

std::vector<double> packed_spacing(const PackedMesh& packed, double beta,
                                   const Progress& progress) {
  const std::vector<Point2>& points = packed.mesh.points;
  ProgressParts parts(progress, "spacing", 2);
  std::vector<double> spacing = shortest_delaunay_edges(points, parts.part(0));
  if (parts.stopped()) return spacing;
  for (std::size_t v = 0; v < points.size(); ++v)
    spacing[v] = beta * std::min(packed.radius[v], spacing[v] / 2);
  return euclidean_coarsened_spacing(points, spacing, 1, parts.part(1));
}

}  // namespace wellspaced
