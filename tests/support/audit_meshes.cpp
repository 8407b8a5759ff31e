#include "tests/support/audit_meshes.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "tests/support/data_files.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/plane/delaunay2.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced::test {
namespace {

double rounded(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

Point2 rounded(Point2 p) { return {rounded(p.x), rounded(p.y)}; }

TriangleMesh scaled_grid(Index nx, Index ny, GridDiagonals diagonals) {
  return generate_grid({.nx = nx, .ny = ny, .diagonals = diagonals}).value();
}

}  // namespace

void add_boundary_segments(TriangleMesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert({t[i], t[(i + 1) % 3]});
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) mesh.segments.push_back({a, b, 1});
}

TriangleMesh random_mesh(std::size_t nodes, std::uint64_t seed) {
  Random random(seed);
  TriangleMesh mesh;
  for (std::size_t i = 0; i < nodes; ++i)
    mesh.points.push_back(rounded({random.uniform(), random.uniform()}));
  const Delaunay2 delaunay = Delaunay2::build(mesh.points).value();
  for (Index t = 0; t < delaunay.topology().size(); ++t)
    if (!delaunay.topology().is_ghost(t)) mesh.triangles.push_back(delaunay.topology().vertices(t));
  add_boundary_segments(mesh);
  return mesh;
}

TriangleMesh annulus(Index n) {
  TriangleMesh mesh;
  for (Index i = 0; i < n; ++i) {
    mesh.points.push_back(rounded(circle_point(double(i) / n)));
    const Point2 p = circle_point((i + 0.5) / n);
    mesh.points.push_back(rounded({1.25 * p.x, 1.25 * p.y}));
  }
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * j});
    mesh.triangles.push_back({2 * i + 1, 2 * j + 1, 2 * j});
  }
  add_boundary_segments(mesh);
  return mesh;
}

TriangleMesh slit_square(Index n) {
  const Index nodes = 2 * n + 1;
  TriangleMesh mesh = scaled_grid(nodes, nodes, GridDiagonals::kSlash);
  const Index row = n * nodes, copies = static_cast<Index>(mesh.points.size());
  for (Index i = 0; i < n; ++i) mesh.points.push_back(mesh.points[row + i]);
  for (auto& t : mesh.triangles) {
    const double height = mesh.points[t[0]].y + mesh.points[t[1]].y + mesh.points[t[2]].y;
    for (Index& v : t)
      if (height > 3.0 * n && v >= row && v < row + n) v = copies + (v - row);
  }
  mesh.segments.clear();
  add_boundary_segments(mesh);
  return mesh;
}

TriangleMesh side_by_side(const TriangleMesh& a, const TriangleMesh& b, Point2 offset) {
  TriangleMesh mesh = a;
  const auto shift = static_cast<Index>(a.points.size());
  for (const Point2 p : b.points) mesh.points.push_back({p.x + offset.x, p.y + offset.y});
  for (const auto& t : b.triangles)
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  for (const Segment& s : b.segments) mesh.segments.push_back({s.a + shift, s.b + shift, s.marker});
  return mesh;
}

TriangleMesh spiral_strip(Index n, Index period, double growth) {
  TriangleMesh mesh;
  for (Index i = 0; i <= n; ++i) {
    const Point2 p = circle_point(double(i) / period);
    const double inner = 1 + growth * i, outer = inner + 0.25;
    mesh.points.push_back(rounded({inner * p.x, inner * p.y}));
    mesh.points.push_back(rounded({outer * p.x, outer * p.y}));
  }
  for (Index i = 0; i < n; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    mesh.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
  }
  add_boundary_segments(mesh);
  return mesh;
}

std::vector<NamedMesh> clean_meshes() {
  const TriangleMesh grid = scaled_grid(9, 7, GridDiagonals::kAlternating);
  std::vector<NamedMesh> meshes = {
      {"grid", grid},
      {"random", random_mesh(60, 1)},
      {"annulus", annulus(24)},
      {"slit", slit_square(4)},
      {"island in a ring", side_by_side(annulus(24), annulus(24), {5, 0})},
      {"two components", side_by_side(grid, random_mesh(40, 2), {-3, 2})},
      {"spiral", spiral_strip(100, 40, 0.0078125)},
      {"random, larger", random_mesh(1500, 3)}};
  for (const char* name : {"thesis/airfoil1", "thesis/crack", "graded/su2_naca0012_inv"})
    if (auto mesh = data_mesh(name)) meshes.push_back({name, std::move(*mesh)});
  return meshes;
}

}  // namespace wellspaced::test
