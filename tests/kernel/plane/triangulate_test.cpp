#include "wellspaced/kernel/plane/triangulate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/cancelling.hpp"
#include "tests/support/point_families.hpp"
#include "tests/support/triangulation_checks.hpp"

namespace wellspaced {
namespace {

// A square of side `size` about (x, y): four points and four segments.
void add_square(Pslg& graph, double x, double y, double size, int marker = 0) {
  const Index first = static_cast<Index>(graph.points.size());
  const double h = size / 2;
  for (const Point2 p : {Point2{x - h, y - h}, {x + h, y - h}, {x + h, y + h}, {x - h, y + h}})
    graph.points.push_back(p);
  for (Index i = 0; i < 4; ++i) graph.segments.push_back({first + i, first + (i + 1) % 4, marker});
}

// Twice the area of the domain.
double area(const PlanarTriangulation& result) {
  double sum = 0;
  const auto& p = result.delaunay.points();
  for (const auto& [a, b, c] : result.triangles())
    sum += (p[b].x - p[a].x) * (p[c].y - p[a].y) - (p[b].y - p[a].y) * (p[c].x - p[a].x);
  return sum;
}

double area(const Pslg& graph, HoleRule rule) {
  TriangulateOptions options;
  options.holes = rule;
  const auto result = triangulate(graph, options);
  EXPECT_TRUE(result.ok());
  EXPECT_TRUE(test::is_constrained_delaunay(result->delaunay));
  return area(*result);
}

// An island in a hole in a square, and a point far away that widens the hull.
Pslg nested_squares() {
  Pslg graph;
  add_square(graph, 0, 0, 6);
  add_square(graph, 0, 0, 4);
  add_square(graph, 0, 0, 2);
  graph.points.push_back({9, 0});
  return graph;
}

TEST(Triangulate, HoleRulesChooseTheDomain) {
  Pslg graph = nested_squares();
  EXPECT_EQ(area(graph, HoleRule::kNone), 2 * (36 + 18));
  EXPECT_EQ(area(graph, HoleRule::kOuter), 2 * 36);
  EXPECT_EQ(area(graph, HoleRule::kParity), 2 * (36 - 16 + 4));
  EXPECT_EQ(area(graph, HoleRule::kSeeds), 2 * 36);
  graph.holes = {{0, 0}};
  EXPECT_EQ(area(graph, HoleRule::kSeeds), 2 * (36 - 4));
  graph.holes = {{1.5, 0}, {100, 100}};
  EXPECT_EQ(area(graph, HoleRule::kSeeds), 2 * (36 - 16 + 4));
}

TEST(Triangulate, WindingNeverMatters) {
  Pslg graph = nested_squares();
  for (std::size_t i = 0; i < graph.segments.size(); i += 2)
    std::swap(graph.segments[i].a, graph.segments[i].b);
  EXPECT_EQ(area(graph, HoleRule::kParity), 2 * (36 - 16 + 4));
}

TEST(Triangulate, OpenPolylinesAndIsolatedPointsInsideAreKept) {
  Pslg graph;
  add_square(graph, 0, 0, 8);
  graph.points.insert(graph.points.end(), {{-1, 0}, {1, 0}, {1, 2}, {3, 3}});
  graph.segments.push_back({4, 5, 7});
  graph.segments.push_back({5, 6, 8});
  const auto result = triangulate(graph);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(area(*result), 2 * 64);
  EXPECT_EQ(result->segments.size(), 6u);
  EXPECT_TRUE(result->delaunay.is_vertex(7));
}

TEST(Triangulate, OverlapsTJunctionsDuplicatesAndZeroLengthAreResolved) {
  Pslg graph;
  graph.points = {{0, 0}, {4, 0}, {2, 0}, {2, 3}, {1, 0}, {3, 0}, {4, 0}};
  graph.segments = {{0, 1, 1}, {2, 3, 2}, {4, 5, 3}, {1, 0, 4}, {3, 3, 5}, {1, 6, 6}};
  TriangulateOptions options;
  options.crossings = CrossingRule::kRefuse;
  const auto result = triangulate(graph, options);
  ASSERT_TRUE(result.ok());
  const std::vector<Segment> expected{{0, 4, 4}, {1, 5, 4}, {2, 3, 2}, {2, 4, 4}, {2, 5, 4}};
  EXPECT_EQ(result->segments, expected);
  EXPECT_EQ(result->added_points, 0u);
}

TEST(Triangulate, CollinearInputHasSegmentsButNoTriangle) {
  Pslg graph;
  graph.points = {{0, 0}, {4, 4}, {2, 2}, {0, 0}};
  graph.segments = {{1, 3, 9}};
  const auto result = triangulate(graph);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->delaunay.dimension(), 1);
  EXPECT_TRUE(result->triangles().empty());
  EXPECT_EQ(result->segments, (std::vector<Segment>{{0, 2, 9}, {1, 2, 9}}));
}

TEST(Triangulate, RefuseListsEveryCrossingPair) {
  Pslg graph;
  graph.points = {{0, 0}, {6, 6}, {0, 6}, {6, 0}, {0, 2}, {6, 2}, {0, -1}, {6, -1}};
  graph.segments = {{0, 1}, {2, 3}, {4, 5}, {6, 7}};
  TriangulateOptions options;
  options.crossings = CrossingRule::kRefuse;
  const auto result = triangulate(graph, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
  EXPECT_EQ(result.error().ids, (std::vector<Index>{0, 1, 0, 2, 1, 2}));
  EXPECT_EQ(result.error().message, "3 pairs of segments cross: 0 and 1, 0 and 2, 1 and 2");
}

// Against all pairs, by orientations alone.
TEST(Triangulate, RefuseAgreesWithAllPairs) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Pslg graph;
    graph.points = test::lattice_points(14, 7, seed);
    graph.points.insert(graph.points.end(), {{-1, -1}, {8, -1}, {3, 9}});
    Random random(seed);
    for (int k = 0; k < 9; ++k)
      graph.segments.push_back(
          {static_cast<Index>(random.below(14)), static_cast<Index>(random.below(14))});
    std::vector<Index> expected;
    const auto& p = graph.points;
    const auto on_path = [&](const Segment& s, const Segment& t) {
      // Whether an input point lies on both: then they meet there and do not cross.
      for (const Point2 q : p)
        if (orient2d(p[s.a], p[s.b], q) == 0 && orient2d(p[t.a], p[t.b], q) == 0) return true;
      return false;
    };
    for (Index i = 0; i < 9; ++i)
      for (Index j = i + 1; j < 9; ++j) {
        const Segment s = graph.segments[i], t = graph.segments[j];
        const int a = orient2d(p[s.a], p[s.b], p[t.a]) * orient2d(p[s.a], p[s.b], p[t.b]);
        const int b = orient2d(p[t.a], p[t.b], p[s.a]) * orient2d(p[t.a], p[t.b], p[s.b]);
        if (a < 0 && b < 0 && !on_path(s, t)) expected.insert(expected.end(), {i, j});
      }
    TriangulateOptions options;
    options.crossings = CrossingRule::kRefuse;
    const auto result = triangulate(graph, options);
    EXPECT_EQ(result.ok(), expected.empty());
    if (!result.ok()) EXPECT_EQ(result.error().ids, expected) << seed;
  }
}

