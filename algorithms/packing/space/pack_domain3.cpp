#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "wellspaced/algorithms/packing/space/domain_rules.hpp"
#include "wellspaced/algorithms/packing/space/feature_size3.hpp"
#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"
#include "wellspaced/algorithms/packing/space/solid_packing.hpp"
#include "wellspaced/algorithms/packing/space/surface_packing.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

constexpr double kLeastBeta = 9.8284271247461900976;  // 7 + 2 sqrt 2
constexpr double kSlopeRounding = 1e-9;               // of a slope that was computed

Status check_packing_options(const PackingOptions3& options) {
  if (!(options.beta > 3) || !std::isfinite(options.beta))
    return Error{ErrorCode::kUsage, "beta must be more than 3", {}};
  if (!(options.size_slope >= 0))
    return Error{ErrorCode::kUsage, "the slope of the size must not be negative", {}};
  if (!(options.flatness >= 0 && options.flatness <= 0.001))
    return Error{ErrorCode::kUsage, "the flatness may be 0 to 0.001", {}};
  return Ok{};
}

// ---- The result ----------------------------------------------------------------------------

Index item_at(const std::vector<Index>& first, Index position) {
  return static_cast<Index>(std::upper_bound(first.begin(), first.end(), position) - first.begin() -
                            1);
}

void mark_nodes(const Pls& domain, PackedTets& packed) {
  if (domain.point_markers.empty()) return;
  packed.mesh.point_markers.assign(packed.mesh.points.size(), 0);
  for (std::size_t v = 0; v < packed.domain_point.size(); ++v)
    if (packed.domain_point[v] < domain.point_markers.size())
      packed.mesh.point_markers[v] = domain.point_markers[packed.domain_point[v]];
}

PackedTets finish_tets(const Pls& domain, const PolyhedralComplex& complex,
                       const PackedSurface& surface, PackedSolids solids) {
  PackedTets packed;
  packed.mesh.points = std::move(solids.points);
  packed.mesh.tets = std::move(solids.tets);
  packed.radius = std::move(solids.radius);
  packed.region_of = std::move(solids.seed_of);
  packed.domain_point = std::move(solids.surface_point);
  for (Index& v : packed.domain_point)
    if (v >= domain.points.size()) v = kNoIndex;
  const auto node = [&](Index v) { return solids.number_of[v]; };
  for (const Index k : solids.triangles) {
    const auto& [a, b, c] = surface.triangles[k];
    const PolyhedralComplex::Facet& facet = complex.facets[item_at(surface.first_triangle, k)];
    packed.mesh.facets.push_back({{node(a), node(b), node(c)}, facet.marker});
    packed.facet_of.push_back(facet.source);
  }
  for (const Index k : solids.pieces) {
    const auto& [a, b] = surface.pieces[k];
    packed.segment_of.push_back(item_at(surface.first_piece, k));
    const Segment& segment = complex.segments[packed.segment_of.back()];
    packed.mesh.segments.push_back({node(a), node(b), segment.marker});
  }
  packed.domain_segments = complex.segments;
  packed.segment_points = surface.segment_points;
  packed.facet_points = surface.facet_points;
  packed.balls_packed = solids.balls_packed;
  packed.is_complete = solids.is_complete;
  packed.was_cancelled = solids.was_cancelled;
  mark_nodes(domain, packed);
  return packed;
}

void describe_outside(const PolyhedralComplex& complex, const PackedSurface& surface,
                      const PackedTets& packed, std::vector<std::string>& notes) {
  std::vector<std::uint8_t> is_node(complex.points.size());
  for (const Index v : packed.domain_point)
    if (v != kNoIndex) is_node[v] = 1;
  std::size_t outside = 0;
  for (std::size_t v = 0; v < is_node.size(); ++v) outside += complex.is_vertex[v] && !is_node[v];
  if (outside > 0)
    notes.push_back(
        concat({outside, outside == 1 ? " point is" : " points are", " in no solid and left out"}));
  if (packed.mesh.segments.size() < surface.pieces.size())
    notes.push_back("segments, or parts of them, are in no solid and left out");
}

void describe_regions(const std::vector<Pls::Region>& regions, std::vector<std::string>& notes) {
  const auto limited = std::count_if(regions.begin(), regions.end(),
                                     [](const Pls::Region& r) { return r.max_volume > 0; });
  if (limited > 0)
    notes.push_back(concat({"the largest volumes of tets that ", limited,
                            limited == 1 ? " region wants" : " regions want",
                            " are not kept: lower the size instead"}));
}

// ---- Scale ---------------------------------------------------------------------------------

// The power of two that makes the largest coordinate difference about 1.
double scale_of(const std::vector<Point3>& points) {
  if (points.empty()) return 1;
  const auto [low, high] = Box3::around(points);
  const double half_extent =
      std::max({high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2});
  if (!(half_extent > 0) || !std::isfinite(half_extent)) return 1;
  const int exponent = std::ilogb(half_extent);
  return std::abs(exponent) <= 60 ? 1 : std::ldexp(1, std::clamp(-exponent, -1000, 1000));
}

