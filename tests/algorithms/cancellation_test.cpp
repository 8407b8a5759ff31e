// Every long operation asks often enough, tells of progress that only grows, and stops when told.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/grid_meshes.hpp"
#include "tests/support/points3.hpp"
#include "wellspaced/algorithms/audit/domain.hpp"
#include "wellspaced/algorithms/audit/hierarchy_audit.hpp"
#include "wellspaced/algorithms/audit/intersection.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/point_mesh.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/quality/selection_check.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/mesh/prepare_mesh.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/algorithms/packing/space/feature_size3.hpp"
#include "wellspaced/algorithms/spacing/euclidean_spacing.hpp"
#include "wellspaced/algorithms/spacing/geodesic_spacing.hpp"
#include "wellspaced/algorithms/spacing/nearest_neighbor.hpp"
#include "wellspaced/algorithms/transfer/galerkin.hpp"
#include "wellspaced/algorithms/transfer/solver_levels.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

const TriangleMesh& grid() {
  static const TriangleMesh mesh = test::grid_mesh({.nx = 200, .ny = 200});
  return mesh;
}

const Hierarchy& hierarchy() {
  static const Hierarchy levels = *coarsen(grid(), multigrid_profile());
  return levels;
}

// All nodes and most edges of the grid, and a hole beside it.
const Pslg& all_of_grid() {
  static const Pslg domain = [] {
    Pslg all;
    all.points = grid().points;
    for (const auto& [a, b, c] : grid().triangles) all.segments.push_back({a, b, 1});
    all.holes.push_back({-5, -5});
    return all;
  }();
  return domain;
}

