#include "wellspaced/algorithms/generate/well_spaced.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

TriangleMesh generated(const WellSpacedOptions& options) {
  auto mesh = generate_well_spaced(options);
  EXPECT_TRUE(mesh.ok()) << (mesh.ok() ? "" : mesh.error().message);
  if (!mesh) return {};
  for (const auto& check : audit::audit_mesh(*mesh).checks)
    EXPECT_TRUE(!check.required || check.violations == 0) << check.name;
  return std::move(*mesh);
}

TEST(WellSpaced, HasTheSizeAskedForAndAngles) {
  for (const Index nodes : {30u, 300u, 4000u})
    for (const auto style : {WellSpacedStyle::kLoose, WellSpacedStyle::kTight}) {
      const TriangleMesh mesh = generated({.nodes = nodes, .style = style});
      EXPECT_NEAR(mesh.points.size(), nodes, (nodes < 200 ? 0.1 : 0.05) * nodes);
      const AngleStatistics angles = angle_statistics(mesh);
      EXPECT_GE(angles.boundary_min_deg.value_or(60), 25);
      EXPECT_GE(angles.interior_min_deg.value_or(60), 30 - 1e-9);
    }
}

// Figure 1.2: balls that touch leave larger angles.
TEST(WellSpaced, IsMoreRegularWherePackedTightly) {
  const auto mean_angle = [](const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
      double shortest = 1e9, longest = 0;
      for (int i = 0; i < 3; ++i) {
        const double d = distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]);
        shortest = std::min(shortest, d);
        longest = std::max(longest, d);
      }
      sum += shortest / longest;
    }
    return sum / static_cast<double>(mesh.triangles.size());
  };
  EXPECT_GT(mean_angle(generated({.nodes = 3000, .style = WellSpacedStyle::kTight})),
            mean_angle(generated({.nodes = 3000, .style = WellSpacedStyle::kLoose})) + 0.02);
}

// Figure 1.3: the points converge at the centre.
TEST(WellSpaced, IsGradedTowardsTheCentre) {
  const TriangleMesh mesh = generated({.nodes = 5000, .octaves = 6});
  double finest = 1, coarsest = 0;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const double d = distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]);
      finest = std::min(finest, d);
      coarsest = std::max(coarsest, d);
    }
  EXPECT_GT(coarsest / finest, 32);
  EXPECT_GE(angle_statistics(mesh).interior_min_deg.value_or(0), 25);
}

TEST(WellSpaced, RefusesOptionsOutOfRange) {
  EXPECT_EQ(generate_well_spaced({.nodes = 3}).error().code, ErrorCode::kUsage);
  EXPECT_EQ(generate_well_spaced({.octaves = 20}).error().code, ErrorCode::kUsage);
  EXPECT_EQ(generate_well_spaced({.octaves = -1}).error().code, ErrorCode::kUsage);
  EXPECT_EQ(generate_well_spaced({.nodes = 40, .octaves = 14}).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace wellspaced
