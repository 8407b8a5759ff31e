#include "wellspaced/kernel/lifted_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/predicate_cases.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

using predicate_filter::edge_minor;

TEST(LiftedFilter, CertainEstimatesFromMinorsHaveTheSignOfIncircle) {
  testing::LineGenerator<testing::IncircleCase> generator(1);
  int certain = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto x = generator.line(static_cast<testing::Family>(i % testing::kFamilies));
    const Point2 a{x[0], x[1]}, b{x[2], x[3]}, c{x[4], x[5]}, p{x[6], x[7]};
    const auto u = predicate_filter::lifted(a, p), v = predicate_filter::lifted(b, p);
    const auto w = predicate_filter::lifted(c, p);
    const auto [determinant, bound] = predicate_filter::incircle_of_minors(
        u, v, w, edge_minor(u, v), edge_minor(v, w), edge_minor(w, u));
    if (!(std::fabs(determinant) > bound)) continue;
    ++certain;
    ASSERT_EQ(incircle(a, b, c, p), determinant > 0 ? 1 : -1) << i;
  }
  EXPECT_GT(certain, 5000);
}

}  // namespace
}  // namespace wellspaced
