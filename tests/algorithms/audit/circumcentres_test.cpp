#include <gtest/gtest.h>

#include <vector>

#include "tests/support/audit_meshes.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using test::NamedMesh;

// Two obtuse triangles on their longest edge.
TriangleMesh flat_kite() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {4, -1}, {8, 0}, {4, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TriangleMesh without_some_triangles(const TriangleMesh& mesh, double share, std::uint64_t seed) {
  Random random(seed);
  TriangleMesh rest;
  rest.points = mesh.points;
  for (const auto& t : mesh.triangles)
    if (random.uniform() >= share) rest.triangles.push_back(t);
  return rest;
}

std::vector<NamedMesh> delaunay_meshes() {
  std::vector<NamedMesh> meshes = test::clean_meshes();
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const double share = 0.02 * static_cast<double>(seed % 10);
    meshes.push_back({"random with holes " + std::to_string(seed),
                      without_some_triangles(test::random_mesh(200, seed), share, seed)});
  }
  return meshes;
}

// In a mesh with an edge that is not Delaunay every way to a circumcentre is walked, so such an
// edge far away must not change what is found.
TEST(CircumcentresInside, AreFoundInDelaunayMeshesWithoutWalkingAllWays) {
  std::size_t compared = 0, outside = 0;
  for (const auto& [name, mesh] : delaunay_meshes()) {
    const audit::Report report = audit::audit_mesh(mesh);
    if (!report.check("delaunay")->pass()) continue;
    const auto both = test::side_by_side(mesh, flat_kite(), {4096, 4096});
    const audit::Report walked = audit::audit_mesh(both);
    ASSERT_EQ(walked.check("delaunay")->violations, 1u) << name;
    std::vector<Index> expected;
    for (const Index t : walked.check("circumcentres_inside")->ids)
      if (t < mesh.triangles.size()) expected.push_back(t);
    EXPECT_EQ(report.check("circumcentres_inside")->ids, expected) << name;
    outside += expected.size();
    ++compared;
  }
  EXPECT_GT(compared, 40u);
  EXPECT_GT(outside, 100u);
}

}  // namespace
}  // namespace wellspaced
