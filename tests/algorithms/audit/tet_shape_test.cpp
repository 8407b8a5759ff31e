#include "wellspaced/algorithms/audit/tet_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/audit_tet_meshes.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using audit::classify_tet;
using audit::tet_shape;
using audit::TetClass;

const double kDegrees = 57.295779513082321;

TEST(TetShape, ARegularTetIsTheBestByEveryMeasure) {
  const auto shape = tet_shape({Point3{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  EXPECT_NEAR(shape.min_dihedral, std::acos(1.0 / 3) * kDegrees, 1e-11);
  EXPECT_NEAR(shape.max_dihedral, std::acos(1.0 / 3) * kDegrees, 1e-11);
  EXPECT_NEAR(shape.aspect_ratio, 3, 1e-12);
  EXPECT_NEAR(shape.circumradius_to_inradius, 3, 1e-12);
  EXPECT_NEAR(shape.radius_edge, std::sqrt(6.0) / 4, 1e-13);
  EXPECT_NEAR(shape.edge_ratio, 1, 1e-13);
  EXPECT_NEAR(shape.volume, 8.0 / 3, 1e-13);
}

TEST(TetShape, ACornerOfACubeHasRightDihedralAnglesAndALooseSphere) {
  const auto shape = tet_shape({Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(shape.max_dihedral, 90);
  EXPECT_NEAR(shape.min_dihedral, std::acos(1 / std::sqrt(3.0)) * kDegrees, 1e-11);
  EXPECT_NEAR(shape.radius_edge, std::sqrt(3.0) / 2, 1e-13);
  // The ball over the large face holds the corner, so it is the smallest.
  EXPECT_NEAR(shape.aspect_ratio / shape.circumradius_to_inradius,
              std::sqrt(2.0 / 3) / (std::sqrt(3.0) / 2), 1e-12);
}

TEST(TetShape, RatiosDoNotDependOnTheScale) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = {random.uniform(), random.uniform(), random.uniform()};
    const auto shape = tet_shape(p);
    for (const double scale : {0x1p-900, 0x1p300, 0x1p900}) {
      auto q = p;
      for (Point3& corner : q) corner = {corner.x * scale, corner.y * scale, corner.z * scale};
      const auto other = tet_shape(q);
      EXPECT_NEAR(other.min_dihedral, shape.min_dihedral, 1e-6);
      EXPECT_NEAR(other.aspect_ratio / shape.aspect_ratio, 1, 1e-9);
      EXPECT_NEAR(other.radius_edge / shape.radius_edge, 1, 1e-9);
    }
  }
}

TEST(TetShape, AFlatTetIsInfinitelyBad) {
  const auto shape = tet_shape({Point3{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_EQ(shape.volume, 0);
  EXPECT_TRUE(std::isinf(shape.aspect_ratio));
  EXPECT_EQ(shape.min_dihedral, 0);
  EXPECT_EQ(shape.max_dihedral, 180);
}

TEST(TetClass, NamesTheFiguresOfSection33) {
  EXPECT_EQ(classify_tet({Point3{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}),
            TetClass::kWellShaped);
  // Figure 3.2: a large edge ratio.
  EXPECT_EQ(classify_tet({Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 30}}),
            TetClass::kNeedle);
  EXPECT_EQ(classify_tet({Point3{0, 0, 0}, {0.05, 0, 0}, {0, 1, 0}, {0, 0.5, 1}}),
            TetClass::kWedge);
  EXPECT_EQ(classify_tet({Point3{0, 0, 0}, {1, 0, 0}, {0.5, -0.5, 40}, {0.5, 0.5, 40}}),
            TetClass::kSpindle);
  // Figure 3.3: edges of like length. The sliver's corners are near a square's.
  EXPECT_EQ(classify_tet({Point3{1, 0, 0.02}, {-1, 0, 0.02}, {0, 1, -0.02}, {0, -1, -0.02}}),
            TetClass::kSliver);
  EXPECT_EQ(
      classify_tet({Point3{1, 0, 0}, {-0.5, 0.8660254, 0}, {-0.5, -0.8660254, 0}, {0, 0, 0.02}}),
      TetClass::kCap);
  EXPECT_EQ(classify_tet({Point3{1, 0, 0.02}, {-1, 0, 0.02}, {0, 0.3, -0.02}, {0, -1, -0.02}}),
            TetClass::kFlat);
}

TEST(TetShapes, OfCubesAreKnown) {
  const auto mesh = test::cubes(3, 2, 2, [](Index, Index, Index) { return true; });
  const auto report = audit::audit_tet_mesh(mesh);
  const auto measured = [&](const char* name) { return report.measure(name)->value; };
  EXPECT_NEAR(measured("volume"), 12, 1e-12);
  EXPECT_NEAR(measured("min_dihedral"), 45, 1e-10);
  EXPECT_NEAR(measured("max_dihedral"), 90, 1e-10);
  EXPECT_NEAR(measured("edge_ratio"), std::sqrt(3.0), 1e-12);
  EXPECT_EQ(measured("slivers"), 0);
  const auto& counts = report.histograms.at(0).counts;
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}), 6 * mesh.tets.size());
}

TEST(TetShapes, ListsTheSliversOfADelaunayMesh) {
  const TetMesh mesh = test::random_tet_mesh(2000, 4);
  const auto report = audit::audit_tet_mesh(mesh);
  const auto* check = report.check("no_sliver");
  EXPECT_GT(check->violations, 10u);
  EXPECT_EQ(check->violations, report.measure("slivers")->value);
  for (const Index t : check->ids) {
    const auto& [a, b, c, d] = mesh.tets[t];
    const auto shape = tet_shape({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
    EXPECT_GT(shape.aspect_ratio, audit::kBadAspectRatio);
    EXPECT_LE(shape.radius_edge, audit::kLargeRadiusEdge);
  }
}

}  // namespace
}  // namespace wellspaced
