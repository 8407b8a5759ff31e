// Balanced quadtrees beside p4est, the cost of coarsening by quadtree against the size of the mesh,
// and one coarsening of a uniform mesh beside mmg2d. CPU seconds, from runs in one process.
//
//   quadtree_table [LARGEST]      nodes of the largest mesh, default 1000000
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/coarsening/statistics.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/plane/quadtree.hpp"
#include "wellspaced/kernel/random.hpp"

#ifdef WELLSPACED_BENCH_P4EST
#include <p4est_bits.h>
#include <p4est_extended.h>
#endif

namespace wellspaced::bench {
namespace {

constexpr int kRuns = 5;

// ---- Refine and balance

// In the unit square about (0.4, 0.45): directions uniform, logarithms of radii uniform.
std::vector<Point2> log_radial_points(std::size_t n, double octaves) {
  Random random(1);
  std::vector<Point2> points;
  while (points.size() < n) {
    const Point2 direction = circle_point(random.uniform());
    const double radius = 0.4 * power_of_two(-octaves * random.uniform());
    points.push_back({0.4 + radius * direction.x, 0.45 + radius * direction.y});
  }
  return points;
}

#ifdef WELLSPACED_BENCH_P4EST
// As users do it: the points along the Z curve, and for each quadrant asked about whether it holds
// more than one of them.
struct SortedCells {
  std::vector<MortonCode> cells;
};

int holds_several(p4est_t* forest, p4est_topidx_t, p4est_quadrant_t* quadrant) {
  const auto& cells = static_cast<SortedCells*>(forest->user_pointer)->cells;
  constexpr int kShift = P4EST_MAXLEVEL - kMortonDepth;
  static_assert(kShift <= 0, "its deepest grid is the coarser one");
  const MortonCode first = morton::encode(static_cast<std::uint32_t>(quadrant->x),
                                          static_cast<std::uint32_t>(quadrant->y))
                           << 2 * -kShift;
  const MortonCode end = first + morton::cells_in(quadrant->level);
  const auto begin = std::lower_bound(cells.begin(), cells.end(), first);
  return quadrant->level < P4EST_QMAXLEVEL && cells.end() - begin > 1 && begin[1] < end;
}

// Returns the leaves. The points are sorted before the clock starts, ours within its time.
std::size_t build_by_p4est(const std::vector<Point2>& points, double& seconds) {
  SortedCells sorted;
  const Square unit{{0.5, 0.5}, 0.5};
  for (const Point2 p : points) sorted.cells.push_back(unit.cell_of(p));
  std::sort(sorted.cells.begin(), sorted.cells.end());
  p4est_connectivity_t* square = p4est_connectivity_new_unitsquare();
  std::size_t leaves = 0;
  seconds = timed([&] {
    p4est_t* forest = p4est_new(sc_MPI_COMM_SELF, square, 0, nullptr, &sorted);
    p4est_refine(forest, 1, holds_several, nullptr);
    p4est_balance(forest, P4EST_CONNECT_FACE, nullptr);
    leaves = static_cast<std::size_t>(forest->local_num_quadrants);
    p4est_destroy(forest);
  });
  p4est_connectivity_destroy(square);
  return leaves;
}
#endif

void compare_with_p4est() {
  const std::vector<Point2> points = log_radial_points(330000, 12);
  std::vector<double> ours, theirs;
  std::size_t leaves = 0, their_leaves = 0;
  for (int run = 0; run < kRuns; ++run) {
    ours.push_back(timed([&] {
      leaves = quadtree_of_points({{0.5, 0.5}, 0.5}, points, 1, QuadtreeBalance::kEdge).leaves();
    }));
#ifdef WELLSPACED_BENCH_P4EST
    double seconds = 0;
    their_leaves = build_by_p4est(points, seconds);
    theirs.push_back(seconds);
#endif
  }
  std::printf("refine and balance 330000 log-radial points: %zu leaves, %.3f s", leaves,
              median(ours));
  if (theirs.empty()) {
    std::printf(" (p4est is not there)\n");
  } else {
    std::printf("; p4est: %zu leaves, ratio %.3f\n", their_leaves, median(ours) / median(theirs));
  }
}

// ---- Growth with the size of the mesh

// A ring between radii 2^-octaves and 1 in nearly square cells, each cut in two; the nodes are
// moved a little, so that no four lie on a circle.
TriangleMesh graded_ring(std::size_t nodes, double octaves) {
  const double rings_per_turn = octaves / 9.0647;  // 2 pi / ln 2 octaves are as long as a turn
  const auto around = static_cast<Index>(std::sqrt(static_cast<double>(nodes) / rings_per_turn));
  const auto rings = static_cast<Index>(nodes / around);
  Random random(2);
  TriangleMesh mesh;
  for (Index i = 0; i < rings; ++i)
    for (Index j = 0; j < around; ++j) {
      const bool is_inside = i > 0 && i + 1 < rings;
      const double di = is_inside ? random.uniform(-0.1, 0.1) : 0, dj = random.uniform(-0.1, 0.1);
      const double radius = power_of_two(octaves * ((i + di) / (rings - 1) - 1));
      const Point2 p = circle_point((j + dj) / around);
      mesh.points.push_back({radius * p.x, radius * p.y});
    }
  for (Index i = 0; i + 1 < rings; ++i)
    for (Index j = 0; j < around; ++j) {
      const Index next = (j + 1) % around;
      const Index a = i * around + j, b = a + around, c = b - j + next, d = a - j + next;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

TriangleMesh uniform_grid(std::size_t nodes) {
  GridOptions options;
  options.nx = options.ny = static_cast<Index>(std::lround(std::sqrt(nodes)));
  return *generate_grid(options);
}

// When each stage (fine to coarse) and each step (coarse to fine) began, in CPU seconds.
struct LevelClock {
  std::vector<double> stages, steps;

  Progress listener() {
    return
        [this, steps_begun = false](std::string_view phase, std::uint64_t, std::uint64_t) mutable {
          if (phase == "spacing") stages.push_back(cpu_seconds());
          // Of the calls of one phase the first counts.
          if (phase == "boundary" && !steps_begun) steps.push_back(cpu_seconds());
          steps_begun = phase == "boundary";
          return true;
        };
  }
  // Of the level built by a step, with the stage that it was selected from.
  double seconds_of(std::size_t step, double end) {
    steps.push_back(end), stages.push_back(steps.front());
    const std::size_t stage = stages.size() - 1 - step;
    const double seconds = steps[step] - steps[step - 1] + stages[stage + 1] - stages[stage];
    steps.pop_back(), stages.pop_back();
    return seconds;
  }
};

// So many runs that even the small sequences are measured over a second.
std::size_t runs_for(std::size_t nodes) { return std::clamp<std::size_t>(3000000 / nodes, 1, 11); }

// The microseconds a node of all levels together, by the median of the runs; printed with the least
// and greatest of a level of at least 1000 nodes in the last.
double print_sequence(const char* name, TriangleMesh mesh) {
  const std::size_t input = mesh.points.size();
  CoarseningOptions options = theorem_options(CoarseningMethod::kQuadtree);
  Hierarchy hierarchy;
  std::vector<double> times;
  const auto run = [&](TriangleMesh given) {
    times.push_back(timed([&] { hierarchy = *coarsen(std::move(given), options); }));
  };
  while (times.size() + 1 < runs_for(input)) run(mesh);
  LevelClock clock;
  options.progress = clock.listener();
  run(std::move(mesh));
  const double end = cpu_seconds();
  const double seconds = median(times);
  double nodes = 0, least = HUGE_VAL, greatest = 0;
  for (const Level& level : hierarchy.levels) {
    const auto n = static_cast<double>(level.mesh.points.size());
    nodes += n;
    if (level.step == 0 || n < 1000) continue;
    const double each = 1e6 * clock.seconds_of(level.step, end) / n;
    least = std::min(least, each), greatest = std::max(greatest, each);
  }
  const double each = 1e6 * seconds / nodes;
  std::printf("%-14s %9zu %7zu %9.0f %9.3f %9.3f %9.3f .. %.3f\n", name, input,
              hierarchy.levels.size() - 1, nodes, seconds, each, least, greatest);
  std::fflush(stdout);
  return each;
}

void print_growth(std::size_t largest) {
  std::printf("%-14s %9s %7s %9s %9s %9s %9s\n", "sequence of", "nodes", "levels", "all nodes", "s",
              "us/node", "and of single levels");
  double least_uniform = HUGE_VAL, least_graded = HUGE_VAL, uniform = 0, graded = 0;
  for (std::size_t nodes = 100000; nodes <= largest; nodes *= 10) {
    uniform = print_sequence("uniform", uniform_grid(nodes));
    graded = print_sequence("graded by 10^6", graded_ring(nodes, 19.93));
    if (nodes == 100000) least_uniform = uniform, least_graded = graded;
  }
  std::printf("growth from 10^5 nodes: uniform %.2f, graded %.2f\n", uniform / least_uniform,
              graded / least_graded);
}

// ---- One coarsening of a uniform mesh

// Medit's format; required vertices keep the corners.
void write_medit(const TriangleMesh& mesh, const std::string& path, double size) {
  std::FILE* file = std::fopen((path + ".mesh").c_str(), "w");
  if (file == nullptr) return;
  std::fprintf(file, "MeshVersionFormatted 2\nDimension 2\nVertices\n%zu\n", mesh.points.size());
  for (const Point2 p : mesh.points) std::fprintf(file, "%.17g %.17g 0\n", p.x, p.y);
  std::fprintf(file, "Triangles\n%zu\n", mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    std::fprintf(file, "%u %u %u 1\n", a + 1, b + 1, c + 1);
  std::fprintf(file, "End\n");
  std::fclose(file);
  file = std::fopen((path + ".sol").c_str(), "w");
  if (file == nullptr) return;
  std::fprintf(file, "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%zu\n1 1\n",
               mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) std::fprintf(file, "%g\n", size);
  std::fprintf(file, "End\n");
  std::fclose(file);
}

double wall_seconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The seconds of mmg2d to meshes of about the same number of nodes, reading and writing included;
// negative where it is not installed.
double seconds_of_mmg(const TriangleMesh& mesh, double size) {
  if (std::system("command -v mmg2d_O3 >/dev/null 2>&1") != 0) return -1;
  const std::string path = "quadtree_table_mmg";
  write_medit(mesh, path, size);
  const double start = wall_seconds();
  const int status = std::system(("mmg2d_O3 -v 0 -in " + path + ".mesh -sol " + path +
                                  ".sol -out " + path + ".o.mesh >/dev/null 2>&1")
                                     .c_str());
  const double seconds = wall_seconds() - start;
  for (const char* end : {".mesh", ".sol", ".o.mesh", ".o.sol"}) std::remove((path + end).c_str());
  return status == 0 ? seconds : -1;
}

void compare_with_mmg() {
  const TriangleMesh mesh = uniform_grid(1000000);
  CoarseningOptions options = theorem_options(CoarseningMethod::kQuadtree);
  options.max_levels = 1;
  Hierarchy hierarchy;
  const double ours = timed([&] { hierarchy = *coarsen(mesh, options); });
  const TriangleMesh& level = hierarchy.levels.back().mesh;
  const AngleStatistics angles = angle_statistics(level);
  std::printf(
      "one coarsening of a uniform mesh: %zu to %zu nodes, smallest angle %.1f, %.3f s",
      mesh.points.size(), level.points.size(),
      std::min(angles.interior_min_deg.value_or(180), angles.boundary_min_deg.value_or(180)), ours);
  const double mmg = seconds_of_mmg(mesh, 2.0);
  if (mmg > 0) {
    std::printf("; mmg2d takes %.1f times as long\n", mmg / ours);
  } else {
    std::printf(" (mmg2d is not there)\n");
  }
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced::bench;
  const long largest = argc > 1 ? std::atol(argv[1]) : 1000000;
#ifdef WELLSPACED_BENCH_P4EST
  sc_MPI_Init(&argc, &argv);
  sc_init(sc_MPI_COMM_SELF, 0, 0, nullptr, SC_LP_ERROR);
  p4est_init(nullptr, SC_LP_ERROR);
#endif
  compare_with_p4est();
  compare_with_mmg();
  print_growth(static_cast<std::size_t>(std::max(largest, 100000L)));
#ifdef WELLSPACED_BENCH_P4EST
  sc_finalize();
  sc_MPI_Finalize();
#endif
  return 0;
}
