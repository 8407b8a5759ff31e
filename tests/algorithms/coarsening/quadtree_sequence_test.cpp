#include "wellspaced/algorithms/coarsening/quadtree_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/mesh_checker.hpp"
#include "wellspaced/algorithms/coarsening/quadtree_stages.hpp"
#include "wellspaced/algorithms/coarsening/skeleton.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

constexpr int kParts = 3;  // k: a leaf has 4^k parts

CoarseningOptions quadtree_options() { return theorem_options(CoarseningMethod::kQuadtree); }

TriangleMesh uniform_mesh(Index n) { return *generate_grid({.nx = n, .ny = n}); }

TriangleMesh graded_mesh() { return *generate_graded_mesh(GradedDomain::kCrack, {.nodes = 4000}); }

// Level 0 as coarsen() makes it, with its first stages.
struct Stages {
  Level finest;
  std::vector<QuadtreeStage> stages;
};

Stages first_stages(const TriangleMesh& mesh, double beta, std::size_t count) {
  const Skeleton skeleton = skeleton_of(mesh);
  CoarseningOptions options = quadtree_options();
  options.max_levels = 0;
  Stages result{coarsen(mesh, options)->levels[0], {}};
  result.stages.push_back(first_stage(result.finest, skeleton.boundary, beta));
  const Quadtree root(result.stages[0].tree.square());
  while (result.stages.size() < count)
    result.stages.push_back(next_stage(result.stages.back(), 1, root));
  return result;
}

// The part of its leaf that a cell lies in, as its first cell and depth.
std::pair<MortonCode, int> part_of(const Quadtree& tree, MortonCode cell) {
  const int depth = std::min(tree.depth(tree.locate(cell)) + kParts, kMortonDepth);
  return {morton::ancestor(cell, depth), depth};
}

TEST(QuadtreeStages, NumberCandidatesAlongTheCurveLeafByLeaf) {
  const auto [finest, stages] = first_stages(graded_mesh(), 2, 4);
  for (const QuadtreeStage& stage : stages) {
    EXPECT_TRUE(std::is_sorted(stage.cells.begin(), stage.cells.end()));
    if (&stage == &stages[0]) continue;
    EXPECT_EQ(stage.first.size(), stage.tree.leaves() + 1);
    for (Index leaf = 0; leaf < stage.tree.leaves(); ++leaf)
      for (Index v = stage.first[leaf]; v < stage.first[leaf + 1]; ++v) {
        EXPECT_EQ(stage.leaf_of[v], leaf);
        EXPECT_EQ(stage.tree.locate(stage.points[v]), leaf);
        EXPECT_EQ(stage.points[v], finest.mesh.points[stage.origin[v]]);
      }
  }
}

TEST(QuadtreeStages, HaveLeavesAsWideAsTheSpacingAsks) {
  const auto [finest, stages] = first_stages(graded_mesh(), 2, 1);
  const QuadtreeStage& stage = stages[0];
  for (Index v = 0; v < stage.nodes(); ++v) {
    const double asked = 2.36 * 2 * finest.spacing[stage.origin[v]];
    const double side = stage.tree.side(stage.tree.locate(stage.cells[v]));
    EXPECT_LE(side, asked);
    EXPECT_GT(side, 0.04 * asked);
  }
}

TEST(QuadtreeStages, PickOneInteriorNodeInEveryPartThatHasSome) {
  const auto [finest, stages] = first_stages(uniform_mesh(60), 2, 5);
  for (std::size_t i = 1; i < stages.size(); ++i) {
    const QuadtreeStage& stage = stages[i];
    std::set<std::pair<MortonCode, int>> picked, present;
    for (Index v = 0; v < stage.nodes(); ++v)
      if (!stage.boundary.on_boundary[v])
        EXPECT_TRUE(picked.insert(part_of(stage.tree, stage.cells[v])).second);
    for (Index v = 0; v < stages[0].nodes(); ++v)
      if (!stages[0].boundary.on_boundary[v])
        present.insert(part_of(stage.tree, stages[0].cells[v]));
    EXPECT_EQ(picked, present) << "stage " << i;
    EXPECT_LE(stage.nodes(), stages[i - 1].nodes());
  }
}

