// What chapters 2, 5, 6 and 7 prove about coarsening, as corrected in the errata: hypotheses
// checked, both sides measured. Gaps are measured by tests/support/measured_gaps.hpp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/data_files.hpp"
#include "tests/support/measured_gaps.hpp"
#include "wellspaced/algorithms/coarsening/boundary_description.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/spacing/dilation.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/graph_spacing.hpp"
#include "wellspaced/algorithms/spacing/local_feature_size.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/algorithms/spacing/threshold_spacing.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::Bracket;
using test::ConeFunction;

// ---- Meshes of the unit square

TriangleMesh square_mesh(std::vector<Point2> points) {
  Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  for (const Point2 p : points)
    if (std::ranges::count(square.points, p) == 0) square.points.push_back(p);
  const auto result = triangulate(square);
  TriangleMesh mesh;
  mesh.points = result->delaunay.points();
  mesh.triangles = result->triangles();
  mesh.segments = result->segments;
  return mesh;
}

// n x n cells; nodes inside move by up to `jitter` cells.
TriangleMesh uniform_square(int n, double jitter, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> points;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const bool inside = x > 0 && y > 0 && x < n && y < n;
      const double dx = random.uniform(-jitter, jitter), dy = random.uniform(-jitter, jitter);
      points.push_back({(x + inside * dx) / n, (y + inside * dy) / n});
    }
  return square_mesh(std::move(points));
}

// Grids of 8 x 8 cells on [0, 2^-k]^2, k = 0 .. octaves, each without the place of the next.
TriangleMesh graded_square(int octaves) {
  std::vector<Point2> points;
  for (int k = 0; k <= octaves; ++k)
    for (int y = 0; y <= 8; ++y)
      for (int x = 0; x <= 8; ++x)
        if (k == octaves || x > 4 || y > 4)
          points.push_back({std::ldexp(x, -k - 3), std::ldexp(y, -k - 3)});
  return square_mesh(std::move(points));
}

// ---- Theorems 5.5.2 and 5.5.3

// Constants, gaps on the boundary in the interval convention, as the proofs have them.
struct CoarseningBounds {
  double l0, beta, boundary, gamma, interior;

  explicit CoarseningBounds(double measured_l0) : l0(std::max(4., measured_l0)) {
    beta = 12 * std::sqrt(l0);
    boundary = l0 + 4 * (1 + l0) * beta / ((beta - 1) * (beta - 1));
    gamma = 1 / (boundary * (8 + 12 * l0));
    interior = std::max(12 * l0, (4 * boundary * boundary + 1) * (3 * l0 + 2));
  }
};

double smallest_boundary_angle_deg(const Pslg& b) {
  double smallest = 360;
  for (const Segment& s : b.segments)
    for (const Segment& t : b.segments) {
      if (&s == &t) continue;
      for (const auto& [at, p, q] : {std::array{s.a, s.b, t.b}, std::array{s.a, s.b, t.a},
                                     std::array{s.b, s.a, t.b}, std::array{s.b, s.a, t.a}}) {
        const bool meets = (t.a == at && t.b == q) || (t.b == at && t.a == q);
        if (!meets) continue;
        const Point2 o = b.points[at], u = b.points[p], v = b.points[q];
        const double dot = (u.x - o.x) * (v.x - o.x) + (u.y - o.y) * (v.y - o.y);
        const double cosine = dot / (distance(o, u) * distance(o, v));
        smallest = std::min(smallest, std::acos(std::clamp(cosine, -1., 1.)) * 57.29577951308232);
      }
    }
  return smallest;
}

// In degrees.
constexpr double kLeastAngle = 60.0001;

// As coarsen() completes it.
TriangleMesh completed(const TriangleMesh& input) {
  return coarsen(input, {.max_levels = 0})->levels[0].mesh;
}

Pslg boundary_of_input(const TriangleMesh& input) {
  return boundary_description(completed(input)).graph;
}

// The bounds for a mesh, with f_0 = min(NN, lfs) made from its values at the nodes; without a limit
// with f_0 = NN, and then the theorem asks for too little boundary.
enum class Limit { kFeatureSize, kNone };

struct Setting {
  Limit limit;
  TriangleMesh mesh;
  std::vector<double> nn;
  std::function<double(Point2)> lfs;
  double angle = 0;
  CoarseningBounds bounds{0};

