#include "wellspaced/kernel/plane/bend_chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/triangulation_checks.hpp"

namespace wellspaced {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

constexpr double kUlp = 0x1p-52;

Edges sorted(Edges edges) {
  for (auto& e : edges) std::sort(e.begin(), e.end());
  std::sort(edges.begin(), edges.end());
  return edges;
}

TEST(BendChains, LaysWhatDoesNotCrossAsItIs) {
  Delaunay2 dt = *Delaunay2::build(std::vector<Point2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}});
  const std::vector<Segment> segments{{0, 2}, {1, 3}};
  const auto edges = bend_chains(dt, segments, {{0, 4, 2}, {1, 4, 3}});
  ASSERT_TRUE(edges.ok());
  EXPECT_EQ(sorted((*edges)[0]), (Edges{{0, 4}, {2, 4}}));
  EXPECT_EQ(sorted((*edges)[1]), (Edges{{1, 4}, {3, 4}}));
}

// The upper segment's vertex was rounded down across the lower segment, by an ulp.
TEST(BendChains, BendsASegmentThroughTheVertexThatWasRoundedAcrossIt) {
  const std::vector<Point2> points{{1, 1},        {3, 1},    // the lower segment
                                   {1, 1.5},      {3, 1.5},  // the ends of the upper one
                                   {2, 1 - kUlp}, {2, 0},   {2, 3}};
  Delaunay2 dt = *Delaunay2::build(points);
  const auto edges = bend_chains(dt, std::vector<Segment>{{0, 1}, {2, 3}}, {{0, 1}, {2, 4, 3}});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  EXPECT_EQ(sorted((*edges)[0]), (Edges{{0, 4}, {1, 4}}));
  EXPECT_EQ(sorted((*edges)[1]), (Edges{{2, 4}, {3, 4}}));
  EXPECT_TRUE(test::is_constrained_delaunay(dt));
}

TEST(BendChains, BendsWhatWasLaidBeforeAsWell) {
  const std::vector<Point2> points{{1, 1},        {3, 1}, {1, 1.5}, {3, 1.5},
                                   {2, 1 - kUlp}, {2, 0}, {2, 3}};
  Delaunay2 dt = *Delaunay2::build(points);
  const auto edges =
      bend_chains(dt, std::vector<Segment>{{2, 3}, {0, 1}, {0, 1}}, {{2, 4, 3}, {0, 1}, {1, 0}});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  EXPECT_EQ(sorted((*edges)[1]), (Edges{{0, 4}, {1, 4}}));
  EXPECT_EQ(sorted((*edges)[2]), (Edges{{0, 4}, {1, 4}}));
}

TEST(BendChains, VerticesThatBecameOneAreOne) {
  const std::vector<Point2> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 2}};
  Delaunay2 dt = *Delaunay2::build(points);
  const auto edges = bend_chains(dt, std::vector<Segment>{{0, 2}}, {{0, 4, 5, 2}});
  ASSERT_TRUE(edges.ok());
  EXPECT_EQ(sorted((*edges)[0]), (Edges{{0, 4}, {2, 4}}));
}

TEST(BendChains, SegmentsThatCrossFarFromAnyVertexAreAnError) {
  Delaunay2 dt =
      *Delaunay2::build(std::vector<Point2>{{0, 0}, {4, 4}, {0, 4}, {4, 0}, {9, 9}, {8, 9}});
  const auto edges =
      bend_chains(dt, std::vector<Segment>{{4, 5}, {0, 1}, {2, 3}}, {{4, 5}, {0, 1}, {2, 3}});
  ASSERT_FALSE(edges.ok());
  EXPECT_EQ(edges.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(edges.error().ids, (std::vector<Index>{2, 1}));
}

}  // namespace
}  // namespace wellspaced
