#include "wellspaced/algorithms/packing/corner_shells.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/domains.hpp"
#include "wellspaced/kernel/elementary.hpp"

namespace wellspaced {
namespace {

using test::polygons;

std::vector<Corner> corners_of(const Pslg& domain, HoleRule holes = HoleRule::kParity) {
  auto graph = triangulate(domain, {holes, CrossingRule::kSplit, {}});
  EXPECT_TRUE(graph.ok());
  return sharp_corners(*graph);
}

// A fan of two segments at the origin, closed far away.
Pslg wedge(double degrees) {
  const Point2 end = circle_point(degrees / 360);
  return polygons({{{0, 0}, {1, 0}, end}});
}

TEST(SharpCorners, AreThoseBelow60Degrees) {
  EXPECT_TRUE(corners_of(test::unit_square()).empty());
  EXPECT_TRUE(corners_of(wedge(60)).empty()) << "an equilateral triangle, as doubles have it";
  EXPECT_EQ(corners_of(wedge(59.99)).size(), 1u);
  const auto corners = corners_of(wedge(20));
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].apex, 0u);
  EXPECT_EQ(corners[0].right, 1u);
  EXPECT_EQ(corners[0].left, 2u);
  EXPECT_NEAR(corners[0].cosine, circle_point(20.0 / 360).x, 1e-12);
}

TEST(SharpCorners, AreNoneOutsideTheDomain) {
  // A notch of about 11 degrees: a reflex corner of the domain.
  const Pslg notched = polygons({{{0, 0}, {4, 0}, {4, 3}, {2.2, 3}, {2, 1}, {1.8, 3}, {0, 3}}});
  EXPECT_TRUE(corners_of(notched).empty());
  EXPECT_EQ(corners_of(notched, HoleRule::kNone).size(), 1u);
}

TEST(SharpCorners, AreFoundBetweenAllSegmentsAtAPoint) {
  Pslg star = polygons({test::rectangle({-9, -9}, {9, 9})});
  const Index hub = 4;
  star.points.push_back({0, 0});
  for (int k = 0; k < 9; ++k) {
    star.points.push_back(circle_point(k / 9.0));
    star.segments.push_back({hub, static_cast<Index>(hub + 1 + k), 0});
  }
  EXPECT_EQ(corners_of(star, HoleRule::kOuter).size(), 9u);
}

TEST(SharpCorners, AreNoneAtALooseEnd) {
  Pslg domain = test::unit_square();
  domain.points.push_back({0.5, 0.5});
  domain.points.push_back({0.7, 0.5});
  domain.segments.push_back({4, 5, 0});
  EXPECT_TRUE(corners_of(domain).empty());
}

}  // namespace
}  // namespace wellspaced
