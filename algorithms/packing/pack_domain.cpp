#include "wellspaced/algorithms/packing/pack_domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

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

constexpr double kCosineOf30Degrees = 0.86602540378443864676;

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

Error no_room_beside(const Segment& s) {
  return {ErrorCode::kInvalidGeometry,
          {"the local feature size vanishes between points ", s.a, " and ", s.b,
           ": features of the domain are closer there than doubles can tell apart"},
          {s.a, s.b}};
}

// ---- Boundary ------------------------------------------------------------------------------

// The boundary while it is packed: vertices, then shells, then segments.
class BoundaryPacking {
 public:
  BoundaryPacking(const PlanarTriangulation& graph, const PackingOptions& options)
      : options_(options) {
    boundary_.points = graph.delaunay.points();
    boundary_.segments = graph.segments;
    parts_.resize(graph.segments.size());
    shell_.resize(graph.segments.size(), {kNoIndex, kNoIndex});
  }

  void cut_corners(const std::vector<Corner>& corners, const LocalFeatureSize& lfs);
  // What is left of the domain, whose local feature size the balls follow.
  Pslg lopped() const;
  Status pack(const BallRadius& radius, ProgressMeter& meter);
  const PackedBoundary& boundary() const { return boundary_; }
  // Whether no segment needed more points than the limit allows.
  bool is_complete() const { return is_complete_; }

 private:
  Index put_shell(Index apex, Index neighbour, double reach);
  Index segment_between(Index a, Index b) const;
  SegmentPart part_of(Index s) const {
    const Segment& segment = boundary_.segments[s];
    return {boundary_.points[segment.a], boundary_.points[segment.b], parts_[s][0], parts_[s][1]};
  }

  const PackingOptions& options_;
  PackedBoundary boundary_;
  // For each segment what is left between its shells, as fractions, and the points there.
  struct Fractions {
    double from = 0, to = 1;
    double operator[](int end) const { return end == 0 ? from : to; }
  };
  std::vector<Fractions> parts_;
  std::vector<std::array<Index, 2>> shell_;
  bool is_complete_ = true;
};

Index BoundaryPacking::segment_between(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  const auto found = std::partition_point(
      boundary_.segments.begin(), boundary_.segments.end(),
      [&, l = low, h = high](const Segment& s) { return s.a < l || (s.a == l && s.b < h); });
  return static_cast<Index>(found - boundary_.segments.begin());
}

// The point at which the shell of radius `reach` around the apex meets the segment to `neighbour`.
Index BoundaryPacking::put_shell(Index apex, Index neighbour, double reach) {
  const Index s = segment_between(apex, neighbour);
  const Segment& segment = boundary_.segments[s];
  const int end = segment.a == apex ? 0 : 1;
  if (shell_[s][end] != kNoIndex) return shell_[s][end];
  const double fraction =
      reach / distance(boundary_.points[segment.a], boundary_.points[segment.b]);
  (end == 0 ? parts_[s].from : parts_[s].to) = end == 0 ? fraction : 1 - fraction;
  shell_[s][end] = static_cast<Index>(boundary_.points.size());
  boundary_.points.push_back(part_of(s).at(parts_[s][end]));
  boundary_.pieces.push_back({apex, shell_[s][end], s, true});
  return shell_[s][end];
}

// The radius of a shell is half the distance to the nearest feature that does not touch the apex,
// or less where the size is small.
void BoundaryPacking::cut_corners(const std::vector<Corner>& corners, const LocalFeatureSize& lfs) {
  for (const Corner& corner : corners) {
    if (boundary_.sharp.empty() || boundary_.sharp.back() != corner.apex)
      boundary_.sharp.push_back(corner.apex);
    if (corner.cosine <= kCosineOf30Degrees) continue;
    const Point2 apex = boundary_.points[corner.apex];
    double reach = lfs.at(apex) / 2;
    if (options_.size) reach = std::min(reach, options_.size(apex));
    const Index right = put_shell(corner.apex, corner.right, reach);
    const Index left = put_shell(corner.apex, corner.left, reach);
    boundary_.pieces.push_back({right, left, kNoIndex, true});
  }
}

