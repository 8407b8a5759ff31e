#include "wellspaced/algorithms/generate/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wellspaced {
namespace {

std::size_t count_backslashes(const TriangleMesh& mesh, Index nx) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
    if (mesh.triangles[t][2] == mesh.triangles[t][0] + nx) ++count;
  return count;
}

TEST(Grid, TwoByTwoIsTwoTriangles) {
  const auto mesh = generate_grid({.nx = 2, .ny = 2, .aspect = 10}).value();
  EXPECT_EQ(mesh.points, (std::vector<Point2>{{0, 0}, {1, 0}, {0, 10}, {1, 10}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 3}, {0, 3, 2}}));
  EXPECT_EQ(mesh.segments, (std::vector<Segment>{{0, 1, 1}, {1, 3, 2}, {3, 2, 3}, {2, 0, 4}}));
}

TEST(Grid, TrianglesAreCounterClockwiseAndTileTheRectangle) {
  const auto mesh = generate_grid({.nx = 20, .ny = 30, .diagonals = GridDiagonals::kMixed}).value();
  ASSERT_EQ(mesh.triangles.size(), 2u * 19 * 29);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    const double doubled = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    EXPECT_GT(doubled, 0);
    area += doubled / 2;
  }
  EXPECT_EQ(area, 19 * 29);
}

TEST(Grid, SegmentsRunOnceAroundTheBoundary) {
  const auto mesh = generate_grid({.nx = 5, .ny = 4}).value();
  ASSERT_EQ(mesh.segments.size(), 14u);
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
    EXPECT_EQ(mesh.segments[i].b, mesh.segments[(i + 1) % mesh.segments.size()].a);
}

TEST(Grid, DiagonalsFollowTheirRule) {
  const auto backslashes = [](GridDiagonals diagonals, double mixed) {
    const GridOptions options{.nx = 201, .ny = 201, .diagonals = diagonals, .mixed = mixed};
    return count_backslashes(generate_grid(options).value(), 201);
  };
  EXPECT_EQ(backslashes(GridDiagonals::kSlash, 0.5), 0u);
  EXPECT_EQ(backslashes(GridDiagonals::kAlternating, 0.5), 20000u);
  EXPECT_EQ(backslashes(GridDiagonals::kMixed, 0), 0u);
  EXPECT_EQ(backslashes(GridDiagonals::kMixed, 1), 40000u);
  EXPECT_NEAR(static_cast<double>(backslashes(GridDiagonals::kMixed, 0.13)), 5200, 300);
}

TEST(Grid, SeedsDecideMixedDiagonals) {
  const auto triangles = [](std::uint64_t seed) {
    const GridOptions options{.nx = 20, .ny = 20, .diagonals = GridDiagonals::kMixed, .seed = seed};
    return generate_grid(options).value().triangles;
  };
  EXPECT_EQ(triangles(1), triangles(1));
  EXPECT_NE(triangles(1), triangles(2));
}

TEST(Grid, RefusesWhatIsNoGrid) {
  const auto code = [](const GridOptions& options) { return generate_grid(options).error().code; };
  EXPECT_EQ(code({.nx = 1}), ErrorCode::kUsage);
  EXPECT_EQ(code({.ny = 0}), ErrorCode::kUsage);
  EXPECT_EQ(code({.aspect = -1}), ErrorCode::kUsage);
  EXPECT_EQ(code({.aspect = 0.0 / 0.0}), ErrorCode::kUsage);
  EXPECT_EQ(code({.aspect = 1e308}), ErrorCode::kUsage);
  EXPECT_EQ(code({.mixed = 1.5}), ErrorCode::kUsage);
  EXPECT_EQ(code({.nx = 1u << 31, .ny = 4}), ErrorCode::kLimit);
}

}  // namespace
}  // namespace wellspaced
