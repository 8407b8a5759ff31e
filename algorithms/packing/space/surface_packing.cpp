#include "wellspaced/algorithms/packing/space/surface_packing.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "wellspaced/algorithms/packing/segment_packing.hpp"
#include "wellspaced/kernel/box_tree.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

Error not_positive_at(Point3 p) {
  return {ErrorCode::kUsage,
          {"the spacing is not positive at (", std::to_string(p.x), ", ", std::to_string(p.y), ", ",
           std::to_string(p.z), ")"},
          {}};
}

constexpr std::uint64_t kSurfaceStepsAQuestion = 1024;

class SurfacePacking {
 public:
  SurfacePacking(const PolyhedralComplex& complex, const SurfaceOptions& options)
      : complex_(complex),
        options_(options),
        meter_(options.progress, "surface", 0, kSurfaceStepsAQuestion) {}

  Status pack_points();
  Status pack_one_segment(Index s);
  void end_segments() {
    surface_.first_piece.push_back(static_cast<Index>(surface_.pieces.size()));
    surface_.segment_points = surface_.points.size() - complex_.points.size();
  }
  Status pack_facet(Index f);
  Status check_radii() const;
  PackedSurface result();

 private:
  std::size_t room() const {
    return options_.max_points - std::min(options_.max_points, surface_.points.size());
  }
  Index add(Point3 p) {
    surface_.points.push_back(p);
    surface_.radius.push_back(options_.radius(p));
    return static_cast<Index>(surface_.points.size() - 1);
  }
  PackedBoundary boundary_of(const PolyhedralComplex::Facet& facet, std::vector<Index>& on) const;
  std::function<bool(Point2, double)> staying_far(const PolyhedralComplex::Facet& facet) const;

  const PolyhedralComplex& complex_;
  const SurfaceOptions& options_;
  PackedSurface surface_;
  std::optional<Point3> bad_place_;
  ProgressMeter meter_;
};

Status SurfacePacking::pack_points() {
  surface_.points = complex_.points;
  for (Index v = 0; v < complex_.points.size(); ++v)
    surface_.radius.push_back(complex_.is_vertex[v] ? options_.radius(complex_.points[v]) : 0);
  return check_radii();
}

// The segment is laid along the x axis, where the plane's packing of segments takes over.
Status SurfacePacking::pack_one_segment(Index s) {
  surface_.first_piece.push_back(static_cast<Index>(surface_.pieces.size()));
  const Segment& segment = complex_.segments[s];
  const Point3 a = complex_.points[segment.a], way = complex_.points[segment.b] - a;
  const double whole = length(way);
  const auto place = [&](double along) { return a + (along / whole) * way; };
  const auto radius = [&](Point2 p) { return meter_.step() ? options_.radius(place(p.x)) : 0; };
  const auto points = pack_segment({{0, 0}, {whole, 0}}, radius, room());
  if (meter_.stopped()) return cancelled();
  if (!points) return points.error();
  if (points->size() > room())
    return Error{ErrorCode::kLimit, "the segments need more points than the limit", {}};
  Index last = segment.a;
  for (const Point2 p : *points) {
    const Index next = add(place(p.x));
    surface_.pieces.push_back({last, next});
    last = next;
  }
  surface_.pieces.push_back({last, segment.b});
  return Ok{};
}

// What is packed already of a facet, in its own coordinates; `on` receives its points.
PackedBoundary SurfacePacking::boundary_of(const PolyhedralComplex::Facet& facet,
                                           std::vector<Index>& on) const {
  on = facet.points;
  const auto for_each_piece = [&](auto visit) {
    for (Index i = 0; i < facet.segments.size(); ++i)
      for (Index k = surface_.first_piece[facet.segments[i]];
           k < surface_.first_piece[facet.segments[i] + 1]; ++k)
        visit(i, surface_.pieces[k]);
  };
  for_each_piece([&](Index, const std::array<Index, 2>& piece) {
    if (piece[1] >= complex_.points.size()) on.push_back(piece[1]);
  });
  sort(on);
  const auto local = [&](Index v) {
    return static_cast<Index>(std::lower_bound(on.begin(), on.end(), v) - on.begin());
  };
  PackedBoundary boundary;
  for (const Index v : on) boundary.points.push_back(facet.frame.coordinates(surface_.points[v]));
  for (const Index s : facet.segments)
    boundary.segments.push_back({local(complex_.segments[s].a), local(complex_.segments[s].b)});
  for_each_piece([&](Index segment, const std::array<Index, 2>& piece) {
    boundary.pieces.push_back({local(piece[0]), local(piece[1]), segment});
  });
  return boundary;
}

