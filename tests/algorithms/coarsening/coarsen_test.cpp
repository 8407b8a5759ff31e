#include "wellspaced/algorithms/coarsening/coarsen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/mesh_checker.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"

namespace wellspaced {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Nodes = std::vector<Index>;

TriangleMesh small_grid() { return test::grid_mesh({.nx = 12, .ny = 12, .jitter = 0}); }

void expect_error(const TriangleMesh& mesh, const CoarseningOptions& options, ErrorCode code,
                  const Nodes& ids = {}) {
  const auto result = coarsen(mesh, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, code);
  EXPECT_EQ(result.error().ids, ids);
  EXPECT_FALSE(result.error().message.empty());
}

TEST(Coarsen, RefusesOptionsOutOfRange) {
  for (const double value : {1.0, 0.0, -2.0, kNaN, kInfinity}) {
    expect_error(small_grid(), {.beta = value}, ErrorCode::kUsage);
    expect_error(small_grid(), {.factor = value}, ErrorCode::kUsage);
  }
  for (const double value : {-0.1, kNaN, kInfinity})
    expect_error(small_grid(), {.protect = value}, ErrorCode::kUsage);
  expect_error(small_grid(), {.fixed = Nodes{3, 169}}, ErrorCode::kUsage, {169});
}

TEST(Coarsen, RefusesMeshesThatNameWhatIsNotThere) {
  TriangleMesh mesh = small_grid();
  mesh.triangles[5][1] = 169;
  expect_error(mesh, {}, ErrorCode::kInvalidGeometry, {5});
  mesh = small_grid();
  mesh.segments = {{0, 1, 0}, {4, 1000, 0}};
  expect_error(mesh, {}, ErrorCode::kInvalidGeometry, {1});
  mesh = small_grid();
  mesh.points[7].y = kNaN;
  expect_error(mesh, {}, ErrorCode::kInvalidGeometry, {7});
}

// Fuzz: lengths, and spacing with them, were infinite.
TEST(Coarsen, RefusesMeshesWiderThanTheLargestDouble) {
  TriangleMesh mesh = small_grid();
  for (Point2& p : mesh.points) p = {0x1p1019 * (p.x - 6), 0x1p1019 * (p.y - 6)};
  EXPECT_TRUE(coarsen(mesh, {}).ok());
  for (Point2& p : mesh.points) p = {2 * p.x, 2 * p.y};
  expect_error(mesh, {}, ErrorCode::kInvalidGeometry, {});
}

TEST(Coarsen, CompletesTheInput) {
  TriangleMesh mesh = small_grid();
  mesh.segments = {{1, 0, 5}, {20, 21, 6}};
  const auto hierarchy = coarsen(mesh, {.max_levels = 0});
  ASSERT_TRUE(hierarchy.ok());
  ASSERT_EQ(hierarchy->levels.size(), 1u);
  const TriangleMesh& level_0 = hierarchy->levels[0].mesh;
  EXPECT_EQ(level_0.segments.size(), 4 * 12u + 1);
  EXPECT_EQ(level_0.segments[0], (Segment{1, 0, 5}));
  EXPECT_EQ(level_0.segments[1], (Segment{20, 21, 6}));
  EXPECT_EQ(level_0.segments[2].marker, 1);
  EXPECT_EQ(level_0.fixed, (Nodes{0, 1, 12, 20, 21, 156, 168}));
  EXPECT_EQ(hierarchy->levels[0].spacing[0], 0.5);
  EXPECT_EQ(hierarchy->levels[0].origin[7], 7u);
}

TEST(Coarsen, EndsBeforeTheFirstLevelThatDropsNoNode) {
  const auto hierarchy = coarsen(small_grid(), {});
  ASSERT_TRUE(hierarchy.ok());
  EXPECT_EQ(hierarchy->levels.back().origin, (Nodes{0, 12, 156, 168}));
  for (std::size_t k = 1; k < hierarchy->levels.size(); ++k)
    EXPECT_LT(hierarchy->levels[k].origin.size(), hierarchy->levels[k - 1].origin.size());
}

TEST(Coarsen, StopsAtTheLevelsOrNodesAskedFor) {
  EXPECT_EQ(coarsen(small_grid(), {.factor = 2, .max_levels = 2})->levels.size(), 3u);
  EXPECT_EQ(coarsen(small_grid(), {.until_nodes = 168})->levels.size(), 2u);
  EXPECT_EQ(coarsen(small_grid(), {.until_nodes = 169})->levels.size(), 1u);
}

TEST(Coarsen, KeepsMarkersAndFixedPoints) {
  TriangleMesh mesh = small_grid();
  for (Index x = 0; x < 12; ++x) {
    mesh.segments.push_back({x, x + 1, 2});
    mesh.segments.push_back({156 + x, 157 + x, 3});
  }
  for (Index v = 0; v < mesh.points.size(); ++v)
    mesh.point_markers.push_back(static_cast<int>(v % 7));
  const auto hierarchy = coarsen(mesh, {.fixed = Nodes{0, 12, 156, 168, 84}});
  ASSERT_TRUE(hierarchy.ok());
  const Level& last = hierarchy->levels.back();
  EXPECT_EQ(last.origin, (Nodes{0, 12, 84, 156, 168}));
  EXPECT_EQ(last.mesh.fixed, (Nodes{0, 1, 2, 3, 4}));
  EXPECT_EQ(last.mesh.point_markers, (std::vector<int>{0, 5, 0, 2, 0}));
  std::multiset<int> markers;
  for (const Segment& s : last.mesh.segments) markers.insert(s.marker);
  EXPECT_EQ(markers, (std::multiset<int>{1, 1, 2, 3}));
}

TEST(Coarsen, ReturnsTheLevelsThatAreDoneWhenToldToStop) {
  int levels_begun = 0;
  std::string last;
  CoarseningOptions options{.factor = 2};
  options.progress = [&](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(total, 169u);
    EXPECT_LT(done, total);
    levels_begun += phase == "spacing" && last != "spacing";
    last = phase;
    return levels_begun < 3 || phase == "spacing";
  };
  const auto hierarchy = coarsen(small_grid(), options);
  ASSERT_TRUE(hierarchy.ok());
  EXPECT_FALSE(hierarchy->complete);
  EXPECT_EQ(hierarchy->levels.size(), 3u);
}

TEST(Coarsen, TellsThePhasesOfEachLevelInOrder) {
  std::vector<std::string> phases;
  CoarseningOptions options{.max_levels = 2};
  options.progress = [&](std::string_view phase, std::uint64_t, std::uint64_t) {
    if (phases.empty() || phases.back() != phase) phases.emplace_back(phase);
    return true;
  };
  ASSERT_TRUE(coarsen(small_grid(), options).ok());
  EXPECT_EQ(phases,
            (std::vector<std::string>{"prepare", "spacing", "boundary", "select", "triangulate",
                                      "spacing", "boundary", "select", "triangulate", "finish"}));
}

TEST(Coarsen, MeasuresItsWorkOnRequest) {
  const auto hierarchy = coarsen(small_grid(), {.factor = 2, .count_work = true});
  ASSERT_TRUE(hierarchy.ok());
  const auto& work = hierarchy->levels[0].work;
  ASSERT_TRUE(work.has_value());
  EXPECT_EQ(work->path_depth_max, 0u) << "all spacings are equal";
  EXPECT_EQ(work->selection.searches, hierarchy->levels[1].origin.size());
  EXPECT_EQ(work->edge_protection.searches, hierarchy->levels[1].mesh.segments.size());
  EXPECT_FALSE(hierarchy->levels.back().work.has_value());
  EXPECT_FALSE(coarsen(small_grid(), {})->levels[0].work.has_value());
}

TEST(Coarsen, GivesTheSameLevelsAtEveryScale) {
  const auto unit = coarsen(test::grid_mesh({.nx = 15, .ny = 15}), {.factor = 3});
  for (const int exponent : {-1000, -500, 500, 900}) {
    TriangleMesh mesh = test::grid_mesh({.nx = 15, .ny = 15});
    for (Point2& p : mesh.points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    const auto scaled = coarsen(mesh, {.factor = 3});
    ASSERT_TRUE(scaled.ok());
    ASSERT_EQ(scaled->levels.size(), unit->levels.size());
    for (std::size_t k = 0; k < unit->levels.size(); ++k)
      EXPECT_EQ(scaled->levels[k].origin, unit->levels[k].origin) << "level " << k;
  }
}

TEST(Coarsen, KeepsIsolatedPointsAndDanglingSegments) {
  TriangleMesh mesh = small_grid();
  mesh.points.insert(mesh.points.end(), {{20, 5}, {-3, -3}, {-2, -3}, {-1, -3}, {-1, -2}});
  mesh.segments = {{170, 171, 4}, {171, 172, 4}, {172, 173, 4}};
  const auto hierarchy = coarsen(mesh, {});
  ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
  const Level& last = hierarchy->levels.back();
  EXPECT_EQ(last.origin, (Nodes{0, 12, 156, 168, 169, 170, 172, 173}));
  EXPECT_EQ(last.mesh.segments[4], (Segment{5, 6, 4}));
  EXPECT_EQ(last.mesh.segments[5], (Segment{6, 7, 4}));
  EXPECT_EQ(last.mesh.triangles.size(), 2u);
}

TEST(Coarsen, OfDegenerateInputsIsTheInput) {
  EXPECT_EQ(coarsen(TriangleMesh{}, {})->levels.size(), 1u);
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(coarsen(mesh, {})->levels.size(), 1u);
  mesh.triangles.clear();
  EXPECT_EQ(coarsen(mesh, {.method = CoarseningMethod::kMis})->levels.size(), 1u);
}

// ---- Random domains

struct RandomCase {
  TriangleMesh mesh;
  CoarseningOptions options;
};

void bend(TriangleMesh& mesh, Random& random) {
  const double k = random.uniform(0, 1.5);
  for (Point2& p : mesh.points) p = {p.x * (1 + 0.03 * k * p.x), p.y + k * p.x * (9 - p.x) / 9};
}

RandomCase random_case(std::uint64_t seed) {
  Random random(seed);
  RandomCase c;
  c.mesh = test::grid_mesh({.nx = static_cast<Index>(4 + random.below(24)),
                            .ny = static_cast<Index>(4 + random.below(24)),
                            .jitter = random.below(3) == 0 ? 0 : 0.24,
                            .hole = random.uniform(0, 0.35),
                            .seed = seed});
  bend(c.mesh, random);
  if (random.below(3) == 0)
    for (const auto& t : c.mesh.triangles)
      if (random.below(6) == 0) c.mesh.segments.push_back({t[0], t[1], 2});
  constexpr CoarseningMethod kMethods[] = {CoarseningMethod::kFunction, CoarseningMethod::kMis,
                                           CoarseningMethod::kQuadtree,
                                           CoarseningMethod::kRefinement};
  c.options = theorem_options(kMethods[random.below(4)]);
  c.options.ratio = random.uniform(1.3, 6);
  if (random.below(2) == 0 && c.options.method == CoarseningMethod::kRefinement)
    c.options.targets = {c.mesh.points.size() / 2, c.mesh.points.size() / 7 + 1, 5, 1};
  c.options.beta = random.uniform(1.1, 26);
  c.options.factor = random.uniform(1.5, 11);
  c.options.seed = seed;
  return c;
}

void expect_valid_levels(const Hierarchy& hierarchy) {
  const test::MeshShape shape = test::MeshChecker(hierarchy.levels[0].mesh).shape();
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    test::MeshChecker checker(hierarchy.levels[k].mesh);
    ASSERT_EQ(checker.check_validity(), std::vector<std::string>()) << "level " << k;
    ASSERT_EQ(checker.check_constrained_delaunay(), std::vector<std::string>()) << "level " << k;
    ASSERT_EQ(checker.shape(), shape) << "level " << k;
  }
}

// Cells are left out at random: hundreds of holes, and curves that meet in nodes.
TEST(Coarsen, KeepsAllHolesAndComponentsOfRandomDomains) {
  std::size_t reinstated = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const RandomCase c = random_case(seed);
    const auto hierarchy = coarsen(c.mesh, c.options);
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    SCOPED_TRACE(seed);
    expect_valid_levels(*hierarchy);
    for (const Level& level : hierarchy->levels) reinstated += level.reinstated;
  }
  EXPECT_GT(reinstated, 100u) << "the boundaries were too easy";
}

