// The three multilevel schemes, in all metrics and by all functions.
#include "wellspaced/algorithms/coarsening/schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/data_files.hpp"
#include "tests/support/grid_meshes.hpp"
#include "tests/support/mesh_checker.hpp"
#include "tests/support/slit_meshes.hpp"
#include "wellspaced/algorithms/coarsening/boundary_description.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/algorithms/spacing/spacing_function.hpp"
#include "wellspaced/kernel/distance.hpp"

namespace wellspaced {
namespace {

constexpr CoarseningMethod kMethods[] = {CoarseningMethod::kFunction, CoarseningMethod::kThreshold,
                                         CoarseningMethod::kQuasiUniform};
constexpr CoarseningScheme kSchemes[] = {CoarseningScheme::kFineToCoarse,
                                         CoarseningScheme::kFromFinest,
                                         CoarseningScheme::kCoarseToFine};
constexpr SpacingMetric kMetrics[] = {SpacingMetric::kGraph, SpacingMetric::kEuclidean,
                                      SpacingMetric::kGeodesic};

std::string describe(const CoarseningOptions& options) {
  return "method " + std::to_string(static_cast<int>(options.method)) + ", scheme " +
         std::to_string(static_cast<int>(options.scheme)) + ", metric " +
         std::to_string(static_cast<int>(options.metric));
}

// All combinations, with factors that give several levels.
std::vector<CoarseningOptions> all_options() {
  std::vector<CoarseningOptions> all;
  for (const auto method : kMethods)
    for (const auto scheme : kSchemes)
      for (const auto metric : kMetrics) {
        CoarseningOptions options = theorem_options(method);
        options.scheme = scheme;
        options.metric = metric;
        if (method != CoarseningMethod::kThreshold) options.factor = 2;
        if (method == CoarseningMethod::kThreshold) options.beta = 3, options.factor = 4;
        if (method == CoarseningMethod::kFunction) options.beta = 6;
        all.push_back(options);
      }
  return all;
}

bool is_nested(const Level& finer, const Level& level) {
  return std::ranges::includes(finer.origin, level.origin);
}

void expect_valid(const Hierarchy& hierarchy, const CoarseningOptions& options) {
  const Level& finest = hierarchy.levels[0];
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    SCOPED_TRACE("level " + std::to_string(k));
    const Level &level = hierarchy.levels[k], &finer = hierarchy.levels[k - 1];
    test::MeshChecker checker(level.mesh);
    EXPECT_EQ(checker.check_validity(), std::vector<std::string>());
    EXPECT_EQ(checker.check_constrained_delaunay(), std::vector<std::string>());
    EXPECT_LT(level.origin.size(), finer.origin.size());
    EXPECT_TRUE(std::ranges::includes(level.origin, finest.mesh.fixed));
    if (options.scheme != CoarseningScheme::kFromFinest) EXPECT_TRUE(is_nested(finer, level));
    for (Index v = 0; v < level.origin.size(); ++v) {
      ASSERT_EQ(level.mesh.points[v], finest.mesh.points[level.origin[v]]);
      if (level.parent[v] != kNoIndex)
        ASSERT_EQ(finer.origin[level.parent[v]], level.origin[v]);
      else
        ASSERT_FALSE(std::ranges::binary_search(finer.origin, level.origin[v]));
    }
  }
}

TEST(Schemes, GiveValidMeshesInEveryMetricByEveryFunction) {
  TriangleMesh mesh = test::grid_mesh({.nx = 24, .ny = 20, .hole = 0.02, .seed = 3});
  TriangleMesh slit = test::grid_mesh({.nx = 24, .ny = 20, .seed = 4});
  test::cut_slit(slit, 25, 10, 5, 18);
  for (const TriangleMesh& input : {mesh, slit}) {
    for (const CoarseningOptions& options : all_options()) {
      SCOPED_TRACE(describe(options));
      const auto hierarchy = coarsen(input, options);
      ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
      EXPECT_GT(hierarchy->levels.size(), 2u);
      expect_valid(*hierarchy, options);
    }
  }
}

TEST(Schemes, AreDeterministicAndFollowTheSeed) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 20, .ny = 20, .seed = 5});
  for (CoarseningOptions options : all_options()) {
    options.seed = 7;
    const auto once = coarsen(mesh, options), again = coarsen(mesh, options);
    options.seed = 8;
    const auto other = coarsen(mesh, options);
    ASSERT_EQ(once->levels.size(), again->levels.size());
    for (std::size_t k = 0; k < once->levels.size(); ++k)
      EXPECT_EQ(once->levels[k].mesh.triangles, again->levels[k].mesh.triangles);
    EXPECT_NE(once->levels[1].origin, other->levels[1].origin) << describe(options);
  }
}

