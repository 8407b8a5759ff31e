#include "wellspaced/algorithms/generate/curved_domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

double distance(Point2 p, Point2 q) { return std::hypot(p.x - q.x, p.y - q.y); }

std::vector<CurvedDomain> all_domains(double octaves) {
  return {crack_domain(octaves), annulus_domain(octaves), airfoil_domain(octaves)};
}

TEST(CurvedDomain, CurvesStartAndEndAtTheirCorners) {
  for (const CurvedDomain& domain : all_domains(5))
    for (const auto& curve : domain.curves) {
      EXPECT_LT(distance(curve.point(0), domain.corners[curve.from]), 1e-15);
      EXPECT_LT(distance(curve.point(1), domain.corners[curve.to]), 1e-15);
    }
}

TEST(CurvedDomain, GradingIsPositiveAnd1Lipschitz) {
  Random random(1);
  for (const CurvedDomain& domain : all_domains(8))
    for (int k = 0; k < 20000; ++k) {
      const Point2 p{random.uniform(-8, 8), random.uniform(-8, 8)};
      const double reach = k % 2 == 0 ? 8 : 0.1;
      const Point2 q{p.x + random.uniform(-reach, reach), p.y + random.uniform(-reach, reach)};
      EXPECT_GT(domain.grading(p), 0);
      EXPECT_LE(std::fabs(domain.grading(p) - domain.grading(q)), distance(p, q) + 1e-14);
    }
}

TEST(CurvedDomain, GradingSpansTheOctaves) {
  const CurvedDomain crack = crack_domain(10), annulus = annulus_domain(6),
                     airfoil = airfoil_domain(9);
  EXPECT_NEAR(std::log2(crack.grading({1, 1}) / crack.grading({0.5, 0.5})), 10, 1e-9);
  EXPECT_NEAR(std::log2(annulus.grading({8, 0}) / annulus.grading({1, 0})), 6, 1e-9);
  EXPECT_NEAR(std::log2(airfoil.grading({-8, 0}) / airfoil.grading({-0.6, 0})), 9, 0.2);
}

TEST(CurvedDomain, TheMainElementIs12PercentThickAnd2PercentCambered) {
  const CurvedDomain airfoil = airfoil_domain(9);
  const auto &lower = airfoil.curves[1], &upper = airfoil.curves[2];
  double thickest = 0, highest = 0;
  for (double t = 0; t <= 1; t += 0x1p-8) {
    thickest = std::max(thickest, upper.point(t).y - lower.point(t).y);
    highest = std::max(highest, (upper.point(t).y + lower.point(t).y) / 2);
  }
  EXPECT_NEAR(thickest, 0.12, 0.001);
  EXPECT_NEAR(highest, 0.02, 0.001);
}

TEST(Discretize, SegmentsAreAbout12TenthsOfASpacingLong) {
  for (const CurvedDomain& domain : all_domains(8)) {
    const double scale = 0.03;
    const Pslg pslg = discretize(domain, scale);
    for (const Segment& s : pslg.segments) {
      const Point2 p = pslg.points[s.a], q = pslg.points[s.b];
      const Point2 middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
      const double in_spacings = distance(p, q) / (scale * domain.grading(middle));
      EXPECT_GT(in_spacings, 1);
      EXPECT_LT(in_spacings, 1.4);
    }
  }
}

TEST(Discretize, StraightCurvesStayStraight) {
  const Pslg pslg = discretize(crack_domain(10), 0.02);
  ASSERT_GT(pslg.points.size(), 200u);
  for (const Point2 p : pslg.points)
    EXPECT_TRUE(p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1 || (p.y == 0.5 && p.x <= 0.5));
}

std::uint64_t hash_of(const std::vector<Point2>& points) {
  std::uint64_t hash = 14695981039346656037u;
  for (const Point2 p : points)
    for (const double v : {p.x, p.y})
      hash = (hash ^ std::bit_cast<std::uint64_t>(v)) * 1099511628211u;
  return hash;
}

TEST(Discretize, PointsHaveTheSameBitsEverywhere) {
  EXPECT_EQ(hash_of(discretize(crack_domain(8), 0.1).points), 1334093497695513758u);
  EXPECT_EQ(hash_of(discretize(annulus_domain(5), 0.1).points), 4328841895447462602u);
  EXPECT_EQ(hash_of(discretize(airfoil_domain(8), 0.1).points), 9248238971368690380u);
}

TEST(Discretize, ClosedCurvesHaveAtLeastSixPoints) {
  const Pslg pslg = discretize(annulus_domain(0), 100);
  EXPECT_EQ(pslg.points.size(), 12u);
  EXPECT_EQ(pslg.segments.size(), 12u);
}

}  // namespace
}  // namespace wellspaced