std::vector<Point3> random_places(std::size_t count) {
  Random random(3);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

const TetMesh& solid() {
  static const TetMesh mesh = *audit::mesh_of_points(random_places(4000));
  return mesh;
}

// All nodes, edges and hull facets of the solid, and a cavity beside it.
audit::PolyhedralDomain all_of_solid() {
  audit::PolyhedralDomain domain;
  domain.points = solid().points;
  for (const auto& [a, b, c, d] : solid().tets) domain.segments.push_back({a, b, 1});
  for (const TetMesh::Facet& facet : solid().facets)
    domain.facets.push_back({{facet.points.begin(), facet.points.end()}});
  domain.holes.push_back({-5, -5, -5});
  return domain;
}

struct Operation {
  std::string name;
  std::function<void(const Progress&)> run;
};

Operation coarsening(const std::string& name, CoarseningOptions options) {
  return {name, [=](const Progress& progress) {
            CoarseningOptions watched = options;
            watched.progress = progress;
            (void)coarsen(grid(), watched);
          }};
}

CoarseningOptions in_metric(SpacingMetric metric) {
  CoarseningOptions options;
  options.metric = metric;
  return options;
}

CoarseningOptions in_scheme(CoarseningScheme scheme) {
  CoarseningOptions options = multigrid_profile();
  options.scheme = scheme;
  options.max_levels = 4;
  return options;
}

void audit_levels(const Progress& progress) {
  std::vector<audit::HierarchyLevel> levels;
  for (const Level& level : hierarchy().levels)
    levels.push_back({level.mesh, level.origin, level.spacing});
  audit::HierarchyAuditOptions options;
  options.beta = 4;
  options.factor = 2;
  options.well_spacing = audit::WellSpacing::kMeasured;
  options.progress = progress;
  (void)audit::audit_hierarchy(levels, options);
}

template <class Mesh>
void audit_spacing_of(const Mesh& mesh, const Progress& progress) {
  audit::Report report;
  audit::SpacingAuditOptions options;
  options.progress = progress;
  audit::audit_spacing(mesh, options, report);
}

std::vector<Operation> coarsenings() {
  return {
      coarsening("coarsen", {}),
      coarsening("coarsen_mis", theorem_options(CoarseningMethod::kMis)),
      coarsening("coarsen_threshold", theorem_options(CoarseningMethod::kThreshold)),
      coarsening("coarsen_quasi_uniform", theorem_options(CoarseningMethod::kQuasiUniform)),
      coarsening("coarsen_quadtree", theorem_options(CoarseningMethod::kQuadtree)),
      coarsening("coarsen_refinement", quality_profile()),
      coarsening("coarsen_euclidean", in_metric(SpacingMetric::kEuclidean)),
      coarsening("coarsen_geodesic", in_metric(SpacingMetric::kGeodesic)),
      coarsening("coarsen_from_finest", in_scheme(CoarseningScheme::kFromFinest)),
      coarsening("coarsen_coarse_to_fine", in_scheme(CoarseningScheme::kCoarseToFine)),
  };
}

std::vector<Operation> operations() {
  std::vector<Operation> all = coarsenings();
  const std::vector<Operation> others = {
      {"statistics", [](const Progress& p) { (void)hierarchy_statistics(hierarchy(), p); }},
      {"prepare_for_solver", [](const Progress& p) { (void)prepare_for_solver(hierarchy(), p); }},
      {"check_selection",
       [](const Progress& p) {
         (void)check_selection(mesh_graph(grid()), hierarchy().levels[1], 4, p);
       }},
      {"intersections",
       [](const Progress& p) {
         const auto& levels = hierarchy().levels;
         (void)audit::count_intersections(levels[0].mesh, levels[1].mesh, levels[1].parent, p);
       }},
      {"nearest_neighbors",
       [](const Progress& p) { (void)nearest_neighbor_spacing(grid().points, p); }},
      {"euclidean_spacing",
       [](const Progress& p) {
         (void)euclidean_coarsened_spacing(grid().points, hierarchy().levels[0].spacing, 4, p);
       }},
      {"geodesic_spacing",
       [](const Progress& p) {
         const Visibility visibility(grid());
         (void)geodesic_coarsened_spacing(visibility, mesh_graph(grid()),
                                          hierarchy().levels[0].spacing, 4, p);
       }},
      {"audit", [](const Progress& p) { (void)audit::audit_mesh(grid(), {.progress = p}); }},
      {"audit_domain",
       [](const Progress& p) {
         (void)audit::audit_mesh(grid(), {.domain = &all_of_grid(), .progress = p});
       }},
      {"audit_holes",
       [](const Progress& p) {
         audit::Report report;
         audit::audit_holes(grid(), grid().points, p, report);
       }},
      {"audit_domain_space",
       [](const Progress& p) {
         const audit::PolyhedralDomain domain = all_of_solid();
         (void)audit::audit_tet_mesh(solid(), {.domain = &domain, .progress = p});
       }},
      {"prepare_mesh",
       [](const Progress& p) {
         TriangleMesh mesh = grid();
         mesh.segments = all_of_grid().segments;
         (void)prepare_mesh(mesh, 0, p);
       }},
      {"packed_spacing",
       [](const Progress& p) {
         PackedMesh packed;
         packed.mesh.points = grid().points;
         packed.radius.assign(grid().points.size(), 0.5);
         (void)packed_spacing(packed, 4, p);
       }},
      {"feature_size",
       [](const Progress& p) {
         PolyhedralComplex complex;
         complex.points = random_places(40'000);
         complex.is_vertex.assign(complex.points.size(), true);
         (void)FeatureSize3(complex, p);
       }},
      {"audit_space",
       [](const Progress& p) { (void)audit::audit_tet_mesh(solid(), {.progress = p}); }},
      {"audit_spacing", [](const Progress& p) { audit_spacing_of(grid(), p); }},
      {"audit_spacing_space", [](const Progress& p) { audit_spacing_of(solid(), p); }},
      {"audit_hierarchy", audit_levels},
  };
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// What one run told, and its longest stretch of processor time without a question.
struct Watch {
  int asked = 0, stop_at = -1;  // the question to answer by "stop"
  double last = cpu_now(), longest = 0;
  std::map<std::string, double, std::less<>> part;  // of each phase

  void see() {
    const double now = cpu_now();
    longest = std::max(longest, now - last);
    last = now;
  }
  Progress progress() {
    return [this](std::string_view phase, std::uint64_t done, std::uint64_t total) {
      see();
      EXPECT_TRUE(total == 0 || done <= total) << phase;
      const double now = total == 0 ? 0 : static_cast<double>(done) / static_cast<double>(total);
      double& before = part.emplace(phase, 0).first->second;
      EXPECT_GE(now, before) << phase;
      before = now;
      return ++asked != stop_at;
    };
  }
};

class Cancellation : public ::testing::TestWithParam<std::size_t> {};

// Half the work at most lies between two questions of these inputs of 40,000 nodes, and so behind
// the one that is answered by "stop".
TEST_P(Cancellation, ComesSoonAndIsNotAskedForTwice) {
  const Operation operation = operations()[GetParam()];
  (void)hierarchy();
  (void)solid();
  Watch watch;
  const double start = cpu_now();
  operation.run(watch.progress());
  watch.see();
  const double total = cpu_now() - start;
  ASSERT_GE(watch.asked, 4);
  EXPECT_LE(watch.longest, std::max(total / 2, 0.05)) << "of " << total;
  for (const int number : {1, watch.asked / 3, watch.asked}) {
    Watch stopped;
    stopped.stop_at = std::max(1, number);
    operation.run(stopped.progress());
    EXPECT_EQ(stopped.asked, stopped.stop_at) << "it asks again after it was told to stop";
    stopped.see();
    EXPECT_LE(stopped.longest, std::max(total / 2, 0.05)) << "of " << total;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Cancellation, ::testing::Range(std::size_t{0}, operations().size()),
                         [](const auto& each) { return operations()[each.param].name; });

TEST(CoarseningProgress, OnlyGrowsFromPhaseToPhaseAndEndsAtAll) {
  for (const Operation& operation : coarsenings()) {
    std::vector<std::uint64_t> told;
    operation.run([&](auto, std::uint64_t done, std::uint64_t total) {
      EXPECT_EQ(total, grid().points.size());
      told.push_back(done);
      return true;
    });
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end())) << operation.name;
    EXPECT_EQ(told.front(), 0u) << operation.name;
    EXPECT_GT(told[told.size() - 2], 0u) << operation.name;
    EXPECT_EQ(told.back(), grid().points.size()) << operation.name;
  }
}

}  // namespace
}  // namespace wellspaced
