// Several hundred small inputs of the kinds that break triangulators, each beside the truth, which
// is found by trying everything in the tests' own integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/point_families.hpp"
#include "tests/support/slow_plane.hpp"
#include "tests/support/triangulation_checks.hpp"
#include "wellspaced/kernel/plane/triangulate.hpp"

namespace wellspaced {
namespace {

using testing::SlowArrangement;
using testing::SlowPoints;
using Points = std::vector<Point2>;

// ---- Points ------------------------------------------------------------------------------------

void check_points(const std::string& name, const Points& points) {
  SCOPED_TRACE(name);
  const SlowPoints truth(points);
  const auto built = Delaunay2::build(points);
  ASSERT_TRUE(built.ok());
  EXPECT_EQ(built->dimension(), truth.dimension());
  for (Index i = 0; i < points.size(); ++i)
    EXPECT_EQ(built->representative(i), truth.representative(i)) << i;
  const auto triangles = test::triangles_of(*built);
  if (truth.dimension() < 2) {
    EXPECT_TRUE(triangles.empty());
    return;
  }
  EXPECT_TRUE(built->is_valid());
  EXPECT_EQ(triangles.size(), 2 * truth.distinct().size() - 2 - truth.hull_size());
  EXPECT_EQ(built->hull().size(), truth.hull_size());
  std::set<std::vector<Index>> cells;
  for (const auto& [a, b, c] : triangles) {
    EXPECT_GT(truth.turn(a, b, c), 0);
    cells.insert(truth.empty_circle(a, b, c));
  }
  EXPECT_EQ(cells, truth.delaunay_cells());
}

// Whole numbers up to 9 in magnitude, so that all of these can be scaled without rounding.
std::vector<test::PointFamily> whole_number_families() {
  std::vector<test::PointFamily> families = {
      {"grid", {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}},
      {"circle", {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, -3}, {3, -4}, {4, -3}}},
      {"line and one", {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {5, 5}, {7, 7}, {9, 9}, {0, 1}}},
      {"line", {{3, 6}, {1, 2}, {2, 4}, {0, 0}, {1, 2}, {4, 8}}},
      {"copies", {{1, 1}, {0, 3}, {1, 1}, {4, 0}, {0, 3}, {4, 0}, {1, 1}}},
      {"one place", {{2, 7}, {2, 7}, {2, 7}}},
      {"zeros", {{0., 0.}, {-0., 0.}, {0., -0.}, {-0., -0.}, {1, 0}, {0, 1}}},
      {"needle", {{0, 0}, {9, 0}, {9, 1}, {1, 0}, {8, 1}}},
      {"parabola", {{-3, 9}, {-2, 4}, {-1, 1}, {0, 0}, {1, 1}, {2, 4}, {3, 9}}},
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    families.push_back({"random " + std::to_string(seed), test::lattice_points(9, 8, seed)});
  return families;
}

// From the least subnormal to the largest doubles; around the ends of Shewchuk's windows, too.
constexpr int kScales[] = {-1074, -1073, -1050, -1022, -1000, -700, -537, -485, -300, -216, -162,
                           -53,   0,     52,    201,   253,   509,  511,  640,  900,  1000, 1019};

TEST(PlaneCorpus, TriangulatesPointsAtEveryScale) {
  int count = 0;
  for (const auto& [name, points] : whole_number_families())
    for (const int scale : kScales) {
      check_points(name + " times 2^" + std::to_string(scale), test::scaled(points, scale));
      ++count;
    }
  EXPECT_GE(count, 250);
}

// Neighbouring scales meet in one input: bits span the whole range of doubles.
TEST(PlaneCorpus, TriangulatesPointsOfSeveralScalesAtOnce) {
  for (const int low : {-1074, -600, -60})
    for (const int high : {0, 60, 1019})
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        Points points = test::scaled(test::lattice_points(4, 8, seed), low);
        for (const Point2 p : test::scaled(test::lattice_points(4, 8, seed + 9), high))
          points.push_back(p);
        check_points(std::to_string(low) + " and " + std::to_string(high), points);
      }
}

// L. Kettner, K. Mehlhorn, S. Pion, S. Schirra and C. Yap, Classroom examples of robustness
// problems in geometric computations (2008): a point in the grid of doubles about (1/2, 1/2), and
// two far along the diagonal.
TEST(PlaneCorpus, TriangulatesPointsOfTheClassroom) {
  for (const auto& [q, r] :
       {std::pair{Point2{12, 12}, Point2{24, 24}},
        {{17.300000000000001, 17.300000000000001}, {24.00000000000005, 24.0000000000000517765}},
        {{8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}}})
    for (int k = 0; k < 32; ++k) {
      const Point2 p{0.5 + k % 8 * 0x1p-53, 0.5 + k / 8 * 0x1p-53};
      check_points("k = " + std::to_string(k), {p, q, r, {0.5, 0.5}, {24, 6}});
    }
  check_points("a hull that loses its leftmost point", {{7.3000000000000194, 7.3000000000000167},
                                                        {24.000000000000068, 24.000000000000071},
                                                        {24.00000000000005, 24.000000000000053},
                                                        {0.50000000000001621, 0.50000000000001243},
                                                        {8, 4},
                                                        {4, 9},
                                                        {15, 27},
                                                        {26, 25},
                                                        {19, 11}});
}

TEST(PlaneCorpus, TriangulatesPointsAnUlpApart) {
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    check_points("seed " + std::to_string(seed), test::one_ulp_neighbours(9, seed));
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    check_points("line " + std::to_string(seed), test::nearly_collinear_points(9, seed));
}

TEST(PlaneCorpus, TriangulatesNeedles) {
  for (int k = 1; k <= 52; k += 3) {
    const double length = std::ldexp(1, k), up = std::nextafter(1, 2);
    check_points("flat " + std::to_string(k),
                 {{0, 0}, {length, 1}, {length, up}, {length / 2, 0.5}, {-length, -1}});
    check_points("fan " + std::to_string(k),
                 {{0, 0}, {length, 0}, {length, 0x1p-1074}, {length, -0x1p-1074}, {1, 0x1p-1074}});
  }
}

// ---- Segments ----------------------------------------------------------------------------------

// What became of the graphs of one test.
struct Outcomes {
  int rounded = 0, exact_topology = 0, bent = 0, refused = 0;
};

// Whether a crossing, which are the points behind those of the graph, lies outside their hull.
bool some_beyond_hull(const Pslg& graph, const Points& points) {
  const std::size_t n = graph.points.size();
  std::vector<testing::SlowPoint> p;
  for (const Point2 q : points) p.push_back(testing::slow_point(q));
  for (std::size_t u = 0; u < n; ++u)
    for (std::size_t v = 0; v < n; ++v) {
      const auto left = [&](const auto& w) { return testing::slow_turn(p[u], p[v], w) >= 0; };
      const auto added = p.begin() + static_cast<std::ptrdiff_t>(n);
      if (!std::all_of(added, p.end(), left) && std::all_of(p.begin(), added, left)) return true;
    }
  return false;
}

// Every segment is a chain of constrained edges whose vertices lie within two units in the last
// place of it: all that can be reached from one end over such vertices holds the other.
void check_chains(const Pslg& graph, const PlanarTriangulation& result) {
  const std::vector<Point2>& p = result.delaunay.points();
  for (const Segment& s : graph.segments) {
    std::set<Index> reached{result.delaunay.representative(s.a)};
    for (std::size_t before = 0; before < reached.size();) {
      before = reached.size();
      for (const Segment& piece : result.segments)
        if (reached.count(piece.a) != reached.count(piece.b))
          for (const Index v : {piece.a, piece.b})
            if (testing::slow_passes_near(p[s.a], p[s.b], p[v])) reached.insert(v);
    }
    EXPECT_TRUE(reached.count(result.delaunay.representative(s.b))) << s.a << '-' << s.b;
  }
}

void check_split(const Pslg& graph, const SlowArrangement& truth, Outcomes& outcomes) {
  TriangulateOptions options;
  options.holes = HoleRule::kNone;
  const auto result = triangulate(graph, options);
  outcomes.rounded += !truth.crossings.empty();
  if (!result.ok()) {
    ++outcomes.refused;
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidGeometry);
    EXPECT_FALSE(truth.crossings.empty());
    return;
  }
  const Delaunay2& dt = result->delaunay;
  const SlowPoints input(graph.points);
  ASSERT_EQ(dt.points().size(), graph.points.size() + truth.crossings.size());
  EXPECT_EQ(dt.dimension(), input.dimension());
  for (std::size_t k = 0; k < truth.crossings.size(); ++k) {
    const Point2 p = dt.points()[graph.points.size() + k];
    const auto& [x, y, w] = truth.crossings[k];
    EXPECT_TRUE(testing::is_within_two_ulp(p.x, x, w)) << k;
    EXPECT_TRUE(testing::is_within_two_ulp(p.y, y, w)) << k;
  }
  if (dt.dimension() == 2) {
    EXPECT_TRUE(test::is_constrained_delaunay(dt));
    std::vector<Index> hull = dt.hull();
    std::erase_if(hull, [&](Index v) { return v >= graph.points.size(); });
    // A crossing may have been rounded onto the hull, or beyond it where no double inside is near.
    EXPECT_TRUE(hull.size() == input.hull_size() || some_beyond_hull(graph, dt.points()));
  }
  std::vector<std::array<Index, 2>> pieces;
  for (const Segment& s : result->segments) pieces.push_back({s.a, s.b});
  if (pieces == truth.pieces) {
    ++outcomes.exact_topology;
  } else {
    ++outcomes.bent;
    check_chains(graph, *result);
  }
}