Pls scaled_system(Pls domain, double scale) {
  for (Point3& p : domain.points) p = scale * p;
  for (Point3& p : domain.holes) p = scale * p;
  for (Pls::Facet& facet : domain.facets)
    for (Point3& p : facet.holes) p = scale * p;
  for (Pls::Region& region : domain.regions) region.seed = scale * region.seed;
  return domain;
}

// ---- The steps -----------------------------------------------------------------------------

BallRadius3 radius_function(const FeatureSize3& features, const PackingOptions3& options) {
  return [&options, cursor = FeatureSize3::Cursor(features)](Point3 p) mutable {
    if (!options.size) return cursor.at(p) / options.beta;
    const double own = options.size(p) / 2;
    return std::min(own, cursor.capped(p, own * options.beta) / options.beta);
  };
}

double slope_of(const PackingOptions3& options) {
  const double own = 1 / options.beta;
  return options.size ? std::max(own, options.size_slope / 2) : own;
}

SurfaceOptions surface_options(const FeatureSize3& features, const PackingOptions3& options) {
  SurfaceOptions surface;
  surface.radius = radius_function(features, options);
  surface.slope = slope_of(options);
  surface.maximality = options.maximality;
  surface.max_points = options.max_points;
  surface.progress = options.progress;
  return surface;
}

SolidOptions solid_options(const SurfaceOptions& surface, const Pls& domain) {
  SolidOptions solids;
  solids.radius = surface.radius;
  solids.slope = surface.slope;
  solids.maximality = surface.maximality;
  solids.holes = domain.holes;
  for (const Pls::Region& region : domain.regions) solids.seeds.push_back(region.seed);
  solids.max_points = surface.max_points;
  solids.progress = surface.progress;
  return solids;
}

void describe_guarantee(const PackingOptions3& options, std::vector<std::string>& notes) {
  if (options.size && slope_of(options) > 1 / options.beta * (1 + kSlopeRounding))
    notes.push_back("no guarantee: the size is not known to grow by 2 / beta at most");
  if (!(options.beta > kLeastBeta))
    notes.push_back("no guarantee: beta is not above 7 + 2 sqrt 2 = 9.83");
}

Result<PackedTets> pack_usual_domain(const Pls& domain, const PackingOptions3& options) {
  constexpr std::size_t kMostFaults = 1000;
  const auto complex = build_complex(domain, options.flatness, options.progress);
  if (!complex) return complex.error();
  ProgressParts check(options.progress, "check", 2);
  const FeatureSize3 features(*complex, check.part(0));
  if (check.stopped()) return cancelled();
  const auto faults =
      find_rule_violations(*complex, features, options.flatness, kMostFaults, check.part(1));
  if (check.stopped()) return cancelled();
  if (!faults.empty()) return rule_error(faults, *complex);

  const SurfaceOptions surface_step = surface_options(features, options);
  const auto surface = pack_surface(*complex, surface_step);
  if (!surface) return surface.error();
  auto solids = pack_solids(*complex, *surface, solid_options(surface_step, domain));
  if (!solids) return solids.error();

  PackedTets packed = finish_tets(domain, *complex, *surface, std::move(*solids));
  packed.notes = complex->notes;
  describe_outside(*complex, *surface, packed, packed.notes);
  describe_regions(domain.regions, packed.notes);
  describe_guarantee(options, packed.notes);
  return packed;
}

}  // namespace

std::optional<double> radius_edge_bound(double beta) {
  if (!(beta > kLeastBeta)) return std::nullopt;
  return 2 * beta / (beta - kLeastBeta);
}

std::optional<double> beta_for_radius_edge(double rho) {
  if (!(rho > 2)) return std::nullopt;
  return rho * kLeastBeta / (rho - 2);
}

Result<PackedTets> pack_domain3(const Pls& domain, const PackingOptions3& options) {
  if (Status valid = check_packing_options(options); !valid) return valid.error();
  const double scale = scale_of(domain.points);
  if (scale == 1) return pack_usual_domain(domain, options);
  PackingOptions3 scaled_options = options;
  if (options.size)
    scaled_options.size = [&](Point3 p) { return scale * options.size((1 / scale) * p); };
  auto packed = pack_usual_domain(scaled_system(domain, scale), scaled_options);
  if (!packed) return packed.error();
  for (Point3& p : packed->mesh.points) p = (1 / scale) * p;
  for (double& radius : packed->radius) radius /= scale;
  return packed;
}

double nodes_by_integral(const PackedTets& packed) {
  const std::vector<Point3>& p = packed.mesh.points;
  double integral = 0;
  for (const auto& tet : packed.mesh.tets) {
    const Point3 a = p[tet[0]];
    const double volume = dot(p[tet[1]] - a, cross(p[tet[2]] - a, p[tet[3]] - a)) / 6;
    for (const Index v : tet) {
      const double r = packed.radius[v];
      integral += volume / r / r / r / 4;
    }
  }
  return integral > 0 ? static_cast<double>(p.size()) / integral : 0;
}

}  // namespace wellspaced