TEST(QuadtreeStages, AreNestedAndKeepSpecialPoints) {
  const auto [finest, stages] = first_stages(graded_mesh(), 2, 5);
  for (std::size_t i = 1; i < stages.size(); ++i) {
    for (Index v = 0; v < stages[i].nodes(); ++v)
      EXPECT_EQ(stages[i].origin[v], stages[i - 1].origin[stages[i].finer[v]]);
    std::vector<Index> fixed;
    for (const Index v : stages[i].fixed) fixed.push_back(stages[i].origin[v]);
    std::sort(fixed.begin(), fixed.end());
    EXPECT_EQ(fixed, finest.mesh.fixed);
  }
}

TEST(QuadtreeSequence, QuartersAUniformGridAtLargeAngles) {
  const auto hierarchy = coarsen(uniform_mesh(120), quadtree_options());
  ASSERT_TRUE(hierarchy.ok());
  ASSERT_GE(hierarchy->levels.size(), 6u);
  EXPECT_NEAR(static_cast<double>(hierarchy->levels[1].mesh.points.size()), 120 * 120 / 4, 500);
  for (std::size_t k = 1; k < 5; ++k) {
    const AngleStatistics angles = angle_statistics(hierarchy->levels[k].mesh);
    EXPECT_GT(*angles.interior_min_deg, 25) << "level " << k;
    EXPECT_GT(*angles.boundary_min_deg, 15) << "level " << k;
    const double ratio = static_cast<double>(hierarchy->levels[k - 1].mesh.points.size()) /
                         static_cast<double>(hierarchy->levels[k].mesh.points.size());
    EXPECT_GT(ratio, 2.5) << "level " << k;
  }
}

// Conflicts are allowed among special points, and with nodes taken back for the boundary's sake.
TEST(QuadtreeSequence, SpacesEachLevelByItsFunction) {
  for (const double beta : {1.5, 2.0, 6.0}) {
    CoarseningOptions options = quadtree_options();
    options.beta = beta;
    const auto hierarchy = coarsen(graded_mesh(), options);
    ASSERT_TRUE(hierarchy.ok());
    std::size_t conflicts = 0, reinstated = 0;
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
      const Level& level = hierarchy->levels[k];
      const auto& p = level.mesh.points;
      const auto is_fixed = [&](Index v) {
        return std::binary_search(level.mesh.fixed.begin(), level.mesh.fixed.end(), v);
      };
      reinstated += level.reinstated;
      for (Index v = 0; v < p.size(); ++v)
        for (Index w = v + 1; w < p.size(); ++w)
          if (level.spacing[v] + level.spacing[w] > beta * distance(p[v], p[w]) * (1 + 1e-12))
            conflicts += !(is_fixed(v) && is_fixed(w));
    }
    EXPECT_LE(conflicts, 4 * reinstated) << "beta " << beta;
    if (reinstated == 0) EXPECT_EQ(conflicts, 0u);
  }
}

// Each candidate off the boundary is in the level, or in conflict with a node that is.
TEST(QuadtreeSequence, SelectsMaximalSets) {
  CoarseningOptions options = quadtree_options();
  options.protect = 0;
  for (const TriangleMesh& mesh : {uniform_mesh(40), graded_mesh()}) {
    const auto hierarchy = coarsen(mesh, options);
    const auto [finest, stages] = first_stages(mesh, options.beta, 4);
    for (std::size_t i = 1; i < stages.size(); ++i) {
      const Level& level = hierarchy->levels[i];
      const QuadtreeStage& stage = stages[i];
      for (Index v = 0; v < stage.nodes(); ++v) {
        if (stage.boundary.on_boundary[v]) continue;
        bool decided = false;
        for (Index w = 0; w < level.origin.size() && !decided; ++w)
          decided = level.origin[w] == stage.origin[v] ||
                    stage.spacing[v] + level.spacing[w] >
                        options.beta * distance(stage.points[v], level.mesh.points[w]);
        EXPECT_TRUE(decided) << "stage " << i << ", node " << stage.origin[v];
      }
    }
  }
}

