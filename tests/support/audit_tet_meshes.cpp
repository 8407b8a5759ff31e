#include "tests/support/audit_tet_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced::test {
namespace {

double rounded(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

// The orders in which one walks along three edges from the lowest to the highest corner of a cube;
// the odd ones must be turned.
constexpr std::array<std::array<int, 3>, 6> kWalks = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

void drop_unused_nodes(TetMesh& mesh) {
  std::map<Index, Index> number;
  std::vector<Point3> points;
  for (auto& tet : mesh.tets)
    for (Index& v : tet) {
      const auto [at, is_new] = number.emplace(v, static_cast<Index>(points.size()));
      if (is_new) points.push_back(mesh.points[v]);
      v = at->second;
    }
  mesh.points = std::move(points);
}

}  // namespace

void add_boundary_facets(TetMesh& mesh) {
  std::map<std::array<Index, 3>, std::pair<int, std::array<Index, 3>>> faces;
  for (const auto& t : mesh.tets)
    for (int i = 0; i < 4; ++i) {
      std::array<Index, 3> face;
      for (int j = 0, k = 0; j < 4; ++j)
        if (j != i) face[k++] = t[j];
      auto key = face;
      std::sort(key.begin(), key.end());
      auto& [count, nodes] = faces[key];
      ++count;
      nodes = face;
    }
  for (const auto& [key, value] : faces)
    if (value.first == 1) mesh.facets.push_back({value.second, 1});
}

TetMesh random_tet_mesh(std::size_t nodes, std::uint64_t seed) {
  Random random(seed);
  TetMesh mesh;
  for (std::size_t i = 0; i < nodes; ++i)
    mesh.points.push_back(
        {rounded(random.uniform()), rounded(random.uniform()), rounded(random.uniform())});
  const Delaunay3 delaunay = Delaunay3::build(mesh.points).value();
  for (Index t = 0; t < delaunay.topology().size(); ++t)
    if (!delaunay.topology().is_ghost(t)) mesh.tets.push_back(delaunay.topology().vertices(t));
  add_boundary_facets(mesh);
  return mesh;
}

TetMesh cubes(Index nx, Index ny, Index nz, const std::function<bool(Index, Index, Index)>& keep) {
  TetMesh mesh;
  for (Index z = 0; z <= nz; ++z)
    for (Index y = 0; y <= ny; ++y)
      for (Index x = 0; x <= nx; ++x) mesh.points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  const std::array<Index, 3> step = {1, nx + 1, (nx + 1) * (ny + 1)};
  for (Index z = 0; z < nz; ++z)
    for (Index y = 0; y < ny; ++y)
      for (Index x = 0; x < nx; ++x) {
        if (!keep(x, y, z)) continue;
        const Index low = x * step[0] + y * step[1] + z * step[2];
        for (std::size_t i = 0; i < kWalks.size(); ++i) {
          const auto& walk = kWalks[i];
          const Index a = low + step[walk[0]], b = a + step[walk[1]], high = b + step[walk[2]];
          i < 3 ? mesh.tets.push_back({low, a, b, high}) : mesh.tets.push_back({low, b, a, high});
        }
      }
  drop_unused_nodes(mesh);
  add_boundary_facets(mesh);
  return mesh;
}

TetMesh side_by_side(const TetMesh& a, const TetMesh& b, Point3 offset) {
  TetMesh mesh = a;
  const auto shift = static_cast<Index>(a.points.size());
  for (const Point3 p : b.points)
    mesh.points.push_back({p.x + offset.x, p.y + offset.y, p.z + offset.z});
  for (const auto& t : b.tets)
    mesh.tets.push_back({t[0] + shift, t[1] + shift, t[2] + shift, t[3] + shift});
  for (const auto& f : b.facets)
    mesh.facets.push_back(
        {{f.points[0] + shift, f.points[1] + shift, f.points[2] + shift}, f.marker});
  return mesh;
}

std::vector<NamedTetMesh> clean_tet_meshes() {
  const auto all = [](Index, Index, Index) { return true; };
  const TetMesh box = cubes(3, 2, 2, all), small = cubes(1, 1, 1, all);
  const TetMesh hollow = cubes(5, 5, 5, [](Index x, Index y, Index z) {
    return !(1 <= x && x < 4 && 1 <= y && y < 4 && 1 <= z && z < 4);
  });
  const TetMesh ring = cubes(3, 3, 1, [](Index x, Index y, Index) { return x != 1 || y != 1; });
  return {{"box", box},
          {"hollow box", hollow},
          {"ring", ring},
          {"two components", side_by_side(box, random_tet_mesh(40, 2), {-3, 2, 5})},
          {"box in a cavity", side_by_side(hollow, small, {2, 2, 2})},
          {"random", random_tet_mesh(120, 1)}};
}

}  // namespace wellspaced::test
