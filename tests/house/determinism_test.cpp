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
#include "wellspaced/algorithms/packing/space/pack_domain3.hpp"
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
  EXPECT_EQ(bytes.hash(), "e8a55f0fd64fc5dd9e2f2af46b8d52cd8321f51359decfd7caa13a2cca7afb76");
}

TEST(Determinism, OfTriangulatedPointsOfSpace) {
  Bytes bytes;
  for (const auto& points :
       {box_points3(3000, 1), sphere_points3(1000, 1), lattice_points3(12, 12, 12),
        line_points3(40), helix_points3(300, 20, 1)})
    bytes.add(real_tets(*Delaunay3::build(points)));
  EXPECT_EQ(bytes.hash(), "2b860bd24f30791b0ec4fadddfbc58bf5894b1ff3a3aca5579da92791879be00");
}

// A cube turned out of the axes.
TEST(Determinism, OfPackingInSpace) {
  Pls cube;
  for (int i = 0; i < 8; ++i) {
    const double x = i & 1, y = i >> 1 & 1, z = i >> 2;
    cube.points.push_back(
        {(2 * x - 2 * y + z) / 3, (2 * x + y - 2 * z) / 3, (x + 2 * y + 2 * z) / 3});
  }
  for (const std::vector<Index>& side : {std::vector<Index>{0, 1, 3, 2},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 3, 7, 6},
                                         {0, 2, 6, 4},
                                         {1, 3, 7, 5}})
    cube.facets.push_back({{side}, {}, 1});
  const PackedTets packed = *pack_domain3(cube);
  Bytes bytes;
  bytes.add(packed.mesh.points).add(packed.mesh.tets).add(packed.mesh.facets).add(packed.radius);
  EXPECT_EQ(bytes.hash(), "fd0103bfc20b5540d829518bcc5d85079abbdacfa15bb1b6d6688e906cedc24e");
}

TEST(Determinism, OfSplitCrossings) {
  Pslg graph;
  graph.points = random_points(60, 3);
  for (Index i = 0; i + 1 < 60; i += 2) graph.segments.push_back({i, i + 1, 1});
  const PlanarTriangulation result = *triangulate(graph);
  EXPECT_EQ(
      Bytes().add(result.delaunay.points()).add(result.triangles()).add(result.segments).hash(),
      "90e443bfea34fb786cb0bb3a3f5d2c0d9b991630d6d03dce09fd62dc199c7dd6");
}

// Along nearly one line: no rounding keeps these segments apart, so that they are bent.
TEST(Determinism, OfBentSegments) {
  Pslg graph;
  for (const Point2 p : random_points(80, 4)) graph.points.push_back({p.x, p.x / 3});
  for (Index i = 0; i + 1 < 80; i += 2) graph.segments.push_back({i, i + 1, 1});
  const PlanarTriangulation result = *triangulate(graph);
  EXPECT_EQ(
      Bytes().add(result.delaunay.points()).add(result.triangles()).add(result.segments).hash(),
      "2033c5b4691c028f1482a203d6384fde720cc37d42053da4668bb64e3e929840");
}

TEST(Determinism, OfGeneratedMeshes) {
  Bytes bytes;
  for (const GradedDomain domain :
       {GradedDomain::kAirfoil, GradedDomain::kAnnulus, GradedDomain::kCrack})
    bytes.add(*generate_graded_mesh(domain, {.nodes = 3000}));
  EXPECT_EQ(bytes.hash(), "a945c0a886d0d2c7770142ec250b6125b5982cef1a1468acddf5653e3c6aa781");
}

TEST(Determinism, OfFunctionBasedCoarsening) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kFunction),
            "19ffe685cae70ca3c48bff2b21d50654ba97cd36888ebd060c1d233e57d48faf");
}

TEST(Determinism, OfMisBasedCoarsening) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kMis),
            "a7106c4fe5c482b136b041bd3f365b5d5c077a02304eead339f0bdb8b6e05270");
}

TEST(Determinism, OfCoarseningByQuadtree) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kQuadtree),
            "5eecb6cc341f018df647c7c666891c9ad119c7f43a09efc8df275cfd00111438");
}

TEST(Determinism, OfCoarseningByRefinement) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kRefinement),
            "b669de601331f62dcb23fcb906802db0f9788b434f61b700f2760a66d2cdf33f");
}

}  // namespace
}  // namespace wellspaced