TEST(QuadtreeSequence, ReturnsTheCoarseLevelsThatAreDoneWhenToldToStop) {
  const TriangleMesh mesh = graded_mesh();
  const auto whole = coarsen(mesh, quadtree_options());
  std::size_t most = 0;
  for (int calls = 0; calls < 60; calls += 4) {
    CoarseningOptions options = quadtree_options();
    int left = calls;
    options.progress = [&](std::string_view phase, std::uint64_t, std::uint64_t) {
      return phase == "prepare" || left-- > 0;
    };
    const auto part = coarsen(mesh, options);
    ASSERT_TRUE(part.ok());
    EXPECT_EQ(part->complete, left >= 0);
    ASSERT_GE(part->levels.size(), 1u);
    const std::size_t levels = part->levels.size() - 1;
    most = std::max(most, levels);
    for (std::size_t k = 1; k <= levels; ++k) {
      const Level& level = part->levels[k];
      EXPECT_EQ(level.origin, whole->levels[whole->levels.size() - 1 - levels + k].origin);
      for (Index v = 0; v < level.parent.size(); ++v)
        EXPECT_EQ(part->levels[k - 1].origin[level.parent[v]], level.origin[v]);
    }
  }
  EXPECT_GT(most, 2u);
}

TEST(QuadtreeSequence, StopsAtTheLevelsOrNodesAskedFor) {
  CoarseningOptions options = quadtree_options();
  options.max_levels = 2;
  EXPECT_EQ(coarsen(uniform_mesh(50), options)->levels.size(), 3u);
  options.max_levels = SIZE_MAX;
  options.until_nodes = 300;
  const auto hierarchy = coarsen(uniform_mesh(50), options);
  const auto& levels = hierarchy->levels;
  EXPECT_LE(levels.back().mesh.points.size(), 300u);
  EXPECT_GT(levels[levels.size() - 2].mesh.points.size(), 300u);
}

// Two neighbours on the boundary stay for ever: on coarse levels a triangle stands on their edge.
TEST(QuadtreeSequence, KeepsAnglesBetweenSpecialPointsOnRequest) {
  CoarseningOptions options = quadtree_options();
  options.fixed = std::vector<Index>{0, 30, 31, 59, 3540, 3599};
  const auto smallest_boundary_angle = [&] {
    const auto hierarchy = coarsen(uniform_mesh(60), options);
    double smallest = 180;
    for (const Level& level : hierarchy->levels)
      smallest = std::min(smallest, *angle_statistics(level.mesh).boundary_min_deg);
    EXPECT_GT(hierarchy->levels.size(), 4u);
    EXPECT_LT(hierarchy->levels.back().origin.size(), 200u);
    return smallest;
  };
  EXPECT_LT(smallest_boundary_angle(), 3);
  options.limit_by_special_points = true;
  EXPECT_GT(smallest_boundary_angle(), 12);
}

TEST(QuadtreeSequence, GrowsBySeveralOctavesALevelOnRequest) {
  CoarseningOptions options = quadtree_options();
  options.factor = 8;
  const auto thrice = coarsen(uniform_mesh(100), options);
  EXPECT_LT(thrice->levels[1].mesh.points.size(), 300u);
  options.factor = 5;
  EXPECT_EQ(coarsen(uniform_mesh(100), options)->levels[1].origin, thrice->levels[1].origin);
}

TEST(QuadtreeSequence, GivesTheSameLevelsAtEveryScale) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 30, .ny = 20, .hole = 0.05, .seed = 3});
  const auto unit = coarsen(mesh, quadtree_options());
  for (const int exponent : {-1000, -300, 300, 1000}) {
    TriangleMesh scaled = mesh;
    for (Point2& p : scaled.points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    const auto hierarchy = coarsen(scaled, quadtree_options());
    ASSERT_TRUE(hierarchy.ok());
    ASSERT_EQ(hierarchy->levels.size(), unit->levels.size());
    for (std::size_t k = 0; k < unit->levels.size(); ++k)
      EXPECT_EQ(hierarchy->levels[k].origin, unit->levels[k].origin) << exponent;
  }
}

// Crowded beyond what the deepest grid can tell apart, at both ends of a strip.
TEST(QuadtreeSequence, StaysValidWhereTheTreeIsAtItsEnd) {
  TriangleMesh mesh;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j < 2; ++j) {
      const double x = std::ldexp(1.0, i - 60);
      mesh.points.push_back({x, j == 0 ? 0 : x});
    }
  for (Index i = 0; i < 60; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  const auto hierarchy = coarsen(mesh, quadtree_options());
  ASSERT_TRUE(hierarchy.ok());
  ASSERT_GT(hierarchy->levels.size(), 3u);
  for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
    test::MeshChecker checker(hierarchy->levels[k].mesh);
    EXPECT_EQ(checker.check_validity(), std::vector<std::string>()) << "level " << k;
    EXPECT_EQ(checker.check_constrained_delaunay(), std::vector<std::string>()) << "level " << k;
  }
}

}  // namespace
}  // namespace wellspaced