  explicit Setting(const TriangleMesh& input, Limit limit_by = Limit::kFeatureSize)
      : limit(limit_by) {
    mesh = completed(input);
    nn = nearest_neighbor_spacing(mesh.points);
    const Pslg b = boundary_description(mesh).graph;
    angle = smallest_boundary_angle_deg(b);
    if (limit == Limit::kFeatureSize) {
      const auto size = std::make_shared<LocalFeatureSize>(*LocalFeatureSize::build(b));
      lfs = [size](Point2 x) { return size->at(x); };
    }
    const ConeFunction f0(mesh.points, nn, 0, lfs);
    const double interior = test::interior_gaps(mesh, mesh.points, f0).upper;
    const double boundary = test::boundary_gaps(mesh, f0);
    bounds = CoarseningBounds(std::max(interior, boundary));
  }

  bool hypotheses_hold() const {
    const double half_angle = angle / 2 / 57.29577951308232;
    return limit == Limit::kFeatureSize && angle > kLeastAngle &&
           bounds.beta >= std::max(2., 1 / (2 * std::sin(half_angle) - 1));
  }

  CoarseningOptions options(CoarseningScheme scheme) const {
    CoarseningOptions options;
    options.scheme = scheme;
    options.metric = SpacingMetric::kEuclidean;
    options.beta = bounds.beta;
    options.factor = 2;
    options.protect = bounds.gamma;
    options.limit_by_boundary = limit == Limit::kFeatureSize;
    return options;
  }

  ConeFunction function_of_level(std::size_t k) const {
    std::vector<double> weights;
    for (const double g : nn)
      weights.push_back(0.5 * g * bounds.beta * std::ldexp(1, static_cast<int>(k)));
    return {mesh.points, weights, 0, lfs};
  }
};

void compare_gaps(const Setting& setting, const Hierarchy& hierarchy, const std::string& name) {
  const bool holds = setting.hypotheses_hold();
  std::printf("%s: L0 <= %.2f, smallest angle of B %.1f: the hypotheses %s\n", name.c_str(),
              setting.bounds.l0, setting.angle, holds ? "hold" : "fail");
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    const Level& level = hierarchy.levels[k];
    const ConeFunction f = setting.function_of_level(k);
    const Bracket interior = test::interior_gaps(level.mesh, level.mesh.points, f, 600);
    const double boundary = test::boundary_gaps(level.mesh, f);
    std::printf(
        "  level %zu, %zu nodes: interior gaps %.2f to %.2f (bound %.0f), boundary %.2f "
        "(bound %.2f)\n",
        k, level.origin.size(), interior.lower, interior.upper, setting.bounds.interior, boundary,
        setting.bounds.boundary);
    EXPECT_LT(interior.lower, interior.upper);
    if (!holds) continue;
    EXPECT_LE(interior.upper, setting.bounds.interior) << name << " level " << k;
    EXPECT_LE(boundary, setting.bounds.boundary) << name << " level " << k;
  }
}

TEST(Theorem553, BoundsTheGapsOfEveryLevelFromTheFinestMesh) {
  for (const auto& [name, input] :
       {std::pair{"uniform", uniform_square(36, 0.2, 1)}, std::pair{"graded", graded_square(9)}}) {
    const Setting setting(input);
    ASSERT_TRUE(setting.hypotheses_hold()) << name;
    for (const auto scheme : {CoarseningScheme::kFromFinest, CoarseningScheme::kCoarseToFine}) {
      const auto hierarchy = coarsen(setting.mesh, setting.options(scheme));
      ASSERT_TRUE(hierarchy.ok());
      EXPECT_GT(hierarchy->levels.size(), 1u) << name;
      compare_gaps(setting, *hierarchy, name);
    }
  }
}

// ---- The same on real meshes, and on generated ones with curved boundaries

constexpr const char* kMeshes[] = {"thesis/airfoil1",
                                   "thesis/airfoil3",
                                   "thesis/crack_float32",
                                   "thesis/crack_slit",
                                   "graded/adcirc_shinnecock",
                                   "graded/su2_naca0012_inv",
                                   "graded/thetis_north_sea_demo",
                                   "generated/crack",
                                   "generated/airfoil"};

std::optional<TriangleMesh> mesh_of(const std::string& name) {
  const auto generated = [](GradedDomain domain) -> std::optional<TriangleMesh> {
    return generate_graded_mesh(domain, {.nodes = 3000}).value();
  };
  if (name == "generated/crack") return generated(GradedDomain::kCrack);
  if (name == "generated/airfoil") return generated(GradedDomain::kAirfoil);
  return test::data_mesh(name);
}

std::string test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '/', '_');
  return name;
}

