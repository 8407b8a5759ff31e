#include "wellspaced/algorithms/generate/graded_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/curved_domain.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"

namespace wellspaced {
namespace {

constexpr Index kLeastNodes = 300;
constexpr Index kMostNodes = Index{1} << 26;
constexpr double kMostOctaves = 16;
constexpr double kSmallestAngleDeg = 25;

// The steepest spacing that keeps angles of 25 degrees: balls alone allow 0.15, arcsin((1 - L) / 2)
// being the angle for a slope of L, and cutting small angles reaches more.
constexpr double kSteepest = 0.3;

CurvedDomain domain_of(GradedDomain kind, double octaves) {
  switch (kind) {
    case GradedDomain::kCrack:
      return crack_domain(octaves);
    case GradedDomain::kAnnulus:
      return annulus_domain(octaves);
    case GradedDomain::kAirfoil:
      return airfoil_domain(octaves);
  }
  return crack_domain(octaves);
}

double usual_octaves(GradedDomain kind) {
  switch (kind) {
    case GradedDomain::kCrack:
      return 12;
    case GradedDomain::kAnnulus:
      return 5;
    case GradedDomain::kAirfoil:
      return 9;
  }
  return 0;
}

Status check(const GradedMeshOptions& options) {
  if (options.nodes < kLeastNodes || options.nodes > kMostNodes)
    return Error{ErrorCode::kUsage, "a graded mesh may have 300 to 2^26 nodes", {}};
  if (!(options.octaves <= kMostOctaves))
    return Error{ErrorCode::kUsage, "a mesh may be graded over at most 16 octaves", {}};
  return Ok{};
}

Error too_coarse() {
  return {ErrorCode::kLimit, "the spacing is too large for the boundary's shape", {}};
}

Result<TriangleMesh> mesh_at(const CurvedDomain& domain, double scale, Index nodes,
                             const Progress& progress) {
  const std::size_t max_points = 2 * std::size_t{nodes};
  const Pslg boundary = discretize(domain, scale);
  if (boundary.points.size() > max_points)
    return Error{ErrorCode::kLimit, "the boundary alone has too many nodes", {}};
  PackingOptions options;
  options.size = [&](Point2 p) { return scale * domain.grading(p); };
  options.holes = HoleRule::kSeeds;
  options.max_points = max_points;
  options.progress = progress;
  auto packed = pack_domain(boundary, options);
  if (!packed && packed.error().code == ErrorCode::kInvalidGeometry) return too_coarse();
  if (!packed) return packed.error();
  if (packed->was_cancelled) return cancelled();
  if (!packed->is_complete)
    return Error{ErrorCode::kLimit, "the mesh would have more nodes than the limit", {}};
  return std::move(packed->mesh);
}

// The domain's mesh at the steepest spacing, which has the fewest nodes, if these are not too many.
Result<TriangleMesh> smallest_mesh(const CurvedDomain& domain, Index nodes,
                                   const Progress& progress) {
  auto mesh = mesh_at(domain, kSteepest, nodes, progress);
  if (mesh && mesh->points.size() > nodes)
    return Error{ErrorCode::kLimit, "the steepest spacing gives too many nodes", {}};
  return mesh;
}

// Follows n scale^2, which is nearly constant, up to the number of nodes: by way of an eighth of
// it, so that only the last meshes are costly.
Result<TriangleMesh> mesh_of_size(const CurvedDomain& domain, Index nodes, TriangleMesh mesh,
                                  const Progress& progress) {
  constexpr int kMostRounds = 12;
  const double wanted = nodes, tolerance = nodes < 1000 ? 0.04 : 0.02;
  double scale = kSteepest;
  for (int round = 0; round < kMostRounds; ++round) {
    const double count = static_cast<double>(mesh.points.size());
    if (std::fabs(count - wanted) <= tolerance * wanted) return mesh;
    const double next = round == 0 && 8 * count < wanted ? wanted / 8 : wanted;
    scale *= std::sqrt(count / next);
    auto made = mesh_at(domain, scale, nodes, progress);
    if (!made) return made.error();
    mesh = std::move(*made);
  }
  return Error{ErrorCode::kLimit, "no spacing gives this number of nodes", {}};
}

bool has_small_angle(const TriangleMesh& mesh) {
  const AngleStatistics angles = angle_statistics(mesh);
  return std::min(angles.interior_min_deg.value_or(60), angles.boundary_min_deg.value_or(60)) <
         kSmallestAngleDeg;
}

// The mesh of the size wanted if the domain bears it, else kLimit.
Result<TriangleMesh> try_mesh(const CurvedDomain& domain, Index nodes, const Progress& progress) {
  auto smallest = smallest_mesh(domain, nodes, progress);
  if (!smallest) return smallest.error();
  auto mesh = mesh_of_size(domain, nodes, std::move(*smallest), progress);
  if (mesh && has_small_angle(*mesh)) return too_coarse();
  return mesh;
}

}  // namespace

Result<TriangleMesh> generate_graded_mesh(GradedDomain domain, const GradedMeshOptions& options,
                                          const Progress& progress) {
  if (Status valid = check(options); !valid) return valid.error();
  ProgressMeter meter(progress, "generate", 0, 1);  // of meshes, how many nobody knows
  const Progress go_on = [&](auto, auto, auto) { return meter.step(); };
  const bool may_flatten = options.octaves < 0;
  double octaves = may_flatten ? usual_octaves(domain) : options.octaves;
  for (;; octaves -= 0.5) {
    auto mesh = try_mesh(domain_of(domain, octaves), options.nodes, go_on);
    if (mesh || mesh.error().code != ErrorCode::kLimit) return mesh;
    if (!may_flatten || octaves < 1)
      return Error{ErrorCode::kUsage, "this number of nodes does not suit this grading", {}};
  }
}

Result<Pslg> generate_graded_boundary(GradedDomain domain, const GradedMeshOptions& options,
                                      const Progress& progress) {
  auto mesh = generate_graded_mesh(domain, options, progress);
  if (!mesh) return mesh.error();
  Pslg boundary;
  boundary.segments = std::move(mesh->segments);
  std::vector<Index> number(mesh->points.size(), kNoIndex);
  for (Segment& s : boundary.segments)
    for (Index* end : {&s.a, &s.b}) {
      if (number[*end] == kNoIndex) {
        number[*end] = static_cast<Index>(boundary.points.size());
        boundary.points.push_back(mesh->points[*end]);
      }
      *end = number[*end];
    }
  boundary.holes = domain_of(domain, 0).holes;  // at any grading
  return boundary;
}

}  // namespace wellspaced
