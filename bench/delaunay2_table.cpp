// Our Delaunay triangulation of the plane beside CGAL's: CPU time as a ratio, from interleaved
// runs in one process, and peak memory a point. Answers are compared outside the clock.
//
//   delaunay2_table [RUNS]       default 5
//   delaunay2_table RUNS ROW     only the rows whose name contains ROW
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/kernel/delaunay2.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/triangulate.hpp"

#ifdef WELLSPACED_BENCH_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

namespace wellspaced::bench {
namespace {

struct Row {
  std::string name;
  double reach;  // the ratio to CGAL that is aimed at; 0: measured against the uniform row instead
  std::function<Pslg()> make;
};

Pslg points_only(std::vector<Point2> points) {
  Pslg graph;
  graph.points = std::move(points);
  return graph;
}

Pslg shuffled(std::vector<Point2> points) {
  shuffle_points(points, 1);
  return points_only(std::move(points));
}

// Points on a jittered grid, and constraints between grid neighbours: they cannot cross.
Pslg random_constraints(std::size_t side, std::size_t count) {
  Pslg graph;
  Random random(7);
  for (std::size_t i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(i % side) + random.uniform(-0.3, 0.3);
    graph.points.push_back({x, static_cast<double>(i / side) + random.uniform(-0.3, 0.3)});
  }
  while (graph.segments.size() < count) {
    const Index at = static_cast<Index>(random.below(side * (side - 1)));
    if (at % side + 1 == side) continue;
    const bool along = random.below(2) == 0;
    graph.segments.push_back({at, static_cast<Index>(at + (along ? 1 : side))});
  }
  return graph;
}

// A square with 997 round holes in a 32 x 32 arrangement, about 300 points and segments a ring.
Pslg polygon_with_holes() {
  Pslg graph;
  const auto add_ring = [&](Point2 centre, double radius, Index corners) {
    const Index first = static_cast<Index>(graph.points.size());
    for (const Point2 p : circle_points(corners, 0, centre.x < 0 ? 1 : first))
      graph.points.push_back({centre.x + radius * p.x, centre.y + radius * p.y});
    std::sort(graph.points.begin() + first, graph.points.end(), [&](Point2 p, Point2 q) {
      const bool p_up = p.y > centre.y, q_up = q.y > centre.y;
      return p_up != q_up ? p_up : p_up ? p.x > q.x : p.x < q.x;
    });
    for (Index k = 0; k < corners; ++k)
      graph.segments.push_back({first + k, first + (k + 1) % corners});
  };
  for (int hole = 0; hole < 997; ++hole) add_ring({hole % 32 + 0.5, hole / 32 + 0.5}, 0.4, 300);
  add_ring({16, 16}, 30, 900);
  return graph;
}

const std::vector<Row> kRows = {
    {"uniform 1M", 0.35, [] { return points_only(random_points(1000000, 1)); }},
    {"clusters 1M", 0.55, [] { return points_only(clustered_points(1000000, 1000, 1)); }},
    {"grid 1000x1000 shuffled", 0.55, [] { return shuffled(grid_points(1000, 1000)); }},
    {"grid 1000x1000 in rows", 0.55, [] { return points_only(grid_points(1000, 1000)); }},
    {"circle 100k + 900k inside", 0.55,
     [] { return points_only(circle_points(100000, 900000, 1)); }},
    {"600k points, 100k constraints", 0.60, [] { return random_constraints(775, 100000); }},
    {"997 holes, 300k segments", 0.60, [] { return polygon_with_holes(); }},
    {"50k collinear + 1", 0, [] { return points_only(collinear_points_and_one(50000)); }},
    {"100k copies of 10", 0, [] { return points_only(repeated_points(100000, 10, 1)); }},
    {"20k on a parabola", 0, [] { return points_only(parabola_points(20000)); }},
    {"uniform 100k", 0, [] { return points_only(random_points(100000, 1)); }},
    {"uniform 10M", 0, [] { return points_only(random_points(10000000, 1)); }},
    {"spiral 100k over 2^40", 0, [] { return points_only(spiral_points(100000, 40)); }},
};

// Our side: the complete structure, with input numbers.
Delaunay2 triangulate_ours(const Pslg& graph) {
  Delaunay2 dt = *Delaunay2::build(graph.points);
  for (const Segment& s : graph.segments)
    if (!dt.insert_constraint(s.a, s.b)) std::abort();
  return dt;
}

// The real triangles, or 0 if an edge fails the exact in-circle test.
std::size_t checked_triangles(const Delaunay2& dt) {
  const Triangulation2& mesh = dt.topology();
  const auto& p = dt.points();
  std::size_t count = 0;
  for (Index t = 0; t < mesh.size(); ++t) {
    if (mesh.is_ghost(t)) continue;
    ++count;
    const auto& v = mesh.vertices(t);
    for (unsigned i = 0; i < 3; ++i) {
      const Index far = mesh.apex(mesh.mirror({t, i}));
      if (far == Triangulation2::kGhost || mesh.is_constrained({t, i})) continue;
      if (incircle(p[v[0]], p[v[1]], p[v[2]], p[far]) > 0) return 0;
    }
  }
  return count;
}

#ifdef WELLSPACED_BENCH_CGAL
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalDelaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using CgalConstrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

struct CgalInput {
  std::vector<Kernel::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> segments;
};

CgalInput cgal_input(const Pslg& graph) {
  CgalInput input;
  for (const Point2 p : graph.points) input.points.emplace_back(p.x, p.y);
  for (const Segment& s : graph.segments) input.segments.emplace_back(s.a, s.b);
  return input;
}

std::size_t triangulate_cgal(const CgalInput& input) {
  if (input.segments.empty()) {
    CgalDelaunay dt;
    dt.insert(input.points.begin(), input.points.end());
    return dt.number_of_faces();
  }
  CgalConstrained dt;
  dt.insert_constraints(input.points.begin(), input.points.end(), input.segments.begin(),
                        input.segments.end());
  return dt.number_of_faces();
}
#else
struct CgalInput {};
CgalInput cgal_input(const Pslg&) { return {}; }
#endif

struct Times {
  double ours = 0, peer = 0;
  bool agree = true;
};

Times measure(const Pslg& graph, int runs) {
  std::vector<double> ours, peer;
  std::size_t our_count = 0, peer_count = 0;
  const CgalInput input = cgal_input(graph);
  for (int run = 0; run < runs; ++run) {
    {
      Delaunay2 dt;
      ours.push_back(timed([&] { dt = triangulate_ours(graph); }));
      if (run == 0) our_count = checked_triangles(dt);
    }
#ifdef WELLSPACED_BENCH_CGAL
    peer.push_back(timed([&] { peer_count = triangulate_cgal(input); }));
#else
    peer.push_back(0);
    peer_count = our_count;
#endif
  }
  return {median(ours), median(peer), our_count != 0 && our_count == peer_count};
}

void print_row(const Row& row, int runs, double bytes, double& uniform) {
  const Pslg graph = row.make();
  const double n = static_cast<double>(graph.points.size());
  const Times times = measure(graph, runs);
  const double per_point = times.ours / n;
  if (uniform == 0) uniform = per_point;
  std::printf("%-30s %8.0f %7.0f %9.3f", row.name.c_str(), n, bytes / n, per_point / uniform);
  if (times.peer > 0)
    std::printf(" %9.3f", times.ours / times.peer);
  else
    std::printf("         -");
  if (row.reach > 0)
    std::printf(" %9.2f", row.reach);
  else
    std::printf("  <= 5 uni");
  std::printf("  %s\n", times.agree ? "same" : "DIFFERENT");
  std::fflush(stdout);
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced::bench;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf("%-30s %8s %7s %9s %9s %9s  %s\n", "2D (median CPU of interleaved runs)", "points",
              "B/point", "t/uniform", "t/CGAL", "reach", "triangles");
  std::vector<double> bytes;  // before anything else is allocated and freed here
  for (const Row& row : kRows) bytes.push_back(peak_growth(row.make, triangulate_ours));
  double uniform = 0;
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (argc <= 2 || kRows[i].name.find(argv[2]) != std::string::npos)
      print_row(kRows[i], runs, bytes[i], uniform);
}
