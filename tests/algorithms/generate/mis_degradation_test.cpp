#include "wellspaced/algorithms/generate/mis_degradation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"

namespace wellspaced {
namespace {

double smallest_angle_deg(const TriangleMesh& mesh) {
  const AngleStatistics angles = angle_statistics(mesh);
  return std::min(angles.interior_min_deg.value_or(180), angles.boundary_min_deg.value_or(180));
}

// Table 6.1, both columns of nodes, on levels made by the coarsener itself. Its angles are
// truncated, to one digit or two.
TEST(MisDegradation, HalvesTheAngleOfIndependentSetsAsTableSixOneSays) {
  const double published[] = {45, 33.6, 23.9, 16.5, 11.17, 7.5};
  const std::size_t in_table[] = {1, 6, 36, 216, 1296, 7776};
  const std::size_t needed[] = {4, 12, 50, 252, 1394, 8052};
  for (const unsigned k : {1u, 3u, 5u}) {
    const auto mesh = generate_mis_degradation(k);
    ASSERT_TRUE(mesh.ok());
    EXPECT_EQ(mesh->points.size(), needed[k]);
    CoarseningOptions options;
    options.method = CoarseningMethod::kMis;
    options.order = SelectionOrder::kPriority;
    options.protect = 0;
    const auto hierarchy = coarsen(*mesh, options);
    ASSERT_GT(hierarchy->levels.size(), k);
    for (unsigned level = 0; level <= k; ++level) {
      const TriangleMesh& coarse = hierarchy->levels[level].mesh;
      EXPECT_EQ(coarse.points.size(), needed[k - level]);
      EXPECT_EQ(coarse.triangles.size(), 2 * in_table[k - level]);
      const double angle = smallest_angle_deg(coarse);
      EXPECT_NEAR(angle, std::atan(std::pow(2. / 3, level)) * 57.29577951308232, 1e-3);
      EXPECT_GE(angle + 1e-3, published[level]);
      EXPECT_LT(angle, published[level] + 0.1);
    }
  }
}

TEST(MisDegradation, RefusesMoreLevelsThanItHasRoomFor) {
  for (const unsigned levels : {0u, 9u})
    EXPECT_EQ(generate_mis_degradation(levels).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace wellspaced
