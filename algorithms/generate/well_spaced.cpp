#include "wellspaced/algorithms/generate/well_spaced.hpp"

#include <cmath>

#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

constexpr Point2 kCentre{0.5, 0.5};

Pslg square_domain() {
  Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  return square;
}

// A function of slope 1 that grows by 2^octaves from the centre to the corners; 1 where it is to be
// constant.
SizeFunction shape_of(double octaves) {
  if (octaves == 0) return [](Point2) { return 1.0; };
  const double offset = distance(kCentre, {0, 0}) / (power_of_two(octaves) - 1);
  return [offset](Point2 p) { return offset + distance(p, kCentre); };
}

Result<PackedMesh> set_at_scale(double scale, const WellSpacedOptions& options,
                                const Progress& progress) {
  PackingOptions packing;
  const SizeFunction shape = shape_of(options.octaves);
  packing.size = [scale, shape](Point2 p) { return scale * shape(p); };
  packing.max_points = 4 * std::size_t{options.nodes} + 100;
  packing.progress = progress;
  if (options.style == WellSpacedStyle::kTight) packing.placement = BallPlacement::kKissing;
  auto packed = pack_domain(square_domain(), packing);
  if (packed && packed->was_cancelled) return cancelled();
  return packed;
}

}  // namespace

Result<TriangleMesh> generate_well_spaced(const WellSpacedOptions& options,
                                          const Progress& progress) {
  if (options.nodes < 20 || options.nodes > (Index{1} << 26))
    return Error{ErrorCode::kUsage, "a well-spaced set may have 20 to 2^26 nodes", {}};
  if (!(options.octaves >= 0 && options.octaves <= 16))
    return Error{ErrorCode::kUsage, "a well-spaced set may be graded over 0 to 16 octaves", {}};
  ProgressMeter meter(progress, "generate", 0, 1);  // of meshes, how many nobody knows
  const Progress go_on = [&](auto, auto, auto) { return meter.step(); };
  constexpr int kMostRounds = 12;
  constexpr double kLargestScale = 0.5;
  const double wanted = options.nodes, tolerance = options.nodes < 200 ? 0.1 : 0.05;
  double scale = kLargestScale;
  for (int round = 0; round < kMostRounds; ++round) {
    auto packed = set_at_scale(scale, options, go_on);
    if (!packed) return packed.error();
    const double count = static_cast<double>(packed->mesh.points.size());
    if (std::fabs(count - wanted) <= tolerance * wanted) return std::move(packed->mesh);
    // The number times the square of the scale is nearly constant; on the way up, by steps.
    const double next = count < wanted / 8 ? std::fmin(wanted, 8 * count) : wanted;
    scale = std::fmin(scale * std::sqrt(count / next), kLargestScale);
  }
  return Error{ErrorCode::kUsage, "this number of nodes does not suit this grading", {}};
}

}  // namespace wellspaced
