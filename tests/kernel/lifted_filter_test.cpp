#include "wellspaced/kernel/lifted_filter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/predicate_cases.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using predicate_filter::edge_minors;
using predicate_filter::LiftedPair;
using predicate_filter::Two;

// Points of two cases, each seen from the p of its own.
LiftedPair seen(Point2 a, Point2 p, Point2 b, Point2 q) {
  return predicate_filter::lifted(Two{a.x, a.y} - Two{p.x, p.y}, Two{b.x, b.y} - Two{q.x, q.y});
}

TEST(LiftedFilter, CertainEstimatesFromMinorsHaveTheSignOfThePredicates) {
  testing::LineGenerator<testing::IncircleCase> generator(1);
  int certain_circles = 0, certain_sides = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto x = generator.line(static_cast<testing::Family>(i % testing::kFamilies));
    const auto y = generator.line(static_cast<testing::Family>(i / 3 % testing::kFamilies));
    const std::array<Point2, 4> a{{{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}, {x[6], x[7]}}};
    const std::array<Point2, 4> b{{{y[0], y[1]}, {y[2], y[3]}, {y[4], y[5]}, {y[6], y[7]}}};
    const LiftedPair u = seen(a[0], a[3], b[0], b[3]), v = seen(a[1], a[3], b[1], b[3]),
                     w = seen(a[2], a[3], b[2], b[3]);
    const Two uv = edge_minors(u, v), side_bounds = predicate_filter::edge_minor_bound(u.sq, v.sq);
    const auto [determinants, bounds] =
        predicate_filter::incircles_of_minors(u, v, w, uv, edge_minors(v, w), edge_minors(w, u));
    for (int k = 0; k < 2; ++k) {
      const auto& c = k == 0 ? a : b;
      if (std::fabs(uv[k]) > side_bounds[k]) {
        ++certain_sides;
        ASSERT_EQ(orient2d(c[0], c[1], c[3]), uv[k] > 0 ? 1 : -1) << i;
      }
      if (std::fabs(determinants[k]) > bounds[k]) {
        ++certain_circles;
        ASSERT_EQ(incircle(c[0], c[1], c[2], c[3]), determinants[k] > 0 ? 1 : -1) << i;
      }
    }
  }
  EXPECT_GT(certain_circles, 5000);
  EXPECT_GT(certain_sides, 5000);
}

}  // namespace
}  // namespace wellspaced
