// The auditor beside our own triangulation of the same points: CPU time as a ratio, from
// interleaved runs in one process. The verdict is looked at outside the clock.
//
//   audit_table [RUNS]      default 5
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/audit/intersection.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced::bench {
namespace {

struct Times {
  std::vector<double> triangulation, audit;

  void print(const char* name, std::size_t elements, bool pass) const {
    std::printf("%-36s %9zu %9.3f %9.3f   %s\n", name, elements, median(audit),
                median(audit) / median(triangulation), pass ? "pass" : "FAIL");
  }
};

TriangleMesh mesh_of(const Delaunay2& delaunay) {
  TriangleMesh mesh;
  mesh.points = delaunay.points();
  for (Index t = 0; t < delaunay.topology().size(); ++t)
    if (!delaunay.topology().is_ghost(t)) mesh.triangles.push_back(delaunay.topology().vertices(t));
  return mesh;
}

TetMesh mesh_of(const Delaunay3& delaunay) {
  TetMesh mesh;
  mesh.points = delaunay.points();
  for (Index t = 0; t < delaunay.topology().size(); ++t)
    if (!delaunay.topology().is_ghost(t)) mesh.tets.push_back(delaunay.topology().vertices(t));
  return mesh;
}

void plane(const char* name, const std::vector<Point2>& points, int runs) {
  Times times;
  std::size_t elements = 0;
  bool pass = true;
  for (int run = 0; run < runs; ++run) {
    Delaunay2 delaunay;
    times.triangulation.push_back(timed([&] { delaunay = *Delaunay2::build(points); }));
    const TriangleMesh mesh = mesh_of(delaunay);
    audit::Report report;
    times.audit.push_back(timed([&] { report = audit::audit_mesh(mesh); }));
    pass &= report.pass() && report.check("delaunay")->pass();
    elements = mesh.triangles.size();
  }
  times.print(name, elements, pass);
}

void space(const char* name, const std::vector<Point3>& points, int runs) {
  Times times;
  std::size_t elements = 0;
  bool pass = true;
  for (int run = 0; run < runs; ++run) {
    Delaunay3 delaunay;
    times.triangulation.push_back(timed([&] { delaunay = *Delaunay3::build(points); }));
    const TetMesh mesh = mesh_of(delaunay);
    audit::Report report;
    times.audit.push_back(timed([&] { report = audit::audit_tet_mesh(mesh); }));
    pass &= report.pass() && report.check("delaunay")->pass();
    elements = mesh.tets.size();
  }
  times.print(name, elements, pass);
}

// A level of every fourth point of a million.
void intersections(int runs) {
  const std::vector<Point2> points = random_points(1'000'000, 1);
  std::vector<Point2> kept;
  std::vector<Index> origin;
  for (Index v = 0; v < points.size(); v += 4) {
    kept.push_back(points[v]);
    origin.push_back(v);
  }
  const TriangleMesh coarse = mesh_of(*Delaunay2::build(kept));
  Times times;
  audit::Intersections found;
  for (int run = 0; run < runs; ++run) {
    Delaunay2 delaunay;
    times.triangulation.push_back(timed([&] { delaunay = *Delaunay2::build(points); }));
    const TriangleMesh fine = mesh_of(delaunay);
    times.audit.push_back(timed([&] { found = audit::count_intersections(fine, coarse, origin); }));
  }
  times.print("intersections, 1M nodes to 250k", coarse.triangles.size(),
              found.mean_per_coarse() > 1);
}

// How well points are spaced by NN, all gaps bracketed: beside the triangulation of the same
// points.
template <class Mesh>
void spacing(const char* name, const Mesh& mesh, std::vector<double> triangulation, int runs) {
  Times times;
  times.triangulation = std::move(triangulation);
  bool pass = true;
  for (int run = 0; run < runs; ++run) {
    audit::Report report;
    times.audit.push_back(timed([&] { audit::audit_spacing(mesh, {}, report); }));
    pass &= report.check("well_spaced")->pass();
  }
  times.print(name, mesh.points.size(), pass);
}

void spacing_of_plane(const char* name, const std::vector<Point2>& points, int runs) {
  Delaunay2 delaunay;
  std::vector<double> times;
  for (int run = 0; run < runs; ++run)
    times.push_back(timed([&] { delaunay = *Delaunay2::build(points); }));
  spacing(name, mesh_of(delaunay), std::move(times), runs);
}

void spacing_of_space(const char* name, const std::vector<Point3>& points, int runs) {
  Delaunay3 delaunay;
  std::vector<double> times;
  for (int run = 0; run < runs; ++run)
    times.push_back(timed([&] { delaunay = *Delaunay3::build(points); }));
  spacing(name, mesh_of(delaunay), std::move(times), runs);
}

std::vector<Point3> random_points3(std::size_t count) {
  Random random(1);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  std::printf("%-36s %9s %9s %9s\n", "audit (median CPU)", "elements", "seconds", "t/ours");
  bench::plane("500k random points", random_points(500'000, 1), runs);
  bench::plane("500k points in clusters", clustered_points(500'000, 100, 1), runs);
  bench::plane("707 x 707 grid", grid_points(707, 707), runs);
  bench::intersections(runs);
  bench::space("150k random points in space", bench::random_points3(150'000), runs);
  bench::spacing_of_plane("spacing of 100k random points", random_points(100'000, 1), runs);
  bench::spacing_of_space("spacing of 100k points in space", bench::random_points3(100'000), runs);
}