class TheoremOnMesh : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const auto mesh = mesh_of(GetParam()))
      mesh_ = *mesh;
    else
      GTEST_SKIP() << "no " << test::data_path(GetParam());
  }
  TriangleMesh mesh_;
};

INSTANTIATE_TEST_SUITE_P(Meshes, TheoremOnMesh, testing::ValuesIn(kMeshes), test_name);

// Where B has no sharp angle, spacings below lfs satisfy the hypotheses; a curved boundary then
// stays whole. Elsewhere the gaps are reported for spacings that lfs does not limit.
TEST_P(TheoremOnMesh, BoundsTheGapsOfEveryLevelAs553Says) {
  const bool is_blunt = smallest_boundary_angle_deg(boundary_of_input(mesh_)) > kLeastAngle;
  const Setting setting(mesh_, is_blunt ? Limit::kFeatureSize : Limit::kNone);
  EXPECT_EQ(setting.hypotheses_hold(), is_blunt);
  ASSERT_TRUE(std::isfinite(setting.bounds.beta));
  CoarseningOptions options = setting.options(CoarseningScheme::kCoarseToFine);
  options.max_levels = 2;
  const auto hierarchy = coarsen(setting.mesh, options);
  ASSERT_TRUE(hierarchy.ok()) << hierarchy.error().message;
  EXPECT_GT(hierarchy->levels.size(), 1u);
  compare_gaps(setting, *hierarchy, GetParam());
}

// ---- Chapter 6

TEST(Theorem622, LeavesNoLargeEmptySquareAtAnyLevel) {
  const TriangleMesh mesh = uniform_square(40, 0.2, 2);
  CoarseningOptions options = theorem_options(CoarseningMethod::kQuasiUniform);
  options.protect = 0;
  const auto hierarchy = coarsen(mesh, options);
  ASSERT_GT(hierarchy->levels.size(), 3u);
  const auto& nn = hierarchy->levels[0].spacing;
  double radius = 0.5 * *std::min_element(nn.begin(), nn.end());
  const double l = std::max(1., test::largest_empty_square(mesh.points) / (6 * radius));
  for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
    const Level& level = hierarchy->levels[k];
    radius *= 3;
    EXPECT_NEAR(level.spacing[0], 2 * radius, 1e-12);
    EXPECT_LE(test::largest_empty_square(level.mesh.points), 6 * l * radius) << "level " << k;
  }
}

// Balls of one size stay disjoint: the set is spaced, special points among themselves apart.
TEST(QuasiUniformScheme, KeepsTheBallsDisjoint) {
  const auto hierarchy =
      coarsen(uniform_square(40, 0.2, 3), theorem_options(CoarseningMethod::kQuasiUniform));
  for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
    const Level& level = hierarchy->levels[k];
    for (Index v = 0; v < level.origin.size(); ++v)
      for (Index w = 0; w < v; ++w)
        if (!(std::ranges::binary_search(level.mesh.fixed, v) &&
              std::ranges::binary_search(level.mesh.fixed, w)))
          EXPECT_LE(level.spacing[v], distance(level.mesh.points[v], level.mesh.points[w]));
  }
}

// Theorem 5.5.9: with a constant function, C > 2 and beta = 2 the gap parameter never grows.
TEST(Theorem559, KeepsTheGapsOfQuasiUniformMeshes) {
  const TriangleMesh mesh = uniform_square(36, 0.2, 4);
  CoarseningOptions options = theorem_options(CoarseningMethod::kQuasiUniform);
  options.protect = 0;
  const auto hierarchy = coarsen(mesh, options);
  double f =
      *std::min_element(hierarchy->levels[0].spacing.begin(), hierarchy->levels[0].spacing.end());
  const double l0 =
      std::max(2., test::interior_gaps(mesh, mesh.points, {{}, {}, f, {}}, 2000).upper);
  for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
    f *= 3;
    const Level& level = hierarchy->levels[k];
    const Bracket gaps = test::interior_gaps(level.mesh, level.mesh.points, {{}, {}, f, {}}, 2000);
    EXPECT_LE(gaps.upper, l0) << "level " << k;
    EXPECT_LE(gaps.lower, gaps.upper);
  }
}