void check_refuse(const Pslg& graph, const SlowArrangement& truth) {
  TriangulateOptions options;
  options.crossings = CrossingRule::kRefuse;
  const auto result = triangulate(graph, options);
  EXPECT_EQ(result.ok(), truth.pairs.empty());
  if (!result.ok()) {
    EXPECT_EQ(result.error().ids, truth.pairs);
  }
}

void check_graph(const std::string& name, const Pslg& graph, Outcomes& outcomes) {
  SCOPED_TRACE(name);
  const SlowArrangement truth(graph);
  check_split(graph, truth, outcomes);
  check_refuse(graph, truth);
}

// Segments between the points two by two.
Pslg paired(Points points) {
  Pslg graph;
  graph.points = std::move(points);
  for (Index i = 0; i + 1 < graph.points.size(); i += 2) graph.segments.push_back({i, i + 1});
  return graph;
}

Pslg complete(Points points) {
  Pslg graph;
  graph.points = std::move(points);
  for (Index i = 0; i < graph.points.size(); ++i)
    for (Index j = i + 1; j < graph.points.size(); ++j) graph.segments.push_back({i, j});
  return graph;
}

Pslg scaled(Pslg graph, int exponent) {
  graph.points = test::scaled(std::move(graph.points), exponent);
  return graph;
}

