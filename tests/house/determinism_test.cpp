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
  EXPECT_EQ(bytes.hash(), "71e3a2d71ae347e16fbf4f3fafea426ec82b808494764a32ddf429456870457d");
}

TEST(Determinism, OfTriangulatedPointsOfSpace) {
  Bytes bytes;
  for (const auto& points :
       {box_points3(3000, 1), sphere_points3(1000, 1), lattice_points3(12, 12, 12),
        line_points3(40), helix_points3(300, 20, 1)})
    bytes.add(real_tets(*Delaunay3::build(points)));
  EXPECT_EQ(bytes.hash(), "db977aaeacb430208ca0c6d60da553205d546a05d3a12bf04349e024910e245d");
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
  EXPECT_EQ(bytes.hash(), "d38568fba3c854c08f59ade17ddc569a308237cac710a894a86da39e8c525888");
}

TEST(Determinism, OfSplitCrossings) {
  Pslg graph;
  graph.points = random_points(60, 3);
  for (Index i = 0; i + 1 < 60; i += 2) graph.segments.push_back({i, i + 1, 1});
  const PlanarTriangulation result = *triangulate(graph);
  EXPECT_EQ(
      Bytes().add(result.delaunay.points()).add(result.triangles()).add(result.segments).hash(),
      "a053d3ca492cf5c63a885f9ca20f44bff0bb406757b24955afe2fad6bcd396d2");
}

// Along nearly one line: no rounding keeps these segments apart, so that they are bent.
TEST(Determinism, OfBentSegments) {
  Pslg graph;
  for (const Point2 p : random_points(80, 4)) graph.points.push_back({p.x, p.x / 3});
  for (Index i = 0; i + 1 < 80; i += 2) graph.segments.push_back({i, i + 1, 1});
  const PlanarTriangulation result = *triangulate(graph);
  EXPECT_EQ(
      Bytes().add(result.delaunay.points()).add(result.triangles()).add(result.segments).hash(),
      "7cdad9814013cc2ac82e221960f748db1a1274e8e984691bd2fca83cc79d78b8");
}

TEST(Determinism, OfGeneratedMeshes) {
  Bytes bytes;
  for (const GradedDomain domain :
       {GradedDomain::kAirfoil, GradedDomain::kAnnulus, GradedDomain::kCrack})
    bytes.add(*generate_graded_mesh(domain, {.nodes = 3000}));
  EXPECT_EQ(bytes.hash(), "3c82a1b9f767600cf9bc672dc97eaa452f34c1592a95cc68353c7c4466810942");
}

TEST(Determinism, OfFunctionBasedCoarsening) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kFunction),
            "dccf1d60e6139ba8c045036419990b7918f8e9f9a82622c02c26c459f647e76f");
}

TEST(Determinism, OfMisBasedCoarsening) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kMis),
            "2226a67e0654c27c0926d27e9d56e274737a25c9c2dd7fb15a7752339ddca96b");
}

TEST(Determinism, OfCoarseningByQuadtree) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kQuadtree),
            "cebdf8b03a67eb5a92c632822392c8fa3acb5574197c4fd284c219aff0868b28");
}

TEST(Determinism, OfCoarseningByRefinement) {
  EXPECT_EQ(hash_of_coarsening(CoarseningMethod::kRefinement),
            "2cae9d4bec4dff68b2a9a9549dd0ee58fb6725d92354be227b68545c2dc246b0");
}

}  // namespace
}  // namespace wellspaced