// The constants of Theorem 6.3.3 with the errata, level by level and from the finest mesh.
TEST(Theorem633, KeepsTheGapsOfGradedMeshesBelowTwiceTheirs) {
  const TriangleMesh mesh = graded_square(13);
  const std::vector<double> nn = nearest_neighbor_spacing(mesh.points);
  const double l = test::interior_gaps(mesh, mesh.points, {mesh.points, nn, 0, {}}, 2000).upper;
  for (const auto scheme : {CoarseningScheme::kFineToCoarse, CoarseningScheme::kFromFinest}) {
    CoarseningOptions options = theorem_options(CoarseningMethod::kThreshold);
    options.scheme = scheme;
    options.beta = std::max(8 * l, 13 + 6 / l);
    options.protect = 0;
    const auto hierarchy = coarsen(mesh, options);
    ASSERT_GT(hierarchy->levels.size(), 3u);
    double threshold = *std::min_element(nn.begin(), nn.end());
    for (std::size_t k = 1; k < hierarchy->levels.size(); ++k) {
      const Level& level = hierarchy->levels[k];
      threshold *= 24;
      const ConeFunction t{mesh.points, nn, threshold, {}};
      for (Index v = 0; v < level.origin.size(); ++v)
        ASSERT_NEAR(level.spacing[v], t.least(level.mesh.points[v], 0), 1e-12);
      const Bracket gaps = test::interior_gaps(level.mesh, level.mesh.points, t, 1000);
      EXPECT_LE(gaps.upper, 2 * l)
          << "level " << k << ", witness at " << gaps.centre.x << ' ' << gaps.centre.y;
    }
  }
}

// What the factor raises the least value of a level to; again and again where that dropped no node.
double threshold_of(const Level& finer, const Level& level, double factor) {
  const double reached = std::ranges::min(level.spacing) * (1 - 1e-12);
  double threshold = factor * std::ranges::min(finer.spacing);
  while (threshold < reached) threshold *= factor;
  return threshold;
}

// The functions of the levels are max(base, threshold). Both theorems are about the interior alone:
// they say nothing about levels whose boundary was simplified, so that nodes were left outside.
void compare_interior_gaps(const Hierarchy& hierarchy, std::span<const double> base, double factor,
                           double bound, const char* name) {
  const std::vector<Point2>& points = hierarchy.levels[0].mesh.points;
  std::size_t outside = 0;
  for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
    const Level& level = hierarchy.levels[k];
    outside += level.dropped_outside;
    const ConeFunction f(base.empty() ? std::span<const Point2>() : points, base,
                         threshold_of(hierarchy.levels[k - 1], level, factor), {});
    for (Index v = 0; v < level.origin.size(); ++v)
      ASSERT_NEAR(f.least(level.mesh.points[v], 0) / level.spacing[v], 1, 1e-9);
    const Bracket gaps = test::interior_gaps(level.mesh, level.mesh.points, f, 600);
    std::printf(
        "%s, level %zu, %zu nodes: gaps %.2f to %.2f (bound %.2f), %zu nodes left outside\n", name,
        k, level.origin.size(), gaps.lower, gaps.upper, bound, outside);
    EXPECT_LE(gaps.lower, gaps.upper);
    if (outside == 0) EXPECT_LE(gaps.upper, bound) << name << " level " << k;
  }
}

TEST_P(TheoremOnMesh, KeepsTheGapsOfAConstantFunctionAs559Says) {
  CoarseningOptions options = theorem_options(CoarseningMethod::kQuasiUniform);
  options.protect = 0;
  options.max_levels = 4;
  const auto hierarchy = coarsen(mesh_, options);
  ASSERT_GT(hierarchy->levels.size(), 2u);
  const double f = std::ranges::min(hierarchy->levels[0].spacing);
  const double l0 = test::interior_gaps(mesh_, mesh_.points, {{}, {}, f, {}}).upper;
  compare_interior_gaps(*hierarchy, {}, options.factor, std::max(2., l0), GetParam());
}

TEST_P(TheoremOnMesh, KeepsTheGapsOfThresholdsBelowTwiceTheInputsAs633Says) {
  const std::vector<double> nn = nearest_neighbor_spacing(mesh_.points);
  const double l = test::interior_gaps(mesh_, mesh_.points, {mesh_.points, nn, 0, {}}).upper;
  CoarseningOptions options = theorem_options(CoarseningMethod::kThreshold);
  options.beta = std::max(8 * l, 13 + 6 / l);
  options.protect = 0;
  options.max_levels = 3;
  const auto hierarchy = coarsen(mesh_, options);
  ASSERT_GT(hierarchy->levels.size(), 1u);
  compare_interior_gaps(*hierarchy, nn, options.factor, 2 * l, GetParam());
}