// C_i = C^i on the function of M_0, in the three metrics (section 5.3.4).
TEST(Schemes, FromTheFinestUsePowersOfTheFactorOnTheInputsFunction) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 18, .ny = 18, .hole = 0.05, .seed = 6});
  const Graph graph = mesh_graph(mesh);
  const Visibility visibility(mesh);
  const std::vector<double> half_edge = mesh_spacing(graph);
  const std::vector<double> nn = nearest_neighbor_spacing(mesh.points);
  for (const auto scheme : {CoarseningScheme::kFromFinest, CoarseningScheme::kCoarseToFine}) {
    for (const auto metric : kMetrics) {
      CoarseningOptions options;
      options.beta = 6;
      options.factor = 2;
      options.scheme = scheme;
      options.metric = metric;
      const auto hierarchy = coarsen(mesh, options);
      const std::vector<double>& g = hierarchy->levels[0].spacing;
      for (Index v = 0; v < mesh.points.size(); ++v)
        ASSERT_EQ(g[v], metric == SpacingMetric::kGraph ? half_edge[v] : 0.5 * nn[v]);
      for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
        const double factor = 6 * std::ldexp(1, static_cast<int>(k));
        const std::vector<double> f =
            metric == SpacingMetric::kGraph ? coarsened_spacing(graph, g, factor)
            : metric == SpacingMetric::kEuclidean
                ? euclidean_coarsened_spacing(mesh.points, g, factor)
                : geodesic_coarsened_spacing(visibility, graph, g, factor);
        const Level& level = hierarchy->levels[k];
        for (Index v = 0; v < level.origin.size(); ++v)
          ASSERT_EQ(level.spacing[v], f[level.origin[v]]) << describe(options) << " level " << k;
      }
    }
  }
}

// Definition 5.3.4: no two nodes that see each other conflict, special points and those taken back
// for the boundary apart; and Lemma 5.3.6 leaves the set maximal: a node that is out conflicts with
// one that is in, or is too near to a boundary edge.
TEST(Schemes, SelectMaximalSetsWithoutConflictsInTheEuclideanMetric) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 22, .ny = 22, .jitter = 0, .seed = 7});
  const Visibility visibility(mesh);
  for (const auto scheme : {CoarseningScheme::kFromFinest, CoarseningScheme::kCoarseToFine}) {
    CoarseningOptions options;
    options.beta = 5;
    options.factor = 2;
    options.protect = 0;
    options.scheme = scheme;
    options.metric = SpacingMetric::kEuclidean;
    const auto hierarchy = coarsen(mesh, options);
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
      const Level& level = hierarchy->levels[k];
      const auto f = euclidean_coarsened_spacing(mesh.points, hierarchy->levels[0].spacing,
                                                 5 * std::ldexp(1, static_cast<int>(k)));
      const auto conflict = [&](Index a, Index b) {
        return f[a] + f[b] > 5 * distance(mesh.points[a], mesh.points[b]);
      };
      const auto& fixed = hierarchy->levels[0].mesh.fixed;
      for (const Index a : level.origin)
        for (const Index b : level.origin)
          if (a < b &&
              !(std::ranges::binary_search(fixed, a) && std::ranges::binary_search(fixed, b)))
            ASSERT_FALSE(conflict(a, b) && visibility.sees(a, b)) << a << ' ' << b;
      for (Index v = 0; v < mesh.points.size(); ++v) {
        const bool is_in = std::ranges::binary_search(level.origin, v);
        const bool is_out =
            std::ranges::any_of(level.origin, [&](Index w) { return conflict(v, w); });
        ASSERT_TRUE(is_in || is_out) << v;
      }
    }
  }
}

TEST(Schemes, TakeASpacingOfTheUsers) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 16, .ny = 16, .seed = 8});
  std::vector<double> spacing;
  for (const Point2 p : mesh.points) spacing.push_back(p.x < 8 ? 0.25 : 2);
  const auto hierarchy = coarsen(mesh, {.factor = 1.5, .spacing = spacing, .max_levels = 1});
  ASSERT_TRUE(hierarchy.ok());
  EXPECT_EQ(hierarchy->levels[0].spacing, spacing);
  const auto& points = hierarchy->levels[1].mesh.points;
  const auto left = std::ranges::count_if(points, [](Point2 p) { return p.x < 8; });
  EXPECT_GT(left, 60);
  EXPECT_LT(static_cast<std::ptrdiff_t>(points.size()) - left, left);
  spacing[5] = 0;
  EXPECT_EQ(coarsen(mesh, {.spacing = spacing}).error().ids, std::vector<Index>{5});
  EXPECT_EQ(coarsen(mesh, {.spacing = std::vector<double>(3, 1)}).error().code, ErrorCode::kUsage);
}

