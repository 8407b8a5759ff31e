// Packing of planar domains. First its CPU time beside that of our own constrained Delaunay
// triangulation of the same nodes and segments, from interleaved runs; then the number of nodes at
// a smallest angle of 25 degrees beside CGAL's Delaunay_mesher_2.
//
//   packing_table [RUNS]      default 3; real domains come from $WELLSPACED_DATA
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/packing/pack_domain.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/kernel/angle.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"

#ifdef WELLSPACED_BENCH_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

namespace wellspaced::bench {
namespace {

Pslg unit_square() {
  Pslg domain;
  domain.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return domain;
}

Pslg wing() { return *generate_graded_boundary(GradedDomain::kAirfoil, {.nodes = 5000}); }

// ---- Time ----------------------------------------------------------------------------------

void print_time(const char* name, const Pslg& domain, const PackingOptions& options, int runs) {
  std::vector<double> packing, triangulation;
  PackedMesh packed;
  for (int run = 0; run < runs; ++run) {
    packing.push_back(timed([&] { packed = *pack_domain(domain, options); }));
    Pslg nodes;
    nodes.points = packed.mesh.points;
    nodes.segments = packed.mesh.segments;
    std::size_t triangles = 0;
    triangulation.push_back(timed([&] { triangles = triangulate(nodes)->triangles().size(); }));
    if (triangles == 0) std::abort();
  }
  std::printf("%-34s %9zu %9zu %9.2f\n", name, packed.mesh.points.size(),
              packed.mesh.triangles.size(), median(packing) / median(triangulation));
}

// ---- Nodes ---------------------------------------------------------------------------------

constexpr double kAngle = 25;

double smallest_angle(const TriangleMesh& mesh) {
  double largest = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Point2 a = mesh.points[i], b = mesh.points[j], c = mesh.points[k];
    largest = std::max(
        {largest, corner_cotangent(a, b, c), corner_cotangent(b, c, a), corner_cotangent(c, a, b)});
  }
  return arccotangent_deg(largest);
}

struct PeerMesh {
  std::size_t nodes = 0;
  double smallest_angle = 0;
};

PeerMesh mesh_of_cgal([[maybe_unused]] const Pslg& domain) {
#ifdef WELLSPACED_BENCH_CGAL
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Structure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                         CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  Triangulation cdt;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point2 p : domain.points) vertices.push_back(cdt.insert({p.x, p.y}));
  for (const Segment& s : domain.segments) cdt.insert_constraint(vertices[s.a], vertices[s.b]);
  std::list<Kernel::Point_2> seeds;
  for (const Point2 hole : domain.holes) seeds.emplace_back(hole.x, hole.y);
  const double sine = std::sin(kAngle * std::acos(-1.0) / 180);
  CGAL::refine_Delaunay_mesh_2(cdt, seeds.begin(), seeds.end(), Criteria(sine * sine, 0));
  TriangleMesh mesh;
  std::set<const void*> nodes;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    if (!face->is_in_domain()) continue;
    const Index first = static_cast<Index>(mesh.points.size());
    for (int i = 0; i < 3; ++i) {
      nodes.insert(&*face->vertex(i));
      mesh.points.push_back({face->vertex(i)->point().x(), face->vertex(i)->point().y()});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return {nodes.size(), smallest_angle(mesh)};
#else
  return {};
#endif
}

void print_nodes(const char* name, const Pslg& domain) {
  PackingOptions options;
  options.smallest_angle_deg = kAngle;
  options.holes = HoleRule::kSeeds;
  options.sharp_corners = SharpCorners::kMesh;
  const PackedMesh ours = *pack_domain(domain, options);
  const PeerMesh peer = mesh_of_cgal(domain);
  std::printf("%-34s %9zu %9.2f", name, ours.mesh.points.size(), smallest_angle(ours.mesh));
  if (peer.nodes > 0)
    std::printf(" %9zu %9.2f %9.2f\n", peer.nodes, peer.smallest_angle,
                static_cast<double>(ours.mesh.points.size()) / static_cast<double>(peer.nodes));
  else
    std::printf("         -         -         -\n");
}

void print_nodes_of_file(const char* name) {
  const char* folder = std::getenv("WELLSPACED_DATA");
  const auto geometry = read_geometry((folder != nullptr ? folder : "../shared/data") +
                                      std::string("/pslg/") + name + ".poly");
  if (geometry) print_nodes(name, to_pslg(*geometry));
}

}  // namespace
}  // namespace wellspaced::bench

int main(int argc, char** argv) {
  using namespace wellspaced;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  std::printf("%-34s %9s %9s %9s\n", "packing (median CPU)", "nodes", "triangles", "t/CDT");
  PackingOptions uniform, graded;
  uniform.size = [](Point2) { return 0.00118; };
  bench::print_time("unit square, constant size", bench::unit_square(), uniform, runs);
  graded.beta = 70;
  graded.sharp_corners = SharpCorners::kMesh;
  graded.holes = HoleRule::kSeeds;
  bench::print_time("wing, beta 70", bench::wing(), graded, runs);

  std::printf("\n%-34s %9s %9s %9s %9s %9s\n", "smallest angle 25", "nodes", "angle", "CGAL",
              "angle", "nodes/CGAL");
  bench::print_nodes("wing", bench::wing());
  for (const char* name : {"triangle_A", "mesh2d_lake", "mesh2d_airfoil", "cdt_guitar"})
    bench::print_nodes_of_file(name);
}
