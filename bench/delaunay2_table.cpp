// Our Delaunay triangulation of the plane beside CGAL's: CPU time as a ratio, from interleaved
// runs in one process, and peak memory a point. Answers are compared outside the clock.
//
//   delaunay2_table [RUNS]       default 5
//   delaunay2_table RUNS ROW     only the rows whose name contains ROW
//   delaunay2_table --write DIR  the rows' inputs as files, and their SHA-256 in DIR/SHA256SUMS
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/algorithms/mesh/delaunay_cells.hpp"
#include "wellspaced/io/formats/point_files.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/sha256.hpp"

#ifdef WELLSPACED_BENCH_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Unique_hash_map.h>
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

// What a triangulation is compared by. cells: the hash that every correct answer shares, however
// its ties are broken; empty beyond 2^21 points, where it would take too much memory.
struct Answer {
  std::size_t triangles = 0;
  std::string cells;
  friend bool operator==(const Answer&, const Answer&) = default;
};

std::string hash_if_small(const std::vector<Point2>& points,
                          const std::vector<std::array<Index, 3>>& triangles,
                          const std::vector<Segment>& segments) {
  if (points.size() > std::size_t{1} << 21) return {};
  return cells_sha256(points, delaunay_cells(points, triangles, segments));
}

// No triangle counts where an edge fails the exact in-circle test.
Answer answer_of(const Delaunay2& dt) {
  if (!dt.is_valid()) return {};
  const Triangulation2& mesh = dt.topology();
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Segment> segments;
  for (Index t = 0; t < mesh.size(); ++t) {
    if (mesh.is_ghost(t)) continue;
    triangles.push_back(mesh.vertices(t));
    for (unsigned i = 0; i < 3; ++i)
      if (mesh.is_constrained({t, i}))
        segments.push_back({mesh.origin({t, i}), mesh.destination({t, i})});
  }
  return {triangles.size(), hash_if_small(dt.points(), triangles, segments)};
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

void insert_all(const CgalInput& input, CgalDelaunay& dt) {
  dt.insert(input.points.begin(), input.points.end());
}

void insert_all(const CgalInput& input, CgalConstrained& dt) {
  dt.insert_constraints(input.points.begin(), input.points.end(), input.segments.begin(),
                        input.segments.end());
}

template <class Triangulation>
Answer answer_of(const Triangulation& dt) {
  std::vector<Point2> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Segment> segments;
  CGAL::Unique_hash_map<typename Triangulation::Vertex_handle, Index> number;
  for (const auto v : dt.finite_vertex_handles()) {
    number[v] = static_cast<Index>(points.size());
    points.push_back({v->point().x(), v->point().y()});
  }
  for (const auto f : dt.finite_face_handles()) {
    triangles.push_back({number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)]});
    if constexpr (std::is_same_v<Triangulation, CgalConstrained>)
      for (int i = 0; i < 3; ++i)
        if (f->is_constrained(i))
          segments.push_back({number[f->vertex(dt.ccw(i))], number[f->vertex(dt.cw(i))]});
  }
  return {triangles.size(), hash_if_small(points, triangles, segments)};
}

// Its CPU time; its answer only if there is none yet.
template <class Triangulation>
double time_cgal_as(const CgalInput& input, Answer& answer) {
  Triangulation dt;
  const double seconds = timed([&] { insert_all(input, dt); });
  if (answer.triangles == 0) answer = answer_of(dt);
  return seconds;
}

