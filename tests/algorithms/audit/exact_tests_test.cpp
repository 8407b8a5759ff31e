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
}

struct Whole3 {
  Integer x, y, z;
};

Whole3 operator-(Whole3 p, Whole3 q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Integer dot(Whole3 p, Whole3 q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Whole3 cross(Whole3 p, Whole3 q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
Whole3 combined(Integer a, Whole3 p, Integer b, Whole3 q, Integer c, Whole3 r) {
  return {a * p.x + b * q.x + c * r.x, a * p.y + b * q.y + c * r.y, a * p.z + b * q.z + c * r.z};
}

Whole3 whole3(Random& random) {
  const auto one = [&] { return static_cast<Integer>(random.below(9)) - 4; };
  return {one(), one(), one()};
}

TEST(ExactTests, AgreeWithWholeNumbersInSpace) {
  Random random(4);
  int ties = 0;
  for (const double scale : {1.0, 0x1p-1000, 0x1p-150, 0x1p300}) {
    const auto at = [&](Whole3 p) { return Point3{p.x * scale, p.y * scale, p.z * scale}; };
    for (int i = 0; i < 10000; ++i) {
      const Whole3 a = whole3(random), p = whole3(random) - a, q = whole3(random) - a;
      const Whole3 r = whole3(random) - a, b = whole3(random) - a, c = whole3(random) - a;
      const Whole3 d = whole3(random) - a;
      const auto moved = [&](Whole3 v) { return at(v - Whole3{-a.x, -a.y, -a.z}); };
      const Whole3 n = cross(b, c);
      if (dot(n, n) != 0) {
        const Whole3 centre = combined(dot(c, c), cross(n, b), -dot(b, b), cross(n, c), 0, n);
        const int side = sign(dot(centre, d) - dot(n, n) * dot(d, d));
        EXPECT_EQ(audit::face_sphere_side(at(a), moved(b), moved(c), moved(d)), side);
        ties += side == 0;
      }
      if (dot(n, d) <= 0) continue;
      const Whole3 centre =
          combined(dot(b, b), cross(c, d), dot(c, c), cross(d, b), dot(d, d), cross(b, c));
      const Whole3 normal = cross(q - p, r - p);
      const int side = sign(dot(normal, centre) - 2 * dot(n, d) * dot(normal, p));
      const audit::Circumcentre3 circumcentre({at(a), moved(b), moved(c), moved(d)});
      EXPECT_EQ(circumcentre.side({moved(p), moved(q), moved(r)}), side);
      ties += side == 0;
    }
  }
  EXPECT_GT(ties, 300);
}

}  // namespace
}  // namespace wellspaced
