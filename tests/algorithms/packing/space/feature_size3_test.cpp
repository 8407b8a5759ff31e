#include "wellspaced/algorithms/packing/space/feature_size3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/solids.hpp"
#include "wellspaced/kernel/random.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

Point3 random_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high);
  return {x, y, random.uniform(low, high)};
}

// Two sides of a cube that are apart lie on opposite faces.
double size_in_unit_cube(Point3 p) {
  return std::min({std::max(p.x, 1 - p.x), std::max(p.y, 1 - p.y), std::max(p.z, 1 - p.z)});
}

TEST(FeatureSize3, IsKnownInACube) {
  const PolyhedralComplex cube = *build_complex(test::triangulated_cube());
  const FeatureSize3 size(cube);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Point3 p = random_point(random, 0, 1);
    ASSERT_NEAR(size.at(p), size_in_unit_cube(p), 1e-14);
  }
  EXPECT_EQ(size.at({0, 0, 0}), 1);
  EXPECT_EQ(size.at({0.5, 0, 0}), 0.5);
  EXPECT_EQ(size.at({0.5, 0.5, 0.5}), 0.5);
}

TEST(FeatureSize3, SeesWhatAFacetThatIsNotConvexTouchesElsewhere) {
  // A U whose left arm carries a wall; that hangs over the right arm, 0.01 above it.
  Pls domain;
  domain.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0},    {2, 3, 0},    {2, 1, 0},   {1, 1, 0},
                   {1, 3, 0}, {0, 3, 0}, {1, 2, 0.01}, {3, 2, 0.01}, {3, 2, 0.5}, {1, 2, 0.5}};
  domain.facets = {test::polygon({0, 1, 2, 3, 4, 5, 6, 7}), test::polygon({8, 9, 10, 11})};
  const PolyhedralComplex apart = *build_complex(domain);
  EXPECT_NEAR(FeatureSize3(apart).at({2.5, 2, 0}), 0.01, 1e-15);
  domain.points[8] = {1, 3, 0};  // now it touches the U, in the corner of the left arm
  domain.points[9] = {3, 2, 0.01};
  domain.points[10] = {3, 2, 0.51};
  domain.points[11] = {1, 3, 0.5};
  domain.facets[1] = test::polygon({6, 9, 10, 11});
  const PolyhedralComplex touching = *build_complex(domain);
  EXPECT_LT(FeatureSize3(touching).at({2.9, 2.05, 0}), 0.02);
}

TEST(FeatureSize3, GrowsByOneAUnitOfLengthAtMost) {
  Random random(2);
  for (const Pls& domain :
       {test::two_boxes(), test::furnished_box(), test::turned(test::l_prism())}) {
    const PolyhedralComplex complex = *build_complex(domain);
    const FeatureSize3 size(complex);
    for (int i = 0; i < 3000; ++i) {
      const Point3 p = random_point(random, -1, 3);
      const Point3 q = p + random_point(random, -0.2, 0.2);
      ASSERT_LE(std::fabs(size.at(p) - size.at(q)), length(p - q) + 1e-13);
    }
  }
}

TEST(FeatureSize3, IsTheSameByCursor) {
  Random random(3);
  for (const Pls& domain : {test::two_boxes(), test::furnished_box(), test::l_prism()}) {
    const PolyhedralComplex complex = *build_complex(domain);
    const FeatureSize3 size(complex);
    FeatureSize3::Cursor cursor(size);
    for (int i = 0; i < 3000; ++i) {
      const Point3 p = random_point(random, -1, 4);
      ASSERT_NEAR(cursor.at(p), size.at(p), 1e-14);
    }
  }
}

TEST(FeatureSize3, IsInfiniteWhereNothingIsApart) {
  PolyhedralComplex nothing;
  EXPECT_EQ(FeatureSize3(nothing).at({0, 0, 0}), std::numeric_limits<double>::infinity());
  Pls triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.facets = {test::polygon({0, 1, 2})};
  const PolyhedralComplex complex = *build_complex(triangle);
  // A corner and the side opposite are apart.
  EXPECT_NEAR(FeatureSize3(complex).at({0, 0, 0}), std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace wellspaced