// A function of the place takes the place of the mesh's own spacing, whatever it is then coarsened
// by.
TEST(Schemes, CoarsenAFunctionOfTheUsersByEveryMethodAndMetric) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 24, .ny = 24, .seed = 8});
  const SpacingFunction g = [](Point2 p) { return 0.3 + 0.05 * p.x; };
  std::vector<CoarseningOptions> all = all_options();
  all.push_back(theorem_options(CoarseningMethod::kQuadtree));
  for (CoarseningOptions options : all) {
    SCOPED_TRACE(describe(options));
    const auto own = coarsen(mesh, options);
    options.spacing = sampled(g, mesh.points);
    const auto hierarchy = coarsen(mesh, options);
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    ASSERT_GT(hierarchy->levels.size(), 1u);
    EXPECT_EQ(hierarchy->levels[0].spacing, *options.spacing);
    EXPECT_NE(hierarchy->levels[1].origin, own->levels[1].origin);
    expect_valid(*hierarchy, options);
    if (options.method == CoarseningMethod::kQuasiUniform) continue;  // asks for its least alone
    const auto& points = hierarchy->levels[1].mesh.points;
    const auto left = std::ranges::count_if(points, [](Point2 p) { return p.x < 12; });
    EXPECT_GT(left, static_cast<std::ptrdiff_t>(points.size()) - left);
  }
}

TEST(Schemes, ConsiderNodesByPriority) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 16, .ny = 16, .jitter = 0, .seed = 9});
  const Index centre = 8 * 17 + 8;
  std::vector<double> priority(mesh.points.size(), 0);
  priority[centre] = 1;
  const auto hierarchy = coarsen(
      mesh,
      {.factor = 8, .order = SelectionOrder::kPriority, .priority = priority, .max_levels = 1});
  EXPECT_TRUE(std::ranges::binary_search(hierarchy->levels[1].origin, centre));
}

TEST(Schemes, OfIndependentSetsExistFineToCoarseAlone) {
  CoarseningOptions options;
  options.method = CoarseningMethod::kMis;
  options.scheme = CoarseningScheme::kCoarseToFine;
  EXPECT_EQ(coarsen(test::grid_mesh({}), options).error().code, ErrorCode::kUsage);
}

// Two nodes close together and fixed, a grid far coarser: the first thresholds drop nothing.
TEST(Schemes, RaiseAThresholdThatDropsNoNode) {
  TriangleMesh mesh = test::grid_mesh({.nx = 12, .ny = 12, .jitter = 0, .seed = 12});
  mesh.points[1].x = 0x1p-20;
  for (const auto method : {CoarseningMethod::kThreshold, CoarseningMethod::kQuasiUniform}) {
    for (const auto scheme : kSchemes) {
      CoarseningOptions options = theorem_options(method);
      options.scheme = scheme;
      options.fixed = std::vector<Index>{0, 1, 12, 156, 168};
      const auto hierarchy = coarsen(mesh, options);
      ASSERT_TRUE(hierarchy.ok());
      EXPECT_GT(hierarchy->levels.size(), 1u) << describe(options);
      EXPECT_LE(hierarchy->levels.back().origin.size(), 6u) << describe(options);
      expect_valid(*hierarchy, options);
    }
  }
}

TEST(Schemes, StopWhereTheyAreTold) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 30, .ny = 30, .seed = 10});
  for (const auto scheme : kSchemes) {
    CoarseningOptions options;
    options.beta = 4;
    options.factor = 2;
    options.scheme = scheme;
    options.until_nodes = 100;
    const auto hierarchy = coarsen(mesh, options);
    EXPECT_LE(hierarchy->levels.back().origin.size(), 100u);
    EXPECT_GT(hierarchy->levels[hierarchy->levels.size() - 2].origin.size(), 100u);
    options.until_nodes = 0;
    options.max_levels = 2;
    EXPECT_EQ(coarsen(mesh, options)->levels.size(), 3u);
    int calls = 0;
    options.progress = [&](std::string_view, std::uint64_t, std::uint64_t) { return ++calls < 6; };
    EXPECT_FALSE(coarsen(mesh, options)->complete);
  }
}

// ---- Coarsening that keeps the boundary

