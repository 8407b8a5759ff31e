#include "wellspaced/algorithms/coarsening/quality/refinement_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/data_files.hpp"
#include "tests/support/grid_meshes.hpp"
#include "tests/support/mesh_checker.hpp"
#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"

namespace wellspaced {
namespace {

CoarseningOptions towards(std::vector<std::size_t> targets, std::uint64_t seed = 1) {
  CoarseningOptions options = quality_profile();
  options.targets = std::move(targets);
  options.seed = seed;
  return options;
}

double smallest_angle(const LevelStatistics& level) {
  return std::min(level.angles.interior_min_deg.value_or(180),
                  level.angles.boundary_min_deg.value_or(180));
}

void expect_valid(const Hierarchy& hierarchy) {
  const test::MeshShape shape = test::MeshChecker(hierarchy.levels[0].mesh).shape();
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    SCOPED_TRACE("level " + std::to_string(k));
    const Level& level = hierarchy.levels[k];
    test::MeshChecker checker(level.mesh);
    EXPECT_EQ(checker.check_validity(), std::vector<std::string>());
    EXPECT_EQ(checker.check_constrained_delaunay(), std::vector<std::string>());
    EXPECT_EQ(checker.shape(), shape);
    for (Index v = 0; v < level.parent.size(); ++v)
      ASSERT_EQ(level.mesh.points[v], hierarchy.levels[k - 1].mesh.points.at(level.parent[v]));
  }
}

TEST(CoarsenByRefinement, MeetsSizesAndAnglesOnGradedDomains) {
  for (const GradedDomain domain :
       {GradedDomain::kAirfoil, GradedDomain::kAnnulus, GradedDomain::kCrack}) {
    const TriangleMesh mesh = generate_graded_mesh(domain, {.nodes = 3000}).value();
    const std::vector<std::size_t> targets = {1100, 400, 150};
    const auto hierarchy = coarsen(mesh, towards(targets));
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    ASSERT_EQ(hierarchy->levels.size(), 4u);
    expect_valid(*hierarchy);
    const auto rows = hierarchy_statistics(*hierarchy);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const auto target = static_cast<double>(targets[k - 1]);
      EXPECT_NEAR(static_cast<double>(rows[k].nodes), target, 0.03 * target);
      EXPECT_GE(smallest_angle(rows[k]), 20) << "level " << k;
    }
  }
}

TEST(CoarsenByRefinement, GoesDownByTheRatioAsFarAsAnglesCanBeKept) {
  const TriangleMesh mesh = generate_graded_mesh(GradedDomain::kAirfoil, {.nodes = 3000}).value();
  CoarseningOptions options = quality_profile();
  options.ratio = 4;
  const auto hierarchy = coarsen(mesh, options).value();
  ASSERT_GE(hierarchy.levels.size(), 3u);
  const auto rows = hierarchy_statistics(hierarchy);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_NEAR(static_cast<double>(rows[k - 1].nodes) / static_cast<double>(rows[k].nodes), 4,
                0.2);
    EXPECT_GE(smallest_angle(rows[k]), 20);
  }
  options.until_nodes = 500;
  EXPECT_EQ(coarsen(mesh, options)->levels.size(), 2u);
}

TEST(CoarsenByRefinement, IsIndependentByTheSpacingItReports) {
  const TriangleMesh mesh = generate_graded_mesh(GradedDomain::kCrack, {.nodes = 2000}).value();
  const CoarseningOptions options = towards({700, 200, 60});
  const auto hierarchy = coarsen(mesh, options).value();
  const Graph graph = mesh_graph(mesh);
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    const SelectionCheck check = check_selection(graph, hierarchy.levels[k], options.beta);
    EXPECT_EQ(check.conflicts, 0u);
    EXPECT_LT(check.uncovered_max, 2.5);
  }
}

TEST(CoarsenByRefinement, DependsOnTheSeedAndOnNothingElse) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 30, .ny = 20, .jitter = 0.2});
  const auto one = coarsen(mesh, towards({200, 60}, 1)).value();
  EXPECT_EQ(one.levels[1].origin, coarsen(mesh, towards({60, 200}, 1))->levels[1].origin);
  EXPECT_NE(one.levels[1].origin, coarsen(mesh, towards({200, 60}, 2))->levels[1].origin);
}

TEST(CoarsenByRefinement, KeepsLoopsThatGivenSpecialPointsForget) {
  TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 20, .jitter = 0.1});
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](Index v) {
      return mesh.points[v].x > 7.5 && mesh.points[v].x < 12.5 && mesh.points[v].y > 7.5 &&
             mesh.points[v].y < 12.5;
    });
  });
  CoarseningOptions options = towards({150, 40});
  options.fixed = std::vector<Index>{3};
  const auto hierarchy = coarsen(mesh, options).value();
  expect_valid(hierarchy);
  EXPECT_TRUE(std::ranges::binary_search(hierarchy.levels.back().origin, Index{3}));
}

TEST(CoarsenByRefinement, StopsWhenCancelledWithWholeLevels) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 40, .ny = 40, .jitter = 0.2});
  for (int last : {0, 1, 2, 3, 5, 8, 13, 40}) {
    CoarseningOptions options = towards({500, 150, 50});
    int calls = 0;
    options.progress = [&](std::string_view phase, std::uint64_t, std::uint64_t) {
      return phase == "prepare" || calls++ < last;
    };
    const auto hierarchy = coarsen(mesh, options);
    ASSERT_TRUE(hierarchy.ok());
    EXPECT_EQ(hierarchy->complete, calls <= last);
    expect_valid(*hierarchy);
  }
}

