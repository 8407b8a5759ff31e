// The same bytes come out everywhere: hashes of results, written down once and compared on every
// compiler, optimisation level and architecture.
#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/algorithms/generate/points3.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/sha256.hpp"
#include "wellspaced/kernel/space/delaunay3_queries.hpp"

namespace wellspaced {
namespace {

// Gathers the bytes of plain arrays, little-endian as on all machines that we build for.
class Bytes {
 public:
  template <class T>
  Bytes& add(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return *this;
  }
  Bytes& add(const TriangleMesh& mesh) {
    return add(mesh.points).add(mesh.triangles).add(mesh.segments);
  }
  std::string hash() const { return sha256(bytes_); }

 private:
  std::string bytes_;
};

std::string hash_of(const Hierarchy& hierarchy) {
  Bytes bytes;
  for (const Level& level : hierarchy.levels)
    bytes.add(level.mesh).add(level.spacing).add(level.parent).add(level.origin);
  return bytes.hash();
}

TriangleMesh airfoil() { return *generate_graded_mesh(GradedDomain::kAirfoil, {.nodes = 3000}); }

std::string hash_of_coarsening(CoarseningMethod method) {
  return hash_of(*coarsen(airfoil(), theorem_options(method)));
}

TEST(Determinism, OfTriangulatedPoints) {
  Bytes bytes;
  for (const auto& points : {random_points(5000, 1), clustered_points(5000, 20, 1),
                             spiral_points(5000, 40), grid_points(60, 60)}) {
    const Delaunay2 dt = *Delaunay2::build(points);
    for (Index t = 0; t < dt.topology().size(); ++t) {
      const auto& v = dt.topology().vertices(t);
      bytes.add(std::vector<Index>(v.begin(), v.end()));
    }
  }
  EXPECT_EQ(bytes.hash(), "fd8a554a4f10e9903fc6ffb1867be92c21c4cb96a43fae59539e039fd55216e2");
}

TEST(Determinism, OfTriangulatedPointsOfSpace) {
  Bytes bytes;
  for (const auto& points :
       {box_points3(3000, 1), sphere_points3(1000, 1), lattice_points3(12, 12, 12),
        line_points3(40), helix_points3(300, 20, 1)})
    bytes.add(real_tets(*Delaunay3::build(points)));
  EXPECT_EQ(bytes.hash(), "2b860bd24f30791b0ec4fadddfbc58bf5894b1ff3a3aca5579da92791879be00");
}

TEST(Determinism, OfSplitCrossings) {
  Pslg graph;
  graph.points = random_points(60, 3);
  for (Index i = 0; i + 1 < 60; i += 2) graph.segments.push_back({i, i + 1, 1});
  const PlanarTriangulation result = *triangulate(graph);
  EXPECT_EQ(
      Bytes().add(result.delaunay.points()).add(result.triangles()).add(result.segments).hash(),
      "62783516e5e423de4aee052d970184e2db3217c440f48df532196b80427ff645");
}

TEST(Determinism, OfGeneratedMeshes) {
  Bytes bytes;
  for (const GradedDomain domain :
       {GradedDomain::kAirfoil, GradedDomain::kAnnulus, GradedDomain::kCrack})
    bytes.add(*generate_graded_mesh(domain, {.nodes = 3000}));
  EXPECT_EQ(bytes.hash(), "24a64f183902ddb3b84a51121997541edda02148ddbc012d449cf9f28fa73aea");
}

TEST(Determinism, OfFunctionBasedCoarsening) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kFunction),
            "1f2d505ff3a805e69c8219ee1b1e4182a369b66dad8478d7a9887d0f8c9924eb");
}

TEST(Determinism, OfMisBasedCoarsening) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kMis),
            "5ecf31b18e20dde3aa908dc208be1e7f3da32e32345f342af1fa3fa3952cd396");
}

TEST(Determinism, OfCoarseningByQuadtree) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kQuadtree),
            "5ee90bcc1d843481ececfd7f762470089a2d78b8d337a3b2649ff193acb212bf");
}

}  // namespace
}  // namespace wellspaced