// ---- Lemmas 5.4.5, 7.1.4 and 7.1.5, Theorem 2.5.2

TEST(Lemma545, BoundsTheCoarseningFunctionByTheThresholdFunction) {
  const TriangleMesh mesh = uniform_square(24, 0.25, 5);
  const std::vector<double> nn = nearest_neighbor_spacing(mesh.points);
  const auto [least, most] = std::minmax_element(nn.begin(), nn.end());
  const double rho = *most / *least;
  const double l = test::interior_gaps(mesh, mesh.points, {mesh.points, nn, 0, {}}, 2000).upper;
  for (const double factor : {2., 10., 200.}) {
    const auto f = euclidean_coarsened_spacing(mesh.points, nn, factor);
    const auto t = threshold_spacing(nn, factor);
    for (std::size_t v = 0; v < nn.size(); ++v) {
      EXPECT_LE(t[v], f[v] * (1 + 1e-14));
      EXPECT_LE(f[v], rho * (rho + 2 * l) * t[v]);
    }
  }
}

TEST(Lemma714, BoundsTheGraphFunctionByTheDilationTimesTheEuclidean) {
  for (const auto& mesh : {uniform_square(10, 0.3, 6), graded_square(3)}) {
    const Graph graph = mesh_graph(mesh);
    const Dilation dilation = measured_dilation(Visibility(mesh), graph, mesh.points.size());
    ASSERT_TRUE(dilation.complete);
    EXPECT_GT(dilation.mu, 1.05);
    EXPECT_LT(dilation.mu, 2.42);  // Keil and Gutwin's bound for Delaunay triangulations
    const std::vector<double> nn = nearest_neighbor_spacing(mesh.points);
    const auto along_edges = coarsened_spacing(graph, nn, 3);
    const auto straight = euclidean_coarsened_spacing(mesh.points, nn, 3);
    for (Index v = 0; v < mesh.points.size(); ++v) {
      EXPECT_LE(straight[v], along_edges[v] * (1 + 1e-14));
      EXPECT_LE(along_edges[v], dilation.mu * straight[v] * (1 + 1e-14));
      for (Index w = 0; w < v; ++w)  // Corollary 7.1.5
        EXPECT_LE(std::fabs(along_edges[v] - along_edges[w]),
                  dilation.mu * distance(mesh.points[v], mesh.points[w]) * (1 + 1e-12));
    }
  }
}

TEST(MeasuredDilation, IsThatOfAllPairsOrALowerBoundOfIt) {
  const TriangleMesh mesh = uniform_square(7, 0.3, 7);
  const Graph graph = mesh_graph(mesh);
  const Visibility visibility(mesh);
  double expected = 1;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    std::vector<double> start(mesh.points.size(), HUGE_VAL);
    start[v] = 0;
    const auto d = coarsened_spacing(graph, start, 1);
    for (Index w = 0; w < mesh.points.size(); ++w)
      if (w != v) expected = std::max(expected, d[w] / distance(mesh.points[v], mesh.points[w]));
  }
  const Dilation all = measured_dilation(visibility, graph, 1000);
  EXPECT_NEAR(all.mu, expected, 1e-12);
  const Dilation some = measured_dilation(visibility, graph, 5);
  EXPECT_FALSE(some.complete);
  EXPECT_LE(some.mu, all.mu);
  EXPECT_GT(some.mu, 1);
}

// Theorem 2.5.2 for a level and the function that spaces it, at any place.
TEST(Theorem252, TiesTheSpacingOfALevelToItsNearestNeighbors) {
  const TriangleMesh mesh = uniform_square(40, 0.2, 8);
  CoarseningOptions options = theorem_options(CoarseningMethod::kQuasiUniform);
  options.max_levels = 2;
  const Level level = coarsen(mesh, options)->levels.back();
  const double f = level.spacing[0];
  const double interior =
      test::interior_gaps(level.mesh, level.mesh.points, {{}, {}, f, {}}, 2000).upper;
  const double l = std::max(interior, test::boundary_gaps(level.mesh, {{}, {}, f, {}}) / 2);
  const double d = l * (3 + 2 * l);
  const NearestNeighborFunction nn(level.mesh.points);
  Random random(9);
  for (int trial = 0; trial < 1000; ++trial) {
    const double x = random.uniform();
    const double value = nn({x, random.uniform()});
    EXPECT_LE(f, (options.beta + 1) * value * (1 + 1e-12));
    EXPECT_LE(value, d * (2 + d) * f);
  }
}

}  // namespace
}  // namespace wellspaced