// Two segments cross at (1/3, 1/3); the third passes it by some units in the last place.
TEST(PlaneCorpus, TellsSegmentsThatNearlyMeetAtThirdsApart) {
  Outcomes outcomes;
  for (int up = -5; up <= 5; ++up)
    for (int right = -5; right <= 5; ++right) {
      const Point2 from{1 + right * 0x1p-52, 0}, to{0, 0.5 + up * 0x1p-53};
      check_graph(std::to_string(up) + ' ' + std::to_string(right),
                  paired({{0, 0}, {1, 1}, {0, 1}, {0.5, 0}, from, to}), outcomes);
    }
  EXPECT_EQ(outcomes.exact_topology, 121);
}

TEST(PlaneCorpus, SplitsCompleteGraphsOnALatticeCircle) {
  Outcomes outcomes;
  const Points circle = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                         {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  for (std::size_t n = 4; n <= 8; ++n)
    for (const int scale : {-1000, -300, 0, 1, 300, 1019})
      check_graph("K" + std::to_string(n) + " times 2^" + std::to_string(scale),
                  scaled(complete(Points(circle.begin(), circle.begin() + n)), scale), outcomes);
  check_graph("K12", complete(circle), outcomes);
  EXPECT_EQ(outcomes.exact_topology, 31);
}

// Segments between whole numbers through a common point that is none, nor a double.
TEST(PlaneCorpus, SplitsConcurrentSegmentsAtOneVertex) {
  Outcomes outcomes;
  Random random(1);
  for (const int q : {3, 5, 7, 11, 13})
    for (int count = 3; count <= 8; ++count)
      for (const int scale : {-900, 0, 900}) {
        const double px = static_cast<double>(random.below(q)) + q, py = px + 1;
        Points points;
        for (int i = 0; i < count; ++i) {
          const double x = static_cast<double>(random.below(9)) - 4;
          const double y = static_cast<double>(random.below(9)) - 4;
          points.push_back({x, y});
          points.push_back({x + 2 * (px - q * x), y + 2 * (py - q * y)});
        }
        check_graph("over " + std::to_string(q), scaled(paired(points), scale), outcomes);
      }
  EXPECT_LT(20 * (outcomes.refused + outcomes.bent), outcomes.rounded);
}

TEST(PlaneCorpus, SplitsSegmentsBetweenLatticePointsAtSeveralScales) {
  Outcomes outcomes;
  for (std::uint64_t seed = 0; seed < 24; ++seed)
    for (const int scale : {-1000, -400, 0, 400, 1015})
      check_graph("seed " + std::to_string(seed),
                  scaled(paired(test::lattice_points(16, 9, seed)), scale), outcomes);
  EXPECT_EQ(outcomes.refused + outcomes.bent, 0);
}

// Far below the normal range the doubles are as coarse as the input: rounding must bend or refuse.
TEST(PlaneCorpus, SegmentsAmongTheLeastDoublesAreRoundedOrRefused) {
  Outcomes outcomes;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    check_graph("seed " + std::to_string(seed),
                scaled(paired(test::lattice_points(10, 30, seed)), -1074), outcomes);
  EXPECT_LT(10 * outcomes.refused, outcomes.rounded);
}

TEST(PlaneCorpus, SplitsSegmentsAnUlpApart) {
  Outcomes outcomes;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    check_graph("seed " + std::to_string(seed), paired(test::one_ulp_neighbours(16, seed)),
                outcomes);
  EXPECT_LT(10 * outcomes.refused, outcomes.rounded);
}

// Long segments along one line, which keep their order by less than the doubles can tell.
TEST(PlaneCorpus, SplitsSegmentsNearlyAlongOneLine) {
  const auto moved = [](Points points, double slope, double up) {
    for (Point2& p : points) p.y = p.x * slope + up;
    return points;
  };
  Outcomes outcomes;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (const int n : {12, 20}) {
      const Points line = test::nearly_collinear_points(n, seed);
      const std::string name = std::to_string(n) + " points, seed " + std::to_string(seed);
      check_graph("a third: " + name, paired(line), outcomes);
      check_graph("off the origin: " + name, paired(moved(line, 0.7, 0.1)), outcomes);
      check_graph("hardly rising: " + name, paired(moved(line, 0x1p-50, 1)), outcomes);
    }
  EXPECT_GE(outcomes.rounded, 50);
  EXPECT_GE(outcomes.bent, 10);
  EXPECT_EQ(outcomes.refused, 0);
}

// As many segments as fit between the doubles of a few cells.
TEST(PlaneCorpus, SplitsSegmentsCrowdedInAFewUlps) {
  Outcomes outcomes;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    check_graph("ulps: " + name, paired(test::one_ulp_neighbours(32, seed)), outcomes);
    check_graph("least: " + name, scaled(paired(test::lattice_points(28, 9, seed)), -1074),
                outcomes);
  }
  EXPECT_GE(outcomes.bent, 4);
  EXPECT_EQ(outcomes.refused, 0);
}

