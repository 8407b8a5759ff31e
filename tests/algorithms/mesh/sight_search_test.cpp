#include "wellspaced/algorithms/mesh/sight_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

void expect_that_of_visibility(const TriangleMesh& mesh, std::initializer_list<double> radii) {
  const Visibility visibility(mesh);
  SightSearch search(visibility);
  for (const double radius : radii) {
    for (Index p = 0; p < mesh.points.size(); ++p) {
      std::vector<Index> expected;
      for (Index q = 0; q < mesh.points.size(); ++q)
        if (distance(mesh.points[p], mesh.points[q]) <= radius && visibility.sees(p, q))
          expected.push_back(q);
      const auto found = search.run(p, radius);
      std::vector<Index> sorted(found.begin(), found.end());
      std::sort(sorted.begin(), sorted.end());
      ASSERT_EQ(sorted, expected) << p << " radius " << radius;
    }
  }
}

TEST(SightSearch, FindsWhatANodeSeesWithinTheRadius) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    expect_that_of_visibility(
        test::grid_mesh({.nx = 9, .ny = 8, .jitter = 0.2, .hole = 0.2, .seed = seed}),
        {0., 1.2, 3., 20.});
}

// Lines of sight along walls, through nodes, and between walls that touch them on either side.
TEST(SightSearch, SeesAlongWallsAndThroughGapsWithoutWidth) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    expect_that_of_visibility(
        test::grid_mesh({.nx = 9, .ny = 8, .jitter = 0, .hole = 0.1 * seed, .seed = seed}),
        {1.5, 4., 20.});
}

TEST(SightSearch, SeesAlongTheLipsOfSlitsAndNotAcross) {
  for (const double jitter : {0., 0.2}) {
    TriangleMesh mesh = test::grid_mesh({.nx = 11, .ny = 9, .jitter = jitter, .seed = 2});
    test::cut_slit(mesh, 12, 3, 0, 9);
    test::cut_slit(mesh, 12, 6, 2, 10);
    expect_that_of_visibility(mesh, {1.5, 4., 20.});
  }
}

}  // namespace
}  // namespace wellspaced
