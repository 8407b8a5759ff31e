#include "wellspaced/kernel/space/bulk_insertion3.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/delaunay3_checks.hpp"
#include "tests/support/points3.hpp"
#include "wellspaced/kernel/space/delaunay3.hpp"

namespace wellspaced {
namespace {

using test::PointSet3;

std::vector<Point3> joined(std::vector<Point3> points, const std::vector<Point3>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

// Large enough that regions are filled at the same time: at least 2^15 points.
std::vector<PointSet3> large_sets() {
  const auto uniform = test::uniform3(33000, 1);
  return {
      {"uniform", uniform},
      {"lattice, all ties", test::lattice3(33, 33, 33)},
      {"near a sphere", test::rounded_sphere3(33000, 2)},
      {"every point twice", joined(test::uniform3(17000, 3), test::uniform3(17000, 3))},
      {"half of them crowded",
       joined(test::uniform3(17000, 5), test::scaled(test::uniform3(17000, 4), 0x1p-30))},
      // 7 tets a point do not do for the lines.
      {"more tets than foreseen", joined(uniform, test::skew_lines3(300))},
  };
}

Delaunay3 built(const std::vector<Point3>& points, unsigned threads) {
  auto result = Delaunay3::build(points, {.threads = threads});
  EXPECT_TRUE(result.ok());
  return result.ok() ? std::move(result).value() : Delaunay3();
}

bool have_same_tets(const Triangulation3& a, const Triangulation3& b) {
  if (a.size() != b.size()) return false;
  for (Index t = 0; t < a.size(); ++t)
    if (a.vertices(t) != b.vertices(t) || a.links(t) != b.links(t)) return false;
  return true;
}

TEST(BulkInsertion3, ResultDoesNotDependOnTheNumberOfThreads) {
  for (const auto& [name, points] : large_sets()) {
    SCOPED_TRACE(name);
    ASSERT_GT(BulkInsertion3::region_count(points.size()), 1u);
    const Delaunay3 one = built(points, 1);
    const Delaunay3 two = built(points, 2);
    EXPECT_TRUE(have_same_tets(one.topology(), two.topology()));
    EXPECT_EQ(one.triangles(), two.triangles());
    EXPECT_EQ(one.duplicate_count(), two.duplicate_count());
    for (Index v = 0; v < points.size(); ++v) {
      ASSERT_EQ(one.tet_of(v), two.tet_of(v));
      ASSERT_EQ(one.representative(v), two.representative(v));
    }
  }
}

TEST(BulkInsertion3, ThreadsWithoutARegionChangeNothing) {
  const auto points = test::uniform3(33000, 9);
  EXPECT_TRUE(have_same_tets(built(points, 2).topology(), built(points, 7).topology()));
  EXPECT_TRUE(have_same_tets(built(points, 2).topology(), built(points, 0).topology()));
}

TEST(BulkInsertion3, RegionsMakeOneDelaunayTriangulation) {
  for (const auto& [name, points] : large_sets()) {
    SCOPED_TRACE(name);
    const Delaunay3 d = built(points, 2);
    test::expect_locally_delaunay(d);
    test::expect_all_points_used(d);
  }
}

TEST(BulkInsertion3, CoplanarPointsGiveTheTrianglesOfTheirLattice) {
  const Delaunay3 d = built(test::lattice3(1, 190, 190), 2);
  EXPECT_EQ(d.dimension(), 2);
  EXPECT_EQ(d.triangles().size(), 2u * 189 * 189);
}

TEST(BulkInsertion3, ObeysTheLimitOfTets) {
  const auto points = test::uniform3(33000, 1);
  const Index tets = built(points, 2).topology().size();
  EXPECT_TRUE(Delaunay3::build(points, {.max_tets = 8 * 33000, .threads = 2}).ok());
  EXPECT_TRUE(Delaunay3::build(points, {.max_tets = tets + 100, .threads = 2}).ok());
  const auto refused = Delaunay3::build(points, {.max_tets = tets / 2, .threads = 2});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kLimit);
}

TEST(BulkInsertion3, CanBeCancelledAtEveryWordToTheListener) {
  const auto points = test::uniform3(33000, 1);
  int words = 0;
  const auto count = [&words](std::string_view, std::uint64_t done, std::uint64_t total) {
    EXPECT_LE(done, total);
    return ++words > 0;
  };
  ASSERT_TRUE(Delaunay3::build(points, {.progress = count, .threads = 2}).ok());
  ASSERT_GT(words, 5);
  for (int limit = 0; limit < words; ++limit) {
    int heard = 0;
    const auto stop = [&](std::string_view, std::uint64_t, std::uint64_t) {
      return ++heard <= limit;
    };
    const auto result = Delaunay3::build(points, {.progress = stop, .threads = 2});
    ASSERT_FALSE(result.ok()) << limit;
    EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace wellspaced