std::function<bool(Point2, double)> SurfacePacking::staying_far(
    const PolyhedralComplex::Facet& facet) const {
  std::vector<std::array<Point2, 2>> ends;
  std::vector<Box2> boxes;
  for (const Index s : facet.segments) {
    ends.push_back({facet.frame.coordinates(complex_.points[complex_.segments[s].a]),
                    facet.frame.coordinates(complex_.points[complex_.segments[s].b])});
    boxes.push_back(Box2::around(ends.back()));
  }
  return [ends = std::move(ends), tree = BoxTree(std::move(boxes))](Point2 p, double far) {
    bool is_far = true;
    tree.for_each_meeting({{p.x - far, p.y - far}, {p.x + far, p.y + far}}, [&](std::size_t i) {
      is_far = is_far && distance_to_segment(p, ends[i][0], ends[i][1]) >= far;
    });
    return is_far;
  };
}

// Which of the regions that its segments enclose belong to the facet: those over its triangles.
std::function<Zone(Point2)> zones_over(const PolyhedralComplex& complex,
                                       const PolyhedralComplex::Facet& facet) {
  std::vector<std::array<Point2, 3>> corners;
  std::vector<Box2> boxes;
  for (const auto& [a, b, c] : facet.triangles) {
    corners.push_back({facet.frame.coordinates(complex.points[a]),
                       facet.frame.coordinates(complex.points[b]),
                       facet.frame.coordinates(complex.points[c])});
    boxes.push_back(Box2::around(corners.back()));
  }
  return [corners = std::move(corners), tree = BoxTree(std::move(boxes))](Point2 p) {
    Zone zone{.is_inside = false};
    tree.for_each_meeting({p, p}, [&](std::size_t i) {
      const auto& [a, b, c] = corners[i];
      zone.is_inside = zone.is_inside ||
                       (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0);
    });
    return zone;
  };
}

Status SurfacePacking::pack_facet(Index f) {
  surface_.first_triangle.push_back(static_cast<Index>(surface_.triangles.size()));
  const PolyhedralComplex::Facet& facet = complex_.facets[f];
  std::vector<Index> on;
  const PackedBoundary boundary = boundary_of(facet, on);
  InteriorOptions interior;
  // Where the radius is none, no ball is put, and the facet is refused afterwards.
  interior.radius = [&](Point2 p) {
    const double radius = options_.radius(facet.frame.point(p));
    if (!(radius > 0)) bad_place_ = facet.frame.point(p);
    return radius > 0 ? radius : std::numeric_limits<double>::infinity();
  };
  interior.is_far = staying_far(facet);
  interior.slope = options_.slope;
  interior.zone_at = zones_over(complex_, facet);
  interior.smallest_angle_deg = 0;
  interior.maximality = options_.maximality;
  interior.placement = BallPlacement::kGeneric;
  interior.max_points = boundary.points.size() + room();
  interior.progress = [this](auto, auto, auto) { return meter_.step(kSurfaceStepsAQuestion); };
  const auto packed = pack_interior(boundary, interior);
  if (!packed) return packed.error();
  if (bad_place_) return not_positive_at(*bad_place_);
  if (packed->was_cancelled) return cancelled();
  if (!packed->is_complete)
    return Error{ErrorCode::kLimit, "the facets need more points than the limit", {}};
  std::vector<Index> number;
  for (Index v = 0; v < packed->mesh.points.size(); ++v) {
    const Index known = packed->boundary_point[v];
    number.push_back(known != kNoIndex ? on[known]
                                       : add(facet.frame.point(packed->mesh.points[v])));
    if (known == kNoIndex) on.push_back(number.back());
  }
  for (const auto& [a, b, c] : packed->mesh.triangles)
    surface_.triangles.push_back({number[a], number[b], number[c]});
  surface_.on_facet.push_back(std::move(on));
  return Ok{};
}

// Whether all balls have a radius: a size function is asked at many places.
Status SurfacePacking::check_radii() const {
  for (Index v = 0; v < surface_.points.size(); ++v) {
    const bool is_node = v >= complex_.points.size() || complex_.is_vertex[v];
    if (is_node && !(surface_.radius[v] > 0)) return not_positive_at(surface_.points[v]);
  }
  return Ok{};
}

PackedSurface SurfacePacking::result() {
  surface_.first_triangle.push_back(static_cast<Index>(surface_.triangles.size()));
  surface_.facet_points = surface_.points.size() - complex_.points.size() - surface_.segment_points;
  return std::move(surface_);
}

}  // namespace

Result<PackedSurface> pack_surface(const PolyhedralComplex& complex,
                                   const SurfaceOptions& options) {
  SurfacePacking packing(complex, options);
  if (Status status = packing.pack_points(); !status) return status.error();
  for (Index s = 0; s < complex.segments.size(); ++s)
    if (Status status = packing.pack_one_segment(s); !status) return status.error();
  packing.end_segments();
  for (Index f = 0; f < complex.facets.size(); ++f)
    if (Status status = packing.pack_facet(f); !status) return status.error();
  if (Status status = packing.check_radii(); !status) return status.error();
  return packing.result();
}

}  // namespace wellspaced
