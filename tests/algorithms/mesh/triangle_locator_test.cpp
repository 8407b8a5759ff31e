#include "wellspaced/algorithms/mesh/triangle_locator.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_meshes.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

TEST(TriangleLocator, FindsAllClosedTrianglesAtAPlace) {
  const TriangleMesh mesh =
      test::grid_mesh({.nx = 12, .ny = 9, .jitter = 0, .hole = 0.3, .seed = 5});
  const TriangleLocator locator(mesh.points, mesh.triangles);
  Random random(6);
  for (int trial = 0; trial < 500; ++trial) {
    // Multiples of 1/4: many on edges and at nodes.
    const Point2 x{static_cast<double>(random.below(52)) / 4 - 0.5,
                   static_cast<double>(random.below(40)) / 4 - 0.5};
    std::vector<Index> expected;
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      bool inside = true;
      for (int i = 0; i < 3; ++i)
        inside = inside && orient2d(mesh.points[mesh.triangles[t][i]],
                                    mesh.points[mesh.triangles[t][(i + 1) % 3]], x) >= 0;
      if (inside) expected.push_back(t);
    }
    EXPECT_EQ(locator.triangles_at(x), expected);
  }
}

TEST(TriangleLocator, FindsNothingInAnEmptyMesh) {
  EXPECT_TRUE(TriangleLocator({}, {}).triangles_at({0, 0}).empty());
}

}  // namespace
}  // namespace wellspaced