double time_cgal(const CgalInput& input, Answer& answer) {
  return input.segments.empty() ? time_cgal_as<CgalDelaunay>(input, answer)
                                : time_cgal_as<CgalConstrained>(input, answer);
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
  Answer our_answer, peer_answer;
  const CgalInput input = cgal_input(graph);
  for (int run = 0; run < runs; ++run) {
    {
      Delaunay2 dt;
      ours.push_back(timed([&] { dt = triangulate_ours(graph); }));
      if (run == 0) our_answer = answer_of(dt);
    }
#ifdef WELLSPACED_BENCH_CGAL
    peer.push_back(time_cgal(input, peer_answer));
#else
    peer.push_back(0);
    peer_answer = our_answer;
#endif
  }
  return {median(ours), median(peer), our_answer.triangles != 0 && our_answer == peer_answer};
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

bool have_same_triangles(const Triangulation2& a, const Triangulation2& b) {
  if (a.size() != b.size()) return false;
  for (Index t = 0; t < a.size(); ++t)
    for (unsigned i = 0; i < 3; ++i)
      if (a.vertex(t, i) != b.vertex(t, i) || a.mirror({t, i}) != b.mirror({t, i})) return false;
  return true;
}

void print_threads(const std::vector<Point2>& points, int runs) {
  print_two_threads(
      runs, "", [&](unsigned threads) { return *Delaunay2::build(points, {.threads = threads}); },
      [](const Delaunay2& a, const Delaunay2& b) {
        return have_same_triangles(a.topology(), b.topology());
      });
}

// The CPU time a point, the median of `runs` after one that does not count.
double time_per_point(std::size_t count, int runs) {
  const Pslg graph = points_only(random_points(count, 1));
  std::vector<double> seconds;
  for (int run = 0; run <= runs; ++run) {
    Delaunay2 dt;
    seconds.push_back(timed([&] { dt = triangulate_ours(graph); }));
  }
  seconds.erase(seconds.begin());
  return median(seconds) / static_cast<double>(count);
}

// How much longer a point takes among 10^7 than among 10^5, when neither has to pay the system for
// fresh pages. Runs of 10^5 points find theirs among what was freed before in any case.
void print_growth(int runs) {
  keep_freed_memory();
  const double few = time_per_point(100000, 20 * runs), many = time_per_point(10000000, runs);
  std::printf("10^5 to 10^7 points, memory kept: %.0f to %.0f ns a point, %.2f (reach < 1.60)\n",
              1e9 * few, 1e9 * many, many / few);
}

// "997 holes, 300k segments" as "997_holes_300k_segments".
std::string file_name(const Row& row) {
  std::string name;
  for (const char c : row.name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  return name;
}

// Points as .f64, domains as .poly: what any other program needs to repeat a row.
int write_inputs(const std::string& directory) {
  std::ofstream sums(directory + "/SHA256SUMS");
  for (const Row& row : kRows) {
    Pslg graph = row.make();
    const bool domain = !graph.segments.empty();
    Geometry geometry;
    geometry.mesh.points = std::move(graph.points);
    geometry.mesh.segments = std::move(graph.segments);
    TextWriter out;
    domain ? write_poly(out, geometry, PolyPoints::kInside) : write_f64(out, geometry);
    const std::string name = file_name(row) + (domain ? ".poly" : ".f64");
    std::ofstream(directory + '/' + name, std::ios::binary) << out.text();
    sums << sha256(out.text()) << "  " << name << '\n';
  }
  sums.close();
  if (!sums) std::fprintf(stderr, "cannot write to %s\n", directory.c_str());
  return sums ? 0 : 1;
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced::bench;
  if (argc == 3 && std::string(argv[1]) == "--write") return write_inputs(argv[2]);
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf("%-30s %8s %7s %9s %9s %9s  %s\n", "2D (median CPU of interleaved runs)", "points",
              "B/point", "t/uniform", "t/CGAL", "reach", "triangles");
  std::vector<Row> rows;
  for (const Row& row : kRows)
    if (argc <= 2 || row.name.find(argv[2]) != std::string::npos) rows.push_back(row);
  std::vector<double> bytes;  // before anything else is allocated and freed here
  for (const Row& row : rows) bytes.push_back(peak_growth(row.make, triangulate_ours));
  double uniform = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) print_row(rows[i], runs, bytes[i], uniform);
  if (argc > 2) return 0;
  print_threads(wellspaced::random_points(1000000, 1), std::max(runs, 5));
  print_growth(runs);
}