// A fan of needles across an upright segment, its apex ever nearer to it.
TEST(PlaneCorpus, SplitsASegmentUnderNeedles) {
  Outcomes outcomes;
  for (int k = 10; k <= 70; k += 5) {
    const double left = -std::ldexp(1, -k);
    check_graph("2^-" + std::to_string(k),
                paired({{left, 1}, {1, 0}, {left, 1}, {1, 2}, {left, 1}, {1, 0.5}, {0, 0}, {0, 3}}),
                outcomes);
  }
  for (int k = 10; k <= 50; k += 5) {
    const double length = std::ldexp(1, k);
    check_graph("2^" + std::to_string(k),
                paired({{0, 0}, {length, 1}, {0, 1}, {length, 0.5}, {0, 0.5}, {length, 0.75}}),
                outcomes);
  }
  EXPECT_EQ(outcomes.refused, 0);
}

// The sides of the classroom's polygons, which hardly turn.
TEST(PlaneCorpus, SplitsSegmentsOfTheClassroom) {
  Outcomes outcomes;
  for (int k = 0; k < 32; ++k) {
    const Point2 p{0.5 + k % 8 * 0x1p-53, 0.5 + k / 8 * 0x1p-53};
    Pslg graph;
    graph.points = {p, {12, 12}, {24, 24}, {0.5, 0.5}, {24, 6}, {6, 24}};
    graph.segments = {{0, 1}, {1, 2}, {2, 0}, {3, 2}, {4, 5}, {0, 4}, {3, 5}};
    check_graph("k = " + std::to_string(k), graph, outcomes);
  }
  EXPECT_EQ(outcomes.refused, 0);
}

}  // namespace
}  // namespace wellspaced
