#include "wellspaced/kernel/predicate_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/points3.hpp"
#include "tests/support/predicate_cases.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

// Five points of each set at a time; sets at the ends of the range overflow and underflow.
template <class Check>
void for_random_fives(Check check) {
  Random random(1);
  for (const auto& [name, points] : test::degenerate_sets3()) {
    SCOPED_TRACE(name);
    const auto draw = [&] { return points[random.below(points.size())]; };
    for (int i = 0; i < 500; ++i) {
      const Point3 a = draw(), b = draw(), c = draw(), d = draw(), e = draw();
      check(a, b, c, d, e);
    }
  }
}

TEST(PredicateFilter, CertainSidesOfATetAreThoseOfOrient3d) {
  int certain = 0;
  for_random_fives([&](Point3 a, Point3 b, Point3 c, Point3 d, Point3 p) {
    const auto signs = predicate_filter::sides(a, b, c, d, p).signs();
    const int expected[] = {orient3d(b, c, d, p), orient3d(a, d, c, p), orient3d(a, b, d, p),
                            orient3d(a, c, b, p)};
    for (unsigned k = 0; k < 4; ++k) {
      if ((signs.certain >> k & 1) == 0) continue;
      ++certain;
      EXPECT_EQ(expected[k], (signs.negative >> k & 1) ? -1 : 1);
    }
    EXPECT_EQ(signs.negative & ~signs.certain, 0u);
  });
  EXPECT_GT(certain, 20000);
}

TEST(PredicateFilter, CertainSidesOfATetAreThoseOfOrient3dOnHardLines) {
  using testing::point3;
  testing::LineGenerator<testing::InsphereCase> generator(1);
  for (int i = 0; i < 40000; ++i) {
    const auto x = generator.line(static_cast<testing::Family>(i % testing::kFamilies));
    const Point3 a = point3(&x[0]), b = point3(&x[3]), c = point3(&x[6]), d = point3(&x[9]);
    const Point3 p = point3(&x[12]);
    const auto signs = predicate_filter::sides(a, b, c, d, p).signs();
    const int expected[] = {orient3d(b, c, d, p), orient3d(a, d, c, p), orient3d(a, b, d, p),
                            orient3d(a, c, b, p)};
    for (unsigned k = 0; k < 4; ++k)
      if (signs.certain >> k & 1) ASSERT_EQ(expected[k], (signs.negative >> k & 1) ? -1 : 1) << i;
  }
}

TEST(PredicateFilter, SidesThatOverflowAreNotCertain) {
  const Point3 a{1e200, 0, 0}, b{0, 1e200, 0}, c{0, 0, 1e-300}, d{-1e200, -1e200, 1};
  const auto signs = predicate_filter::sides(a, b, c, d, {0, 0, 0}).signs();
  for (unsigned k = 0; k < 4; ++k)
    if (signs.certain >> k & 1)
      EXPECT_TRUE(std::isfinite(predicate_filter::sides(a, b, c, d, {0, 0, 0}).determinant[k]));
  EXPECT_EQ(predicate_filter::sides({1e308, 0, 0}, {-1e308, 1, 0}, {0, 1e308, 1}, {0, 0, 1e308},
                                    {-1e308, 0, 0})
                .signs()
                .certain,
            0u);
}

TEST(PredicateFilter, CertainInsphereEstimatesHaveTheSignOfInsphere) {
  int certain = 0;
  for_random_fives([&](Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) {
    using predicate_filter::difference;
    const auto estimate = predicate_filter::insphere_of_differences(
        difference(a, e), difference(b, e), difference(c, e), difference(d, e));
    if (!estimate.is_certain()) return;
    ++certain;
    EXPECT_EQ(estimate.sign(), predicate_exact::insphere({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y,
                                                          c.z, d.x, d.y, d.z, e.x, e.y, e.z}));
  });
  EXPECT_GT(certain, 3000);
}

}  // namespace
}  // namespace wellspaced