// Segment number s as the chain of its pieces in the result, checked to run from end to end: a walk
// over constrained edges that keep within a rounding error of the segment.
void expect_chain(const PlanarTriangulation& result, const Segment& s) {
  const auto& p = result.delaunay.points();
  const Index end = result.delaunay.representative(s.b);
  std::vector<Index> reached{result.delaunay.representative(s.a)};
  const auto off_line = [&](Index v) {
    const double dx = p[s.b].x - p[s.a].x, dy = p[s.b].y - p[s.a].y;
    const double cross = dx * (p[v].y - p[s.a].y) - dy * (p[v].x - p[s.a].x);
    const double length = std::sqrt(dx * dx + dy * dy),
                 size = std::abs(p[s.a].x) + std::abs(p[s.a].y);
    return std::abs(cross) > length * 0x1p-50 * (size + length);
  };
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const Segment& piece : result.segments)
      for (const auto& [from, to] : {std::pair{piece.a, piece.b}, {piece.b, piece.a}})
        if (from == reached[i] && !off_line(to) &&
            std::find(reached.begin(), reached.end(), to) == reached.end())
          reached.push_back(to);
  EXPECT_NE(std::find(reached.begin(), reached.end(), end), reached.end())
      << "segment " << s.a << '-' << s.b;
}

