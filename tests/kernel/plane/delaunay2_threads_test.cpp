// Delaunay2::build by region, on several threads. The preset tsan runs this under ThreadSanitizer.
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/point_families.hpp"
#include "tests/support/triangulation_checks.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"
#include "wellspaced/kernel/point_order.hpp"

namespace wellspaced {
namespace {

using test::PointFamily;

constexpr int kMany = 33000;  // from 2^15 points on there are several regions

std::vector<Point2> joined_points(std::vector<Point2> points, const std::vector<Point2>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

std::vector<PointFamily> large_families() {
  const auto uniform = test::uniform_points(kMany, 1);
  const auto column = [](int n) {
    std::vector<Point2> points;
    for (int i = 0; i < n; ++i) points.push_back({0.5, static_cast<double>(i)});
    return points;
  };
  return {
      {"uniform", uniform},
      {"all ties", test::lattice_points(3 * kMany, 250, 2)},
      {"every point twice", joined_points(uniform, uniform)},
      {"half of them crowded",
       joined_points(test::uniform_points(kMany / 2, 3),
                     test::scaled(test::uniform_points(kMany / 2, 4), -40))},
      {"few distinct points", test::lattice_points(kMany, 4, 5)},
      {"collinear but for the last", joined_points(column(kMany), {{1, 0}})},
      {"a fan over every border", joined_points(column(kMany), {{-1e9, 1}, {1e9, 2}})},
  };
}

Delaunay2 built_on(unsigned threads, const std::vector<Point2>& points) {
  auto result = Delaunay2::build(points, {.threads = threads});
  EXPECT_TRUE(result.ok());
  return result.ok() ? std::move(result).value() : Delaunay2();
}

void expect_same(const Delaunay2& a, const Delaunay2& b) {
  ASSERT_EQ(a.topology().size(), b.topology().size());
  for (Index t = 0; t < a.topology().size(); ++t) {
    ASSERT_EQ(a.topology().vertices(t), b.topology().vertices(t));
    for (unsigned i = 0; i < 3; ++i)
      ASSERT_EQ(a.topology().mirror({t, i}), b.topology().mirror({t, i}));
  }
  for (Index v = 0; v < a.points().size(); ++v) {
    ASSERT_EQ(a.representative(v), b.representative(v));
    ASSERT_EQ(a.edge_from(v), b.edge_from(v));
  }
}

TEST(Delaunay2Threads, ResultIsDelaunayAndDoesNotDependOnTheirNumber) {
  for (const auto& [name, points] : large_families()) {
    SCOPED_TRACE(name);
    const Delaunay2 one = built_on(1, points);
    ASSERT_EQ(one.dimension(), 2);
    EXPECT_TRUE(test::is_constrained_delaunay(one));
    EXPECT_EQ(one.duplicate_count(), points.size() - test::distinct(points));
    expect_same(one, built_on(2, points));
    expect_same(one, built_on(5, points));
  }
}

// Random points have one Delaunay triangulation, whatever order they go in.
TEST(Delaunay2Threads, RegionsMakeTheTrianglesThatOneRegionMakes) {
  const auto points = test::uniform_points(kMany, 6);
  const auto along_curve = hilbert_order(points);
  EXPECT_EQ(test::triangles_of(built_on(2, points)),
            test::triangles_of(*Delaunay2::build(points, along_curve)));
}

TEST(Delaunay2Threads, ConstrainedTriangulationDoesNotDependOnTheirNumber) {
  Pslg graph;
  graph.points = test::uniform_points(kMany, 7);
  for (Index i = 0; i < 40; ++i) graph.segments.push_back({i, i + 40, static_cast<int>(i)});
  const auto one = triangulate(graph, {.threads = 1}), two = triangulate(graph, {.threads = 2});
  ASSERT_TRUE(one.ok() && two.ok());
  expect_same(one->delaunay, two->delaunay);
  EXPECT_EQ(one->in_domain, two->in_domain);
}

}  // namespace
}  // namespace wellspaced
