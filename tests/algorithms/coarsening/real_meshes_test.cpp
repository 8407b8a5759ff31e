// Sequences of real meshes, every level judged by a checker that shares nothing with the coarsener.
#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "tests/support/mesh_checker.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"

namespace wellspaced {
namespace {

struct Case {
  const char* mesh;
  CoarseningMethod method;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  const std::string path = info.param.mesh;
  return path.substr(path.find('/') + 1) +
         (info.param.method == CoarseningMethod::kQuadtree ? "_quadtree"
          : info.param.method == CoarseningMethod::kMis    ? "_mis"
                                                           : "_function");
}

class RealMeshes : public testing::TestWithParam<Case> {};

void expect_valid_level(const Hierarchy& hierarchy, std::size_t k, test::MeshShape shape) {
  const Level& level = hierarchy.levels[k];
  test::MeshChecker checker(level.mesh);
  EXPECT_EQ(checker.check_validity(), std::vector<std::string>());
  EXPECT_EQ(checker.check_constrained_delaunay(), std::vector<std::string>());
  EXPECT_EQ(checker.shape(), shape);
  const Level& finer = hierarchy.levels[k - 1];
  ASSERT_EQ(level.parent.size(), level.mesh.points.size());
  for (Index v = 0; v < level.parent.size(); ++v) {
    ASSERT_LT(level.parent[v], finer.mesh.points.size());
    ASSERT_EQ(level.mesh.points[v], finer.mesh.points[level.parent[v]]);
    ASSERT_EQ(level.origin[v], finer.origin[level.parent[v]]);
    ASSERT_GT(level.spacing[v], 0);
  }
  for (const Index v : hierarchy.levels[0].mesh.fixed)
    EXPECT_TRUE(std::ranges::binary_search(level.origin, v)) << "special point " << v << " lost";
}

TEST_P(RealMeshes, KeepTheirHolesAndComponentsToTheEnd) {
  const auto mesh = test::data_mesh(GetParam().mesh);
  if (!mesh) GTEST_SKIP() << "no " << test::data_path(GetParam().mesh);
  const test::MeshShape shape = test::MeshChecker(*mesh).shape();
  for (const std::uint64_t seed : {1, 2, 3}) {
    CoarseningOptions options = theorem_options(GetParam().method);
    options.seed = seed;
    const auto hierarchy = coarsen(*mesh, options);
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    EXPECT_TRUE(hierarchy->complete);
    EXPECT_GT(hierarchy->levels.size(), 3u);
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", level " + std::to_string(k));
      expect_valid_level(*hierarchy, k, shape);
    }
  }
}

constexpr CoarseningMethod kFunction = CoarseningMethod::kFunction, kMis = CoarseningMethod::kMis,
                           kQuadtree = CoarseningMethod::kQuadtree;

INSTANTIATE_TEST_SUITE_P(
    Data, RealMeshes,
    testing::Values(
        Case{"thesis/airfoil1", kFunction}, Case{"thesis/airfoil1", kMis},
        Case{"thesis/airfoil1", kQuadtree}, Case{"thesis/airfoil3_original", kFunction},
        Case{"thesis/airfoil3_original", kMis}, Case{"thesis/airfoil3_original", kQuadtree},
        Case{"thesis/crack_float32", kFunction}, Case{"thesis/crack_float32", kMis},
        Case{"thesis/crack_float32", kQuadtree}, Case{"thesis/crack_slit", kFunction},
        Case{"thesis/crack_slit", kMis}, Case{"thesis/crack_slit", kQuadtree},
        Case{"graded/su2_naca0012_inv", kFunction}, Case{"graded/su2_naca0012_inv", kMis},
        Case{"graded/su2_naca0012_inv", kQuadtree}, Case{"graded/adcirc_shinnecock", kFunction},
        Case{"graded/adcirc_shinnecock", kMis}, Case{"graded/adcirc_shinnecock", kQuadtree},
        Case{"graded/thetis_north_sea_demo", kFunction}, Case{"graded/thetis_north_sea_demo", kMis},
        Case{"graded/thetis_north_sea_demo", kQuadtree}),
    name_of);

}  // namespace
}  // namespace wellspaced