TEST(Triangulate, CrossingsBecomeVertices) {
  Pslg graph;
  graph.points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}};
  graph.segments = {{0, 1, 1}, {2, 3, 2}};
  const auto result = triangulate(graph);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->added_points, 1u);
  EXPECT_EQ(result->delaunay.points()[4], (Point2{1, 1}));
  EXPECT_EQ(result->segments, (std::vector<Segment>{{0, 4, 1}, {1, 4, 1}, {2, 4, 2}, {3, 4, 2}}));
}

TEST(Triangulate, ConcurrentSegmentsShareOneVertexThatIsNoDouble) {
  // All pass through (1/3, 1/3).
  Pslg graph;
  graph.points = {{0, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0}, {0, 0.5}, {-1, 1}, {1, 0}};
  graph.segments = {{0, 1}, {2, 3}, {4, 5}};
  const auto result = triangulate(graph);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->added_points, 1u);
  EXPECT_NEAR(result->delaunay.points().back().x, 1. / 3, 1e-16);
  EXPECT_EQ(result->segments.size(), 6u);
}

TEST(Triangulate, RandomCrossingsGiveAValidTriangulationWithEverySegmentAChain) {
  int refused = 0, rounded = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Pslg graph;
    graph.points = seed % 3 == 0   ? test::uniform_points(24, seed)
                   : seed % 3 == 1 ? test::lattice_points(24, 9, seed)
                                   : test::one_ulp_neighbours(24, seed);
    for (Index k = 0; k + 1 < 24; k += 2) graph.segments.push_back({k, k + 1});
    const auto result = triangulate(graph);
    ++rounded;
    if (!result.ok()) {
      EXPECT_EQ(result.error().ids.size(), 2u);
      ++refused;
      continue;
    }
    if (result->delaunay.dimension() < 2) continue;
    EXPECT_TRUE(test::is_constrained_delaunay(result->delaunay)) << seed;
    for (const Segment& s : graph.segments) expect_chain(*result, s);
    const auto hull = result->delaunay.hull();
    for (const Index v : hull) {
      const auto bare = Delaunay2::build(graph.points);
      EXPECT_NE(bare->locate(result->delaunay.points()[v]).place, Delaunay2::Place::kOutside);
    }
  }
  EXPECT_LT(50 * refused, rounded);
}

// Four crossings within a hundredth of an ulp on an upright segment: of the five doubles there,
// four in the right order are the only answer (CGAL issue 5080).
TEST(Triangulate, CrossingsFarWithinAnUlpSpreadOverTheDoublesAround) {
  Pslg graph;
  graph.points = {{-1.5617169965001163e-21, -0.005974999999995975},
                  {1.8241074394927896e-06, -0.00598001169397446},
                  {1.824107377290012e-06, -0.005969988306002901},
                  {5.0116939794452514e-06, -0.0059768241074257935},
                  {5.0116939818259595e-06, -0.005973175892580747},
                  {0.0, -0.006},
                  {0.0, -0.00596}};
  graph.segments = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {5, 6}};
  const auto result = triangulate(graph);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_EQ(result->added_points, 4u);
  EXPECT_EQ(result->segments.size(), 13u);
  EXPECT_EQ(result->delaunay.duplicate_count(), 0u);
  EXPECT_TRUE(test::is_constrained_delaunay(result->delaunay));
}

