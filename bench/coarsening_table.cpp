// A whole coarsening sequence beside CGAL's Delaunay triangulation of the same points, and all
// transfers of a hierarchy for solvers beside its coarsening: CPU time as a ratio, from interleaved
// runs in one process.
//
//   coarsening_table [RUNS]      default 3
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/algorithms/transfer/transfer.hpp"

#ifdef WELLSPACED_BENCH_CGAL
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

namespace wellspaced::bench {
namespace {

struct Row {
  const char* name;
  CoarseningMethod method;
  double factor;
};

constexpr Row kRows[] = {{"GRID(1) 1M, function-based, C 2", CoarseningMethod::kFunction, 2},
                         {"GRID(1) 1M, MIS-based", CoarseningMethod::kMis, 2}};

double time_of_cgal(const TriangleMesh& mesh) {
#ifdef WELLSPACED_BENCH_CGAL
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  for (const Point2 p : mesh.points) points.emplace_back(p.x, p.y);
  CGAL::Delaunay_triangulation_2<Kernel> dt;
  return timed([&] { dt.insert(points.begin(), points.end()); });
#else
  return mesh.points.empty() ? 0 : -1;
#endif
}

void print_row(const Row& row, const TriangleMesh& mesh, int runs) {
  CoarseningOptions options;
  options.method = row.method;
  options.factor = row.factor;
  std::vector<double> ours, peer;
  std::size_t levels = 0, nodes = 0;
  for (int run = 0; run < runs; ++run) {
    TriangleMesh input = mesh;
    Hierarchy hierarchy;
    ours.push_back(timed([&] { hierarchy = *coarsen(std::move(input), options); }));
    peer.push_back(time_of_cgal(mesh));
    levels = hierarchy.levels.size() - 1;
    nodes = 0;
    for (const Level& level : hierarchy.levels) nodes += level.mesh.points.size();
  }
  std::printf("%-34s %7zu %9zu", row.name, levels, nodes);
  if (median(peer) > 0)
    std::printf(" %9.3f\n", median(ours) / median(peer));
  else
    std::printf("         -\n");
}

void print_transfers(const TriangleMesh& mesh, int runs) {
  std::vector<double> coarsening, transferring;
  std::size_t levels = 0, rows = 0;
  for (int run = 0; run < runs; ++run) {
    TriangleMesh input = mesh;
    Hierarchy hierarchy;
    std::vector<Transfer> transfers;
    coarsening.push_back(
        timed([&] { hierarchy = *coarsen(std::move(input), multigrid_profile()); }));
    transferring.push_back(timed([&] { transfers = *transfers_of(hierarchy); }));
    levels = transfers.size();
    rows = 0;
    for (const Transfer& transfer : transfers) rows += transfer.prolongation.rows();
  }
  std::printf("%-34s %7s %9s %9s\n", "transfers (median CPU)", "levels", "all rows", "t/coarsen");
  std::printf("%-34s %7zu %9zu %9.3f\n", "GRID(1) 1M, profile multigrid", levels, rows,
              median(transferring) / median(coarsening));
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  GridOptions options;
  options.diagonals = GridDiagonals::kMixed;
  options.mixed = 0.13;
  const TriangleMesh mesh = *generate_grid(options);
  std::printf("%-34s %7s %9s %9s\n", "coarsening (median CPU)", "levels", "all nodes", "t/CGAL");
  for (const bench::Row& row : bench::kRows) bench::print_row(row, mesh, runs);
  bench::print_transfers(mesh, runs);
}
