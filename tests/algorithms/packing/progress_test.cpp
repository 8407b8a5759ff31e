// Packing and generating can be watched and cancelled: questions come as work is done, however
// large the input, and none comes after the answer to stop.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/domains.hpp"
#include "tests/support/solids.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/algorithms/generate/low_discrepancy.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/algorithms/generate/points3.hpp"
#include "wellspaced/algorithms/generate/well_spaced.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"

namespace wellspaced {
namespace {

/// run: with an input of about so many nodes. small: how many ask at least a few times.
struct Watched {
  std::string name;
  Index small;
  std::function<void(Index nodes, const Progress&)> run;
};

// The unit square with so many teeth along its upper side.
Pslg comb(Index teeth) {
  std::vector<Point2> points = {{0, 0}, {1, 0}};
  for (Index i = 0; i <= 2 * teeth; ++i)
    points.push_back({1 - static_cast<double>(i) / (2 * teeth), i % 2 == 0 ? 1 : 1 - 1.0 / teeth});
  return test::polygons({points});
}

void pack_square(Index nodes, Maximality maximality, const Progress& progress) {
  PackingOptions options;
  options.size = [h = 1 / std::sqrt(static_cast<double>(nodes))](Point2) { return h; };
  options.maximality = maximality;
  options.progress = progress;
  (void)pack_domain(test::unit_square(), options);
}

void pack_comb(Index nodes, const Progress& progress) {
  PackingOptions options;
  options.sharp_corners = SharpCorners::kMesh;
  options.progress = progress;
  (void)pack_domain(comb(nodes / 4), options);
}

void pack_cube(Index nodes, const Progress& progress) {
  PackingOptions3 options;
  options.size = [h = 1 / std::cbrt(static_cast<double>(nodes))](Point3) { return h; };
  options.size_slope = 0;
  options.progress = progress;
  (void)pack_domain3(test::triangulated_cube(), options);
}

template <class Make>
Watched point_set(const std::string& name, Make make) {
  return {name, 200'000, [=](Index nodes, const Progress& p) { (void)make(nodes, p); }};
}

std::vector<Watched> operations() {
  return {
      {"pack_domain", 5000,
       [](Index n, const Progress& p) { pack_square(n, Maximality::kDelaunay, p); }},
      {"pack_domain_full", 500,
       [](Index n, const Progress& p) { pack_square(n, Maximality::kFull, p); }},
      {"pack_domain_boundary", 400, pack_comb},
      {"pack_domain3", 1000, pack_cube},
      {"generate_graded_mesh", 5000,
       [](Index n, const Progress& p) {
         (void)generate_graded_mesh(GradedDomain::kAirfoil, {.nodes = n}, p);
       }},
      {"generate_well_spaced", 5000,
       [](Index n, const Progress& p) { (void)generate_well_spaced({.nodes = n}, p); }},
      {"generate_grid", 200'000,
       [](Index n, const Progress& p) { (void)generate_grid({.nx = 100, .ny = n / 100}, p); }},
      point_set("random_points", [](Index n, const Progress& p) { return random_points(n, 1, p); }),
      point_set("clustered_points",
                [](Index n, const Progress& p) { return clustered_points(n, 10, 1, p); }),
      point_set("circle_points",
                [](Index n, const Progress& p) { return circle_points(n / 2, n / 2, 1, p); }),
      point_set("spiral_points",
                [](Index n, const Progress& p) { return spiral_points(n, 40, p); }),
      point_set("halton_points", [](Index n, const Progress& p) { return halton_points(n, p); }),
      point_set("sphere_points3",
                [](Index n, const Progress& p) { return sphere_points3(n, 1, p); }),
      point_set("helix_points3",
                [](Index n, const Progress& p) { return helix_points3(n, 100, 0.01, p); }),
      point_set("shuffle_points",
                [](Index n, const Progress& p) {
                  std::vector<Point2> points(n);
                  shuffle_points(points, 1, p);
                  return points;
                }),
  };
}

// Counts the questions of a run, and answers the one of number `stop_at` by "stop".
struct Listener {
  std::size_t stop_at = SIZE_MAX, questions = 0;
  std::map<std::string, double, std::less<>> part;  // of each phase that is done

  Progress progress() {
    return [this](std::string_view phase, std::uint64_t done, std::uint64_t total) {
      EXPECT_TRUE(total == 0 || done <= total) << phase;
      const double now = static_cast<double>(done) / (total == 0 ? 1 : static_cast<double>(total));
      double& before = part.emplace(phase, 0).first->second;
      EXPECT_LE(before, now) << phase << " goes back";
      before = now;
      return ++questions != stop_at;
    };
  }
};

std::size_t count_questions(const Watched& operation, Index nodes, std::size_t stop_at) {
  Listener listener;
  listener.stop_at = stop_at;
  operation.run(nodes, listener.progress());
  return listener.questions;
}

class WatchedOperation : public ::testing::TestWithParam<std::size_t> {};

TEST_P(WatchedOperation, AsksInProportionToItsWorkAndNeverAgainWhenToldToStop) {
  const Watched operation = operations()[GetParam()];
  const std::size_t few = count_questions(operation, operation.small, SIZE_MAX);
  const std::size_t many = count_questions(operation, 4 * operation.small, SIZE_MAX);
  EXPECT_GE(few, 10u);
  EXPECT_GE(many, 2 * few) << "the stretches between questions grow with the input";
  for (const std::size_t k : {std::size_t{1}, few / 3, few / 2, few - 1})
    EXPECT_EQ(count_questions(operation, operation.small, k), k);
}

INSTANTIATE_TEST_SUITE_P(Of, WatchedOperation,
                         ::testing::Range(std::size_t{0}, operations().size()),
                         [](const auto& each) { return operations()[each.param].name; });

}  // namespace
}  // namespace wellspaced