Pslg BoundaryPacking::lopped() const {
  Pslg graph;
  graph.points = boundary_.points;
  for (const BoundaryPiece& piece : boundary_.pieces) graph.segments.push_back({piece.a, piece.b});
  for (Index s = 0; s < parts_.size(); ++s) {
    const Segment& segment = boundary_.segments[s];
    graph.segments.push_back({shell_[s][0] != kNoIndex ? shell_[s][0] : segment.a,
                              shell_[s][1] != kNoIndex ? shell_[s][1] : segment.b});
  }
  return graph;
}

// A radius that is none ends the packing of a segment.
Status BoundaryPacking::pack(const BallRadius& radius, ProgressMeter& meter) {
  const BallRadius asking = [&](Point2 p) { return meter.step() ? radius(p) : 0; };
  for (Index s = 0; s < parts_.size(); ++s) {
    const std::size_t room =
        options_.max_points - std::min(options_.max_points, boundary_.points.size());
    auto points = pack_segment(part_of(s), asking, room);
    if (meter.stopped()) return cancelled();
    if (!points && points.error().code != ErrorCode::kLimit)
      return options_.size ? points.error() : no_room_beside(boundary_.segments[s]);
    if (!points || points->size() > room) points = std::vector<Point2>(), is_complete_ = false;
    const Segment& segment = boundary_.segments[s];
    Index last = shell_[s][0] != kNoIndex ? shell_[s][0] : segment.a;
    for (const Point2 p : *points) {
      const Index next = static_cast<Index>(boundary_.points.size());
      boundary_.points.push_back(p);
      boundary_.pieces.push_back({last, next, s});
      last = next;
    }
    boundary_.pieces.push_back({last, shell_[s][1] != kNoIndex ? shell_[s][1] : segment.b, s});
  }
  return Ok{};
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

// Packs a domain of usual scale.
Result<PackedMesh> pack_scaled_domain(const Pslg& input, const PackingOptions& options) {
  constexpr std::uint64_t kPreparationStepsAQuestion = 1024;
  ProgressMeter meter(options.progress, "prepare", 0, kPreparationStepsAQuestion);
  const Progress go_on = [&](auto, auto, auto) { return meter.step(kPreparationStepsAQuestion); };
  Result<PlanarTriangulation> graph = closed_domain(input, options, go_on);
  if (!graph) return graph.error();
  Pslg domain = input;
  if (options.holes == HoleRule::kNone) {
    enclose_hull(domain, *graph);
    graph = closed_domain(domain, options, go_on);
    if (!graph) return graph.error();
  }
  const std::vector<Corner> corners = sharp_corners(*graph);
  if (!corners.empty() && options.sharp_corners == SharpCorners::kRefuse)
    return too_sharp(corners, *graph);

  const auto whole = LocalFeatureSize::build(domain, {options.holes, CrossingRule::kSplit, go_on});
  if (!whole) return whole.error();
  BoundaryPacking work(*graph, options);
  work.cut_corners(corners, *whole);
  const auto lfs =
      LocalFeatureSize::build(work.lopped(), {HoleRule::kNone, CrossingRule::kSplit, go_on});
  if (!lfs) return lfs.error();
  const BallRadius radius = [&, cursor = LocalFeatureSize::Cursor(*lfs)](Point2 p) mutable {
    if (!options.size) return cursor.at(p) / options.beta;
    const double most = options.size(p) / 2;
    return std::min(most, cursor.at(p, options.beta * most) / options.beta);
  };
  if (Status packed = work.pack(radius, meter); !packed) return packed.error();

  InteriorOptions interior;
  interior.radius = radius;
  interior.slope = options.size ? interior.slope : 1 / options.beta;
  interior.zone_at = zones_of(*graph, domain);
  interior.smallest_angle_deg = options.smallest_angle_deg;
  interior.maximality = options.maximality;
  interior.placement = options.placement;
  interior.max_points = work.is_complete() ? options.max_points : 0;
  interior.progress = options.progress;
  auto packed_interior = pack_interior(work.boundary(), interior);
  if (!packed_interior) return packed_interior.error();

  PackedMesh packed = finish(std::move(*packed_interior), domain, graph->delaunay.points().size());
  packed.sharp_corners = corners;
  packed.without_guarantee = badly_shaped(packed.mesh, options.smallest_angle_deg);
  describe_repetitions(input, *graph, packed.notes);
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
