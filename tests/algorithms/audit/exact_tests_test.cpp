#include "wellspaced/algorithms/audit/exact_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wellspaced/kernel/predicates.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using Integer = long long;

struct Whole {
  Integer x, y;
};

int sign(Integer x) { return (x > 0) - (x < 0); }

Whole whole(Random& random, Integer size) {
  return {static_cast<Integer>(random.below(2 * size + 1)) - size,
          static_cast<Integer>(random.below(2 * size + 1)) - size};
}

Point2 point(Whole p, double scale, Point2 offset) {
  return {p.x * scale + offset.x, p.y * scale + offset.y};
}

Integer dot(Whole p, Whole q) { return p.x * q.x + p.y * q.y; }
Integer cross(Whole p, Whole q) { return p.x * q.y - p.y * q.x; }
Whole operator-(Whole p, Whole q) { return {p.x - q.x, p.y - q.y}; }

int slow_circumcentre_side(Whole p, Whole q, Whole a, Whole b, Whole c) {
  p = p - a, q = q - a, b = b - a, c = c - a;
  const Whole centre{c.y * dot(b, b) - b.y * dot(c, c), b.x * dot(c, c) - c.x * dot(b, b)};
  return sign(2 * cross(b, c) * cross(p, q) + cross(q - p, centre));
}

// Small and large whole numbers, at scales and places where doubles still hold them exactly.
struct Frame {
  Integer size;
  double scale;
  Point2 offset;
};

const Frame kFrames[] = {{4, 1, {0, 0}},       {4, 0x1p-1000, {0, 0}},
                         {6, 0x1p300, {0, 0}}, {5, 0x1p-40, {1024, -4096}},
                         {1000, 1, {0, 0}},    {1000, 0x1p-20, {3, 5}}};

TEST(ExactTests, AgreeWithWholeNumbersAtEveryScale) {
  Random random(3);
  int ties = 0;
  for (const Frame& frame : kFrames) {
    const auto at = [&](Whole p) { return point(p, frame.scale, frame.offset); };
    for (int i = 0; i < 20000; ++i) {
      const Whole p = whole(random, frame.size), q = whole(random, frame.size);
      const Whole a = whole(random, frame.size), b = whole(random, frame.size);
      const Whole c = whole(random, frame.size);
      EXPECT_EQ(audit::angle_sign(at(a), at(p), at(q)), sign(dot(p - a, q - a)));
      EXPECT_EQ(audit::exact_angle_sign(at(a), at(p), at(q)), sign(dot(p - a, q - a)));
      EXPECT_EQ(audit::bisector_side(at(p), at(q), at(a)),
                sign(dot(p - a, p - a) - dot(q - a, q - a)));
      if (cross(b - a, c - a) <= 0) continue;
      const int side = slow_circumcentre_side(p, q, a, b, c);
      EXPECT_EQ(audit::circumcentre_side(at(p), at(q), at(a), at(b), at(c)), side);
      ties += side == 0;
    }
  }
  EXPECT_GT(ties, 500);
}

TEST(ExactTests, SeeOneUnitInTheLastPlace) {
  const Point2 apex{0, 0}, p{0.1, 0.3};
  const Point2 right{-0.3, 0.1}, acute{-0.3, std::nextafter(0.1, 1)};
  EXPECT_EQ(audit::angle_sign(apex, p, right), 0);
  EXPECT_EQ(audit::angle_sign(apex, p, acute), 1);
  EXPECT_EQ(audit::angle_sign(apex, p, {-0.3, std::nextafter(0.1, 0)}), -1);
  EXPECT_EQ(audit::bisector_side(p, right, apex), 0);
  EXPECT_EQ(audit::bisector_side(p, acute, apex), -1);
}

}  // namespace
}  // namespace wellspaced