TEST(LimitByBoundary, KeepsTheBoundaryDescriptionAndTheSpacingBelowItsFeatureSize) {
  TriangleMesh mesh = test::grid_mesh({.nx = 48, .ny = 32, .jitter = 0, .seed = 11});
  for (const CoarseningScheme scheme : kSchemes) {
    CoarseningOptions options;
    options.metric = SpacingMetric::kEuclidean;
    options.scheme = scheme;
    options.beta = 6;
    options.factor = 2;
    options.limit_by_boundary = true;
    const auto hierarchy = coarsen(mesh, options);
    ASSERT_TRUE(hierarchy.ok());
    const BoundaryDescription b = boundary_description(hierarchy->levels[0].mesh);
    EXPECT_EQ(b.graph.segments.size(), 4u);
    const auto lfs = LocalFeatureSize::build(b.graph);
    ASSERT_GT(hierarchy->levels.size(), 2u);
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
      const Level& level = hierarchy->levels[k];
      EXPECT_EQ(boundary_description(level.mesh).graph.points, b.graph.points);
      EXPECT_EQ(boundary_description(level.mesh).graph.segments, b.graph.segments);
      for (Index v = 0; v < level.origin.size(); ++v)
        EXPECT_LE(level.spacing[v], lfs->at(level.mesh.points[v]));
    }
  }
}

TEST(LimitBySpecialPoints, KeepsTheSpacingAroundThemBelowTheirDistance) {
  const TriangleMesh mesh = test::grid_mesh({.nx = 48, .ny = 32, .jitter = 0, .seed = 11});
  for (const CoarseningScheme scheme : kSchemes) {
    CoarseningOptions options;
    options.scheme = scheme;
    options.beta = 6;
    options.factor = 2;
    options.fixed = std::vector<Index>{0, 20, 21, 48, 49 * 32, 49 * 33 - 1};
    const auto without = coarsen(mesh, options);
    options.limit_by_special_points = true;
    const auto hierarchy = coarsen(mesh, options);
    ASSERT_GT(hierarchy->levels.size(), 3u);
    EXPECT_LT(without->levels.back().origin.size(), hierarchy->levels.back().origin.size());
    for (const Level& level : hierarchy->levels)
      for (Index v = 0; v < level.origin.size(); ++v)
        for (const Index pin : {20, 21})
          EXPECT_LE(level.spacing[v],
                    (3 + distance(mesh.points[pin], level.mesh.points[v])) * (1 + 1e-12));
    expect_valid(*hierarchy, options);
  }
  CoarseningOptions options;
  options.method = CoarseningMethod::kMis;
  options.limit_by_special_points = true;
  EXPECT_EQ(coarsen(mesh, options).error().code, ErrorCode::kUsage);
}

TEST(BoundaryDescription, JoinsStraightChainsOfOneMarker) {
  TriangleMesh mesh = test::grid_mesh({.nx = 4, .ny = 3, .jitter = 0});
  const auto hierarchy = coarsen(mesh, {.max_levels = 0});
  mesh = hierarchy->levels[0].mesh;
  EXPECT_EQ(boundary_description(mesh).vertices, (std::vector<Index>{0, 4, 15, 19}));
  mesh.segments[0].marker = 9;  // splits the side that it lies on
  EXPECT_GT(boundary_description(mesh).vertices.size(), 4u);
  mesh.points.push_back({9, 9});  // an isolated point belongs to B
  EXPECT_EQ(boundary_description(mesh).vertices.back(), 20u);
}

// ---- Real meshes

struct RealCase {
  const char* name;
  CoarseningScheme scheme;
  SpacingMetric metric;
};

TEST(Schemes, GiveValidSequencesOfRealMeshes) {
  using enum CoarseningScheme;
  using enum SpacingMetric;
  for (const auto& [name, scheme, metric] :
       {RealCase{"thesis/airfoil1", kCoarseToFine, kGraph},
        RealCase{"thesis/airfoil1", kFromFinest, kEuclidean},
        RealCase{"thesis/crack_slit", kCoarseToFine, kGeodesic}}) {
    const auto mesh = test::data_mesh(name);
    if (!mesh) GTEST_SKIP() << "no " << test::data_path(name);
    CoarseningOptions options;
    options.scheme = scheme;
    options.metric = metric;
    SCOPED_TRACE(std::string(name) + ' ' + describe(options));
    const auto hierarchy = coarsen(*mesh, options);
    ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
    EXPECT_GT(hierarchy->levels.size(), 3u);
    expect_valid(*hierarchy, options);
  }
}

// Two special points cannot hold up a domain: the sequence ends before it is gone.
TEST(Schemes, EndBeforeALevelWithoutTriangles) {
  std::vector<CoarseningOptions> all = all_options();
  all.push_back(theorem_options(CoarseningMethod::kMis));
  all.push_back(theorem_options(CoarseningMethod::kQuadtree));
  for (CoarseningOptions options : all) {
    options.fixed = std::vector<Index>{0, 20};
    const auto hierarchy = coarsen(test::grid_mesh({.nx = 20, .ny = 20, .seed = 3}), options);
    ASSERT_TRUE(hierarchy.ok());
    EXPECT_GT(hierarchy->levels.size(), 1u) << describe(options);
    for (const Level& level : hierarchy->levels)
      EXPECT_FALSE(level.mesh.triangles.empty()) << describe(options);
  }
}

}  // namespace
}  // namespace wellspaced
