// Our Delaunay triangulation of space beside CGAL's: CPU time as a ratio, from interleaved runs in
// one process, and peak memory a point. Answers are checked outside the clock.
//
//   delaunay3_table [RUNS]       default 3
//   delaunay3_table RUNS ROW     only the rows whose name contains ROW
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/generate/points3.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

#ifdef WELLSPACED_BENCH_CGAL
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

namespace wellspaced::bench {
namespace {

using Points = std::vector<Point3>;

struct Row {
  std::string name;
  double reach;  // the ratio to CGAL that is aimed at; 0: none
  Points (*make)();
};

Points shuffled(Points points) {
  shuffle_points(points, 1);
  return points;
}

Points scaled(Points points, double by) {
  for (Point3& p : points) p = {p.x * by, p.y * by, p.z * by};
  return points;
}

const std::vector<Row> kRows = {
    {"uniform 1M", 0.45, [] { return box_points3(1000000, 1); }},
    {"lattice 100^3 shuffled", 0.60, [] { return shuffled(lattice_points3(100, 100, 100)); }},
    {"sphere 300k, rounded", 0.60, [] { return sphere_points3(300000, 1); }},
    {"two skew lines of 1500", 0.45, [] { return shuffled(line_points3(1500)); }},
    {"uniform 100k", 0, [] { return box_points3(100000, 1); }},
    {"lattice 50^3 of hundredths", 0,
     [] { return shuffled(scaled(lattice_points3(50, 50, 50), 0.01)); }},
    {"lattice 100^3 in rows", 0, [] { return lattice_points3(100, 100, 100); }},
    {"helix 3000", 0, [] { return shuffled(helix_points3(3000, 100, 1)); }},
};

Delaunay3 triangulate_ours(const Points& points) { return *Delaunay3::build(points); }

bool have_same_tets(const Triangulation3& a, const Triangulation3& b) {
  if (a.size() != b.size()) return false;
  for (Index t = 0; t < a.size(); ++t)
    if (a.vertices(t) != b.vertices(t) || a.links(t) != b.links(t)) return false;
  return true;
}

void print_threads(const Points& points, int runs) {
  print_two_threads(
      runs, " (reach 0.70)",
      [&](unsigned threads) { return *Delaunay3::build(points, {.threads = threads}); },
      [](const Delaunay3& a, const Delaunay3& b) {
        return have_same_tets(a.topology(), b.topology());
      });
}

struct Counts {
  std::size_t tets = 0, tied_facets = 0;
};

// No tets if one is not positive or a facet fails the exact in-sphere test.
Counts checked_counts(const Delaunay3& dt) {
  const Triangulation3& mesh = dt.topology();
  const auto& p = dt.points();
  Counts counts;
  for (Index t = 0; t < mesh.size(); ++t) {
    if (mesh.is_ghost(t)) continue;
    ++counts.tets;
    const auto& v = mesh.vertices(t);
    if (orient3d(p[v[1]], p[v[0]], p[v[2]], p[v[3]]) <= 0) return {};
    for (unsigned i = 0; i < 4; ++i) {
      const Index far = mesh.apex(mesh.mirror({t, i}));
      if (far == Triangulation3::kGhost) continue;
      const int in = insphere(p[v[1]], p[v[0]], p[v[2]], p[v[3]], p[far]);
      if (in > 0) return {};
      counts.tied_facets += in == 0;
    }
  }
  return counts;
}

#ifdef WELLSPACED_BENCH_CGAL
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoints = std::vector<Kernel::Point_3>;

CgalPoints cgal_points(const Points& points) {
  CgalPoints result;
  for (const Point3 p : points) result.emplace_back(p.x, p.y, p.z);
  return result;
}

std::size_t triangulate_cgal(const CgalPoints& points) {
  const CGAL::Delaunay_triangulation_3<Kernel> dt(points.begin(), points.end());
  return dt.number_of_finite_cells();
}
#else
using CgalPoints = std::vector<Point3>;
CgalPoints cgal_points(const Points&) { return {}; }
std::size_t triangulate_cgal(const CgalPoints&) { return 0; }
#endif

struct Times {
  double ours = 0, peer = 0;
  const char* verdict = "";
};

// With ties the number of tets is not unique; then our own check must do.
const char* verdict_on(const Counts& ours, std::size_t peer) {
  if (ours.tets == 0) return "WRONG";
  if (peer == 0 || ours.tied_facets > 0) return "valid";
  return ours.tets == peer ? "same" : "DIFFERENT";
}

Times measure(const Points& points, int runs) {
  std::vector<double> ours, peer;
  Counts our_counts;
  std::size_t peer_tets = 0;
  const CgalPoints input = cgal_points(points);
  for (int run = 0; run < runs; ++run) {
    {
      Delaunay3 dt;
      ours.push_back(timed([&] { dt = triangulate_ours(points); }));
      if (run == 0) our_counts = checked_counts(dt);
    }
    peer.push_back(input.empty() ? 0 : timed([&] { peer_tets = triangulate_cgal(input); }));
  }
  return {median(ours), median(peer), verdict_on(our_counts, peer_tets)};
}

void print_row(const Row& row, int runs, double bytes) {
  const Points points = row.make();
  const double n = static_cast<double>(points.size());
  const Times times = measure(points, runs);
  std::printf("%-30s %8.0f %7.0f %9.3f", row.name.c_str(), n, bytes / n, 1e6 * times.ours / n);
  if (times.peer > 0)
    std::printf(" %9.3f", times.ours / times.peer);
  else
    std::printf("         -");
  if (row.reach > 0)
    std::printf(" %9.2f", row.reach);
  else
    std::printf("         -");
  std::printf("  %s\n", times.verdict);
  std::fflush(stdout);
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced::bench;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const auto is_wanted = [&](const Row& row) {
    return argc <= 2 || row.name.find(argv[2]) != std::string::npos;
  };
  std::printf("%-30s %8s %7s %9s %9s %9s  %s\n", "3D (median CPU of interleaved runs)", "points",
              "B/point", "us/point", "t/CGAL", "reach", "tets");
  std::vector<double> bytes;  // before anything else is allocated and freed here
  for (const Row& row : kRows)
    bytes.push_back(is_wanted(row) ? peak_growth(row.make, triangulate_ours) : 0);
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (is_wanted(kRows[i])) print_row(kRows[i], runs, bytes[i]);
  if (is_wanted(kRows[0])) print_threads(kRows[0].make(), std::max(runs, 5));
}