// Segments along nearly one line. Two that rounding bends until they run along input points may
// cross with no crossing at the ends of either piece, as with seed 184.
TEST(Triangulate, CrossingsOfNearlyCollinearSegmentsAreRoundedOrRefused) {
  for (const std::uint64_t seed : {3, 8, 184, 185}) {
    Pslg graph;
    graph.points = test::nearly_collinear_points(24, seed);
    for (Index k = 0; k + 1 < 24; k += 2) graph.segments.push_back({k, k + 1});
    const auto result = triangulate(graph);
    if (result.ok()) {
      EXPECT_TRUE(test::is_constrained_delaunay(result->delaunay)) << seed;
      for (const Segment& s : graph.segments) expect_chain(*result, s);
    } else {
      EXPECT_EQ(result.error().ids.size(), 2u);
    }
  }
}

// K12 on a lattice circle: every pair of 12 cocircular points, many of them concurrent.
TEST(Triangulate, CompleteGraphOnALatticeCircleHasTheKnownNumberOfCrossings) {
  Pslg graph;
  for (const Point2 p : {Point2{5, 0},
                         {4, 3},
                         {3, 4},
                         {0, 5},
                         {-3, 4},
                         {-4, 3},
                         {-5, 0},
                         {-4, -3},
                         {-3, -4},
                         {0, -5},
                         {3, -4},
                         {4, -3}})
    graph.points.push_back(p);
  for (Index i = 0; i < 12; ++i)
    for (Index j = i + 1; j < 12; ++j) graph.segments.push_back({i, j});
  const auto result = triangulate(graph);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_TRUE(test::is_constrained_delaunay(result->delaunay));
  EXPECT_LT(result->added_points, 495u);  // 12 over 4, were no three concurrent
  for (const Segment& s : graph.segments) expect_chain(*result, s);
}

TEST(Triangulate, ASegmentWithoutPointIsAnErrorThatNamesIt) {
  Pslg graph;
  graph.points = {{0, 0}, {1, 0}, {0, 1}};
  graph.segments = {{0, 1}, {2, 3}};
  const auto result = triangulate(graph);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().ids, std::vector<Index>{1});
}

TEST(Triangulate, CanBeCancelledInEveryPhase) {
  const auto phases = test::phases_that_cancel([](const Progress& progress) {
    return triangulate(nested_squares(), {.progress = progress});
  });
  EXPECT_EQ(phases, (std::set<std::string>{"constrain", "domain", "triangulate"}));
}

// Random segments that cross each other hundreds of times; then the same on doubles so large that
// they have to be bent apart.
TEST(Triangulate, CanBeCancelledWhileCrossingsAreSplit) {
  for (const double origin : {0.0, 0x1p52}) {
    Pslg graph;
    graph.points = test::uniform_points(100, 7);
    for (Point2& p : graph.points) p = {origin + 100 * p.x, origin + 100 * p.y};
    for (Index s = 0; s < 50; ++s) graph.segments.push_back({2 * s, 2 * s + 1});
    const auto phases = test::phases_that_cancel(
        [&](const Progress& progress) { return triangulate(graph, {.progress = progress}); });
    EXPECT_TRUE(phases.count("cross") == 1 && phases.count("split") == 1);
    EXPECT_EQ(phases.count("bend"), origin == 0 ? 0u : 1u);
  }
}

TEST(Delaunay2Build, CanBeCancelledOnTheWay) {
  const std::vector<Point2> points = test::uniform_points(50000, 1);
  int questions = 0;
  test::phases_that_cancel([&](const Progress& progress) {
    return Delaunay2::build(points, {[&](auto phase, auto done, auto total) {
                              ++questions;
                              return progress(phase, done, total);
                            }});
  });
  EXPECT_GE(questions, 20);
}

}  // namespace
}  // namespace wellspaced
