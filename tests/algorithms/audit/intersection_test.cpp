#include "wellspaced/algorithms/audit/intersection.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/algorithms/audit/triangle_overlap.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

// The same by all pairs.
audit::Intersections slow_intersections(const TriangleMesh& fine, const TriangleMesh& coarse) {
  audit::Intersections result;
  result.per_coarse.assign(coarse.triangles.size(), 0);
  result.per_fine.assign(fine.triangles.size(), 0);
  for (Index t = 0; t < coarse.triangles.size(); ++t)
    for (Index s = 0; s < fine.triangles.size(); ++s) {
      const auto a = audit::corners_of(coarse.points, coarse.triangles[t]);
      const auto b = audit::corners_of(fine.points, fine.triangles[s]);
      if (!audit::interiors_overlap(a, b)) continue;
      ++result.per_coarse[t];
      ++result.per_fine[s];
    }
  return result;
}

struct Level {
  TriangleMesh mesh;
  std::vector<Index> origin;
};

// The Delaunay triangulation of every node of `fine` with probability 1/keep.
Level random_level(const TriangleMesh& fine, std::uint64_t keep, Random& random) {
  Level level;
  for (Index v = 0; v < fine.points.size(); ++v) {
    if (random.below(keep) != 0) continue;
    level.origin.push_back(v);
    level.mesh.points.push_back(fine.points[v]);
  }
  const Delaunay2 delaunay = Delaunay2::build(level.mesh.points).value();
  for (Index t = 0; t < delaunay.topology().size(); ++t)
    if (!delaunay.topology().is_ghost(t))
      level.mesh.triangles.push_back(delaunay.topology().vertices(t));
  return level;
}

void expect_same(const audit::Intersections& a, const audit::Intersections& b) {
  EXPECT_EQ(a.per_coarse, b.per_coarse);
  EXPECT_EQ(a.per_fine, b.per_fine);
}

TEST(Intersections, AgreeWithAllPairsOnEveryKindOfMesh) {
  Random random(1);
  for (const auto& [name, fine] : test::clean_meshes()) {
    if (fine.triangles.size() > 3500) continue;
    for (const std::uint64_t keep : {2, 3, 8}) {
      SCOPED_TRACE(name);
      // Coarse triangles that fill holes and slits are the hard case: they leave the fine mesh.
      const Level level = random_level(fine, keep, random);
      const auto expected = slow_intersections(fine, level.mesh);
      expect_same(audit::count_intersections(fine, level.mesh, level.origin), expected);
      expect_same(audit::count_intersections(fine, level.mesh, {}), expected);
    }
  }
}

TEST(Intersections, DoNotDependOnWrongOrigins) {
  Random random(2);
  const TriangleMesh fine = test::random_mesh(200, 7);
  Level level = random_level(fine, 3, random);
  const auto expected = slow_intersections(fine, level.mesh);
  for (Index& v : level.origin) v = static_cast<Index>(random.below(400));
  expect_same(audit::count_intersections(fine, level.mesh, level.origin), expected);
}

TEST(Intersections, AMeshMeetsItselfOncePerTriangle) {
  const TriangleMesh mesh = test::slit_square(5);
  std::vector<Index> origin(mesh.points.size());
  for (Index v = 0; v < origin.size(); ++v) origin[v] = v;
  const auto result = audit::count_intersections(mesh, mesh, origin);
  EXPECT_EQ(result.max_per_coarse(), 1u);
  EXPECT_EQ(result.mean_per_coarse(), 1.0);
  EXPECT_EQ(result.max_per_fine(), 1u);
  EXPECT_EQ(result.similarity, 1.0);
}

TEST(Intersections, FindIslandsOfTheFineMeshInsideACoarseTriangle) {
  TriangleMesh fine;
  fine.points = {{0, 0}, {10, 0}, {0, 10}, {1, 1}, {2, 1}, {1, 2}, {4, 4}, {5, 4}, {4, 5}};
  fine.triangles = {{3, 4, 5}, {6, 7, 8}};
  TriangleMesh coarse;
  coarse.points = {{0, 0}, {10, 0}, {0, 10}};
  coarse.triangles = {{0, 1, 2}};
  const auto result = audit::count_intersections(fine, coarse, std::vector<Index>{0, 1, 2});
  EXPECT_EQ(result.per_coarse, std::vector<Index>{2});
  EXPECT_EQ(result.per_fine, (std::vector<Index>{1, 1}));
}

TEST(Intersections, SimilarityIsTheLargestRatioOfLongestEdgesEitherWay) {
  const auto fine = generate_grid({.nx = 9, .ny = 9}).value();
  TriangleMesh coarse;
  coarse.points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  coarse.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto result = audit::count_intersections(fine, coarse, std::vector<Index>{0, 8, 80, 72});
  EXPECT_EQ(result.similarity, 8);
  EXPECT_EQ(result.per_coarse, (std::vector<Index>{64, 64}));
  EXPECT_EQ(audit::count_intersections(coarse, fine, {}).similarity, 8);
}

}  // namespace
}  // namespace wellspaced
