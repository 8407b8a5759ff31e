// Node sets against those of the slow implementation of CHOICES.md in tests/support.
#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "tests/support/grid_meshes.hpp"
#include "tests/support/slow_coarsening.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"

namespace wellspaced {
namespace {

void expect_same_levels(const TriangleMesh& mesh, CoarseningOptions options) {
  const auto hierarchy = coarsen(mesh, options);
  ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
  const bool mis = options.method == CoarseningMethod::kMis;
  const double protect = options.protect.value_or(mis ? 0.15 : 0.2);
  test::SlowCoarsening slow(mesh, hierarchy->levels[0].mesh.fixed,
                            {mis, options.beta, options.factor, protect, options.seed});
  const auto expected = slow.levels();
  ASSERT_EQ(hierarchy->levels.size(), expected.size() + 1);
  for (std::size_t level = 1; level <= expected.size(); ++level)
    ASSERT_EQ(hierarchy->levels[level].origin, expected[level - 1]) << "level " << level;
}

constexpr CoarseningMethod kMethods[] = {CoarseningMethod::kFunction, CoarseningMethod::kMis};

// A grid whose cells grow to the right, with a rectangular hole.
TriangleMesh graded_plate(std::uint64_t seed) {
  TriangleMesh mesh = test::grid_mesh({.nx = 30, .ny = 20, .jitter = 0.15, .seed = seed});
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const Index cell = t[0], x = cell % 31, y = cell / 31;
    return x >= 10 && x < 14 && y >= 7 && y < 12;
  });
  for (Point2& p : mesh.points) p = {p.x * (1 + p.x / 10), p.y * (1 + p.x / 15)};
  return mesh;
}

TEST(CoarseningReference, AgreesOnGradedPlatesWithAHole) {
  for (const CoarseningMethod method : kMethods)
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const TriangleMesh mesh = graded_plate(seed);
      expect_same_levels(
          mesh, {.method = method, .factor = 2 + 0.5 * static_cast<double>(seed), .seed = seed});
    }
}

TEST(CoarseningReference, AgreesForSmallBetaAndNoProtection) {
  for (const double beta : {1.1, 2.0, 4.0})
    expect_same_levels(graded_plate(9), {.beta = beta, .factor = 3, .protect = 0.0});
}

TEST(CoarseningReference, AgreesOnAirfoil1ForAnotherSeed) {
  const auto mesh = test::data_mesh("thesis/airfoil1");
  if (!mesh) GTEST_SKIP() << "no " << test::data_path("thesis");
  for (const CoarseningMethod method : kMethods)
    expect_same_levels(*mesh, {.method = method, .seed = 2});
}

TEST(CoarseningReference, AgreesOnAirfoil3) {
  const auto mesh = test::data_mesh("thesis/airfoil3_original");
  if (!mesh) GTEST_SKIP() << "no " << test::data_path("thesis");
  expect_same_levels(*mesh, {});
}

}  // namespace
}  // namespace wellspaced