TEST(Coarsen, KeepsRandomSlitsOpen) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 16, .seed = seed});
    for (const Index row : {3, 7, 11}) {
      const Index x0 = random.below(3) == 0 ? 0 : static_cast<Index>(1 + random.below(10));
      test::cut_slit(mesh, 21, row, x0, static_cast<Index>(x0 + 2 + random.below(8)));
    }
    bend(mesh, random);
    CoarseningOptions options = random_case(seed).options;
    const auto hierarchy = coarsen(mesh, options);
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    SCOPED_TRACE(seed);
    expect_valid_levels(*hierarchy);
  }
}

// With no special points, holes and whole components may go, but no level is invalid.
TEST(Coarsen, StaysValidWithoutSpecialPoints) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomCase c = random_case(seed);
    c.mesh.segments.clear();
    c.options.fixed = Nodes{};
    const auto hierarchy = coarsen(c.mesh, c.options);
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
      const TriangleMesh& mesh = hierarchy->levels[k].mesh;
      if (mesh.triangles.empty()) continue;
      test::MeshChecker checker(mesh);
      EXPECT_EQ(checker.check_validity(), std::vector<std::string>()) << seed << ", level " << k;
    }
  }
}

TEST(Coarsen, NeverHangsOrCrashesOnTrianglesThatAreNoMesh) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    TriangleMesh mesh;
    const auto nodes = 3 + random.below(20);
    for (std::uint64_t i = 0; i < nodes; ++i)
      mesh.points.push_back(
          {static_cast<double>(random.below(6)), static_cast<double>(random.below(6))});
    for (int t = 0; t < 30; ++t) {
      const auto pick = [&] { return static_cast<Index>(random.below(nodes)); };
      mesh.triangles.push_back({pick(), pick(), pick()});
      if (t % 3 == 0) mesh.segments.push_back({pick(), pick(), 1});
    }
    CoarseningOptions options = random_case(seed).options;
    options.targets.clear();
    const auto hierarchy = coarsen(mesh, options);
    if (!hierarchy.ok()) {
      EXPECT_EQ(hierarchy.error().code, ErrorCode::kInvalidGeometry);
    } else {
      EXPECT_LE(hierarchy->levels.size(), nodes);
    }
  }
}

TEST(Coarsen, KeepsTheAreaOfTheDomainOnRequest) {
  const TriangleMesh disk = generate_graded_mesh(GradedDomain::kAnnulus, {.nodes = 3000}).value();
  const auto area_of_level = [](const Level& level) {
    double twice = 0;
    for (const auto& [a, b, c] : level.mesh.triangles) {
      const Point2 p = level.mesh.points[a], q = level.mesh.points[b], r = level.mesh.points[c];
      twice += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    return twice / 2;
  };
  const auto worst_drift = [&](const CoarseningOptions& options) {
    const Hierarchy hierarchy = coarsen(disk, options).value();
    EXPECT_GE(hierarchy.levels.size(), 3u);
    double worst = 0;
    for (const Level& level : hierarchy.levels)
      worst =
          std::max(worst, std::fabs(area_of_level(level) / area_of_level(hierarchy.levels[0]) - 1));
    return worst;
  };
  EXPECT_GT(worst_drift({}), 0.1);
  for (const double drift : {0.05, 0.02, 0.001})
    EXPECT_LE(worst_drift({.keep_boundary = drift}), drift * (1 + 1e-12));
}

}  // namespace
}  // namespace wellspaced
