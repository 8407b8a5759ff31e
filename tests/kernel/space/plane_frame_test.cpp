#include "wellspaced/kernel/space/plane_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

TEST(PlaneFrame, CoordinatesAndPointAreInverse) {
  const PlaneFrame frame{{1, 2, 3}, {0, 0.6, 0.8}, {1, 0, 0}};
  const Point2 at = frame.coordinates(frame.point({2, -5}));
  EXPECT_NEAR(at.x, 2, 1e-15);
  EXPECT_NEAR(at.y, -5, 1e-15);
}

TEST(PlaneFrame, PointsThatRoundingMovedOffThePlaneAreTriangulatedInIt) {
  const double r = std::sqrt(1.0 / 3), s = std::sqrt(0.5), q = std::sqrt(1.0 / 6);
  const PlaneFrame frame{{0.1, 0.2, 0.3}, {s, -s, 0}, {q, q, -2 * q}};
  Random random(1);
  std::vector<Point3> points;
  for (int i = 0; i < 200; ++i) {
    Point3 p = frame.point({random.uniform(), random.uniform()});
    const double off = random.uniform(-1e-12, 1e-12);
    p = {p.x + off * r, p.y + off * r, p.z + off * r};
    points.push_back(p);
  }
  const auto built = build_in_frame(points, frame);
  ASSERT_TRUE(built.ok());
  EXPECT_EQ(built->dimension(), 2);
  EXPECT_TRUE(built->topology().is_valid());
  EXPECT_EQ(built->topology().size(), 2u * 200 - 2);  // the triangles of a sphere on 200 + 1 points
}

TEST(PlaneFrame, CoordinatesThatOverflowAreRefused) {
  const PlaneFrame frame{{-1e308, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Point3> points{{1e308, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  const auto built = build_in_frame(points, frame);
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().ids, std::vector<Index>{0});
}

}  // namespace
}  // namespace wellspaced