TEST(CoarsenByRefinement, RefusesWhatItCannotDo) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 4, .ny = 4});
  const auto refused = [&](auto change) {
    CoarseningOptions options = towards({10});
    change(options);
    const auto result = coarsen(mesh, options);
    return !result.ok() && result.error().code == ErrorCode::kUsage;
  };
  EXPECT_TRUE(refused([](auto& o) { o.targets = {0}; }));
  EXPECT_TRUE(refused([](auto& o) { o.targets = {25}; }));
  EXPECT_TRUE(refused([](auto& o) { o.ratio = 1; }));
  EXPECT_TRUE(refused([](auto& o) { o.angle_deg = 31; }));
  EXPECT_TRUE(refused([](auto& o) { o.angle_deg = 0; }));
  EXPECT_TRUE(refused([](auto& o) { o.scheme = CoarseningScheme::kFineToCoarse; }));
  EXPECT_TRUE(refused([](auto& o) { o.method = CoarseningMethod::kFunction; }));
  EXPECT_FALSE(refused([](auto&) {}));
}

TEST(CoarsenByRefinement, BearsExtremeCoordinatesAndMeshesWithoutTriangles) {
  TriangleMesh points;
  points.points = {{0, 0}, {1, 0}, {5, 0}};
  EXPECT_EQ(coarsen(points, quality_profile())->levels.size(), 1u);
  for (const double scale : {0x1p-1040, 0x1p-400, 0x1p400, 0x1p1000}) {
    TriangleMesh mesh = test::grid_mesh({.nx = 12, .ny = 12, .jitter = 0.2});
    for (Point2& p : mesh.points) p = {p.x * scale, p.y * scale};
    const auto hierarchy = coarsen(mesh, towards({60, 20}));
    ASSERT_TRUE(hierarchy.ok());
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k)
      EXPECT_EQ(test::MeshChecker(hierarchy->levels[k].mesh).check_validity(),
                std::vector<std::string>());
  }
}

// ---- Real meshes, with the sizes of the thesis' levels

struct RealCase {
  const char* mesh;
  std::vector<std::size_t> targets;
  std::size_t least_nodes;  // of the levels that can have their angles
};

void PrintTo(const RealCase& c, std::ostream* out) { *out << c.mesh; }

class RealMeshesByRefinement : public testing::TestWithParam<RealCase> {};

TEST_P(RealMeshesByRefinement, KeepTheirAnglesToTheEnd) {
  const auto& [name, targets, least_nodes] = GetParam();
  const auto mesh = test::data_mesh(name);
  if (!mesh) GTEST_SKIP() << "no " << test::data_path(name);
  for (const std::uint64_t seed : {1, 2}) {
    const auto hierarchy = coarsen(*mesh, towards(targets, seed));
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    expect_valid(*hierarchy);
    const auto rows = hierarchy_statistics(*hierarchy);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      if (rows[k].nodes < least_nodes) continue;
      const auto target = static_cast<double>(targets[k - 1]);
      EXPECT_NEAR(static_cast<double>(rows[k].nodes), target, 0.03 * target);
      EXPECT_GE(smallest_angle(rows[k]), 20) << "level " << k << ", seed " << seed;
      EXPECT_LE(rows[k].intersection->max, 40u) << "level " << k << ", seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Thesis, RealMeshesByRefinement,
    testing::Values(RealCase{"thesis/airfoil1", {1586, 463, 57, 29}, 87},
                    RealCase{"thesis/airfoil3_original", {2743, 1215, 526, 188, 28, 18}, 188},
                    RealCase{"thesis/crack_float32", {3629, 2361, 1268, 435, 69, 5, 4}, 50}));

// Triangles with an angle below 20 degrees.
std::size_t thin_triangles(const TriangleMesh& mesh) {
  constexpr double kCosine20 = 0.93969262078590838405;
  const auto is_thin = [&](const std::array<Index, 3>& t) {
    for (int i = 0; i < 3; ++i) {
      const Point2 a = mesh.points[t[i]], b = mesh.points[t[(i + 1) % 3]],
                   c = mesh.points[t[(i + 2) % 3]];
      const double dot = (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
      if (dot > kCosine20 * std::hypot(b.x - a.x, b.y - a.y) * std::hypot(c.x - a.x, c.y - a.y))
        return true;
    }
    return false;
  };
  return static_cast<std::size_t>(std::ranges::count_if(mesh.triangles, is_thin));
}

class CoastsByRefinement : public testing::TestWithParam<const char*> {};

TEST_P(CoastsByRefinement, HaveFewThinTrianglesBeyondThoseOfTheInput) {
  const auto mesh = test::data_mesh(GetParam());
  if (!mesh) GTEST_SKIP() << "no " << test::data_path(GetParam());
  const auto hierarchy = coarsen(*mesh, quality_profile()).value();
  expect_valid(hierarchy);
  ASSERT_GT(hierarchy.levels.size(), 2u);
  const std::size_t allowed = thin_triangles(*mesh);
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    const TriangleMesh& level = hierarchy.levels[k].mesh;
    EXPECT_LE(thin_triangles(level), allowed + (level.triangles.size() + 199) / 200) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Graded, CoastsByRefinement,
                         testing::Values("graded/su2_naca0012_inv", "graded/adcirc_shinnecock",
                                         "graded/thetis_north_sea_demo", "thesis/crack_slit"));

}  // namespace
}  // namespace wellspaced
