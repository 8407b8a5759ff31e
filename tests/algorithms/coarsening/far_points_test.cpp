#include "wellspaced/algorithms/coarsening/far_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "wellspaced/kernel/distance.hpp"
#include "wellspaced/kernel/elementary.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

using Positions = std::vector<std::size_t>;

std::vector<Point2> random_loop(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> loop;
  for (std::size_t i = 0; i < count; ++i) loop.push_back({random.uniform(), random.uniform()});
  return loop;
}

TEST(FarPoints, StartWithTheFarthestPair) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto loop = random_loop(2 + seed % 40, seed);
    double farthest = 0;
    for (const Point2 p : loop)
      for (const Point2 q : loop) farthest = std::max(farthest, distance(p, q));
    const Positions chosen = add_far_points(loop, {}, 2);
    ASSERT_EQ(chosen.size(), 2u);
    EXPECT_EQ(distance(loop[chosen[0]], loop[chosen[1]]), farthest);
  }
}

TEST(FarPoints, FindTheLowestOfManyFarthestPairs) {
  std::vector<Point2> square = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  EXPECT_EQ(add_far_points(square, {}, 2), (Positions{0, 4}));
  std::vector<Point2> circle;
  for (int i = 0; i < 64; ++i) circle.push_back(circle_point(i / 64.0));
  EXPECT_EQ(add_far_points(circle, {}, 4), (Positions{0, 32, 16, 48}));
}

TEST(FarPoints, GoOnWithTheFarthestFromTheLineAndFromTheTriangle) {
  const std::vector<Point2> kite = {{0, 0}, {5, -1}, {10, 0}, {6, 3}, {5, 1}};
  EXPECT_EQ(add_far_points(kite, {}, 3), (Positions{0, 2, 3}));
  EXPECT_EQ(add_far_points(kite, {}, 4), (Positions{0, 2, 3, 1}));
  const std::vector<Point2> dented = {{0, 0}, {10, 0}, {6, 3}, {5, 1}};
  EXPECT_EQ(add_far_points(dented, {}, 4), (Positions{0, 1, 2})) << "the last is in the triangle";
}

TEST(FarPoints, KeepThoseThatAreChosenAlready) {
  const std::vector<Point2> kite = {{0, 0}, {5, -1}, {10, 0}, {6, 3}, {5, 1}};
  EXPECT_EQ(add_far_points(kite, {1}, 2), (Positions{1, 0}));
  EXPECT_EQ(add_far_points(kite, {1, 3}, 3), (Positions{1, 3, 0}));
  EXPECT_EQ(add_far_points(kite, {4, 3, 2}, 3), (Positions{4, 3, 2}));
}

TEST(FarPoints, TakeTheMiddleOfAStraightLoop) {
  const std::vector<Point2> slit = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {3, 0}, {2, 0}, {1, 0}};
  EXPECT_EQ(add_far_points(slit, {}, 3), (Positions{0, 4, 2}));
}

TEST(FarPoints, AreAsManyAsThereArePlaces) {
  EXPECT_EQ(add_far_points({}, {}, 3), Positions());
  EXPECT_EQ(add_far_points(std::vector<Point2>(5, {1, 1}), {}, 3), Positions());
  EXPECT_EQ(add_far_points(std::vector<Point2>{{0, 0}, {1, 0}, {0, 0}}, {}, 3), (Positions{0, 1}));
}

}  // namespace
}  // namespace wellspaced
